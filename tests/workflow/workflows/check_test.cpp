#include "scratch_directory.hpp"
#include "sdpd_scene.hpp"
#include "soft_scene.hpp"
#include "workflows/command/list.hpp"
#include "workflows/command_line.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/text_file.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

// `check` is as strict as `run`: what one refuses the other refuses in the same words.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

std::string const sdpd = tests::ideal_gas_scene("equilibrate = 16\nsteps = 320\n").text();
tests::SoftScene const dpde{.run = "sample_every = 2\nequilibrate = 8\nsteps = 64\n"};

struct Outcome {
  int code;
  std::string errors;
};

Outcome outcome(std::vector<std::string> words, std::vector<std::string> const& sets) {
  for (auto const& set : sets)
    words.insert(words.end(), {"--set", set});
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  int const code = run_command_line(words, commands());
  testing::internal::GetCapturedStdout();
  return {code, testing::internal::GetCapturedStderr()};
}

class CheckAndRun : public testing::Test {
 protected:
  CheckAndRun() {
    write_text_file(scratch_ / "sdpd.toml", sdpd);
    write_text_file(scratch_ / "dpde.toml", dpde.text());
    auto table = dpde;
    table.potential = "name = \"table\"\nfile = \"words.csv\"\n";
    write_text_file(scratch_ / "table.toml", table.text());
    write_text_file(scratch_ / "empty.toml", "");
    write_text_file(scratch_ / "empty.csv", "");
    write_text_file(scratch_ / "words.csv", "r,u\n0.1,3\n0.2,two\n0.3,1\n0.4,0\n");
    write_text_file(scratch_ / "backwards.csv", "r,gamma_par\n1,0\n0.5,2\n0,4.5\n");
    write_text_file(scratch_ / "columns.csv", "x,y\n0,1\n1,0\n2,0\n");
  }

  std::string scene(std::string const& name) const { return (scratch_ / (name + ".toml")).string(); }

  Outcome checked(std::string const& name, std::vector<std::string> const& sets) const {
    return outcome({"check", scene(name)}, sets);
  }
  Outcome ran(std::string const& name, std::vector<std::string> const& sets) const {
    return outcome({"run", scene(name), "-o", folder().string(), "--quiet", "--threads", "1"}, sets);
  }
  std::filesystem::path folder() const { return scratch_ / "out"; }

  ScratchDirectory scratch_;
};

TEST_F(CheckAndRun, RefuseTheSameInTheSameWords) {
  struct Case {
    std::string scene;
    std::vector<std::string> sets;
    std::string message;
    int code = 2;
  };
  std::vector<Case> const cases{
      {"sdpd", {"run.sample_every=96"}, "run.steps"},
      {"sdpd", {"run.sample_every=11"}, "352"},
      {"sdpd", {"run.sample_every=9223372036854775807"}, "run.sample_every"},
      {"sdpd", {"run.instant_every=100"}, "run.instant_every"},
      {"sdpd", {"run.steps=31", "run.sample_every=1"}, "must be at least 32"},
      {"sdpd", {"profile.every=321"}, "profile.every"},
      {"sdpd", {"histogram.every=10", "histogram.quantities=[\"charge\"]"}, "charge"},
      {"sdpd", {"particles.N=125"}, "216"},
      {"sdpd", {"particles.N=127"}, "216"},
      {"sdpd", {"particles.N=997"}, "three similar factors"},
      {"sdpd", {"particles.N=343", "particles.h_factor=4"}, "729"},
      {"sdpd", {"particles.h_factor=10"}, "particles.N"},
      {"sdpd", {"particles.K=1"}, "particles.K"},
      {"sdpd", {"fluid.eos=missing.toml"}, "missing.toml"},
      {"sdpd", {"fluid.eos=empty.toml"}, "fluid.m0"},
      {"sdpd", {"fluid.eos=argn"}, "argon"},
      {"sdpd", {"transport.zeta=1 Pa*s"}, "zeta"},
      {"sdpd", {"transport.eta=1e308 Pa*s", "fluid.T=1e-300 K"}, ""},
      {"sdpd", {"fluid.rho=1e-300 kg/m^3", "particles.K=1e300"}, ""},
      {"sdpd", {"particles.density=given"}, "density_scale"},
      {"sdpd", {"scheme.dt=auto"}, "needs a tolerance"},
      {"sdpd", {"scheme.dt=auto", "scheme.bias=twice"}, "scheme.bias"},
      {"sdpd", {"scheme.dt=auto", "scheme.bias=\"1%\"", "particles.N=216"}, "343"},
      {"sdpd", {"scheme.dt=1e-300 s"}, "scheme.dt"},
      {"sdpd", {"method.name=sph", "scheme.name=ems"}, "noise"},
      {"dpde", {"particles.N=8"}, "particles.N"},
      {"dpde", {"friction.cutoff=1e-300"}, "cut-off"},
      {"dpde", {"friction.cutoff=1e300"}, ""},
      {"dpde", {"potential.cutoff=1e300"}, ""},
      {"dpde", {"fluid.rho=1e300"}, ""},
      {"table", {"potential.file=empty.csv"}, "empty.csv"},
      {"table", {"potential.file=words.csv"}, "words.csv"},
      {"table", {"potential.file=columns.csv"}, "columns.csv"},
      {"dpde", {"potential.name=lj"}, "potential."},
      {"dpde", {"friction.file=backwards.csv"}, "friction.file"},
      {"dpde", {"conduction.file=columns.csv"}, "columns.csv"},
      {"dpde", {"conduction.cutoff=2"}, "conduction.kappa"},
      {"dpde", {"internal_energy.model=empty.toml"}, "internal_energy"},
      {"dpde", {"method.name=dpd"}, "internal_energy"},
      {"dpde", {"friction.cutof=1"}, "did you mean 'cutoff'"},
  };
  int ran_cases = 0;
  for (auto const& [name, sets, message, code] : cases) {
    auto const check = checked(name, sets), run = ran(name, sets);
    auto const what = fmt::format("{} {}\n", name, sets.front());
    EXPECT_EQ(check.code, code) << what << check.errors;
    EXPECT_EQ(run.code, code) << what << run.errors;
    EXPECT_EQ(check.errors, run.errors) << what;
    EXPECT_NE(check.errors.find(message), std::string::npos) << what << check.errors;
    EXPECT_FALSE(std::filesystem::exists(folder())) << what;
    ++ran_cases;
  }
  EXPECT_EQ(ran_cases, 40);
}

TEST_F(CheckAndRun, TakeTheSameAtTheBounds) {
  struct Case {
    std::string scene;
    std::vector<std::string> sets;
  };
  std::vector<Case> const cases{
      {"sdpd", {"run.sample_every=10"}},
      {"sdpd", {"run.steps=32", "run.sample_every=1", "run.instant_every=2"}},
      {"sdpd", {"particles.N=216"}},
      {"sdpd", {"particles.N=252"}}, // 6 x 6 x 7
      {"dpde", {"particles.N=125"}},
      {"dpde", {"friction.cutoff=1e-4", "potential.cutoff=1e-4", "particles.N=8"}},
  };
  int ran_cases = 0;
  for (auto const& [name, sets] : cases) {
    auto const check = checked(name, sets), run = ran(name, sets);
    EXPECT_EQ(check.code, 0) << name << " " << sets.front() << "\n" << check.errors;
    EXPECT_EQ(run.code, 0) << name << " " << sets.front() << "\n" << run.errors;
    std::filesystem::remove_all(folder());
    ++ran_cases;
  }
  EXPECT_EQ(ran_cases, 6);
}

/// Every key at values that users mistype: whatever `check` refuses `run` refuses alike.
TEST_F(CheckAndRun, AgreeOnEveryKeyAtOddValues) {
  int refused = 0, tried = 0;
  for (auto const& key : scene_keys())
    for (std::string const value : {"-1", "0", "nan", "inf", "true", "[]", "\"\"", "9223372036854775807",
                                    "1e300", "1e-300", "\"1 furlong\"", "1979-05-27"}) {
      auto const set = key.path() + "=" + value;
      for (std::string const name : {"sdpd", "dpde"}) {
        auto const check = checked(name, {set});
        ++tried;
        if (check.code == 0)
          continue;
        auto const run = ran(name, {set});
        EXPECT_EQ(check.code, run.code) << name << " " << set;
        EXPECT_EQ(check.errors, run.errors) << name << " " << set;
        EXPECT_EQ(check.errors.find("unexpected"), std::string::npos) << check.errors;
        EXPECT_EQ(std::ranges::count(check.errors, '\n'), 1) << check.errors;
        ++refused;
      }
    }
  EXPECT_GT(tried, 1000);
  EXPECT_GT(refused, 800);
}

} // namespace
} // namespace mesobridge::workflows
