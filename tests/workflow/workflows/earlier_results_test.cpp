#include "scratch_directory.hpp"
#include "workflows/process.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <ostream>

// Sampling takes minutes to days: a second call into the same folder keeps what the first one has made.

namespace mesobridge::workflows {
namespace {

using Words = std::vector<std::string>;

struct Sampling {
  char const* name;
  Words words;      ///< a call of a few seconds
  char const* file; ///< one that it writes
};

void PrintTo(Sampling const& sampling, std::ostream* out) {
  *out << sampling.name;
}

Words const tiny_metal{"--potential",           "Cu_u3.eam", "--atoms",          "108",
                       "--equilibration-steps", "300",       "--sampling-steps", "2400"};

Words metal(std::string const& command, Words const& more) {
  Words words{"md", command};
  words.insert(words.end(), tiny_metal.begin(), tiny_metal.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<Sampling> const samplings{
    {"lj-grid",
     {"md", "lj-grid", "--atoms", "256", "--cutoff", "2.5", "--sampling-steps", "400", "--densities", "2",
      "--temperatures", "2"},
     "lj-grid.h5"},
    {"star-melt",
     {"md", "star-melt", "--molecules", "27", "--rho", "0.02", "--equilibration-steps", "40",
      "--sampling-steps", "40", "--sample-every", "20", "--checkpoint-every", "20"},
     "blobs.h5"},
    {"held-blobs",
     {"md", "held-blobs", "--molecules", "27", "--rho", "0.02", "--equilibration-steps", "40",
      "--sampling-steps", "40", "--free-steps", "20", "--sample-every", "20", "--checkpoint-every", "20",
      "--configurations", "2"},
     "held.h5"},
    {"star-vacuum",
     {"md", "star-vacuum", "--molecules", "12", "--redraw-every", "100", "--equilibration-steps", "200",
      "--sampling-steps", "500", "--checkpoint-every", "250"},
     "vacuum.h5"},
    {"metal-grid", metal("metal-grid", {"--rho", "8700,9000", "--T", "300,600"}), "metal-runs.h5"},
    {"hugoniot", metal("hugoniot", {"--compression", "1.1"}), "hugoniot-runs.h5"},
};

class EarlierResults : public testing::TestWithParam<Sampling> {};

TEST_P(EarlierResults, AreKept) {
  tests::ScratchDirectory const scratch;
  auto words = GetParam().words;
  words.insert(words.begin(), MESOBRIDGE_PROGRAM);
  words.insert(words.end(), {"--ranks", "1", "-o", scratch.path().string()});
  auto const first = run_process(words);
  ASSERT_EQ(first.status, 0) << first.errors;
  write_text_file(scratch / "notes.txt", "mine");
  auto const made = read_text_file(scratch / GetParam().file);
  auto const second = run_process(words);
  ASSERT_EQ(second.status, 0) << second.errors;
  EXPECT_TRUE(std::filesystem::exists(scratch / GetParam().file));
  ASSERT_TRUE(std::filesystem::exists(scratch / "backup-1" / GetParam().file)) << second.errors;
  EXPECT_EQ(read_text_file(scratch / "backup-1" / GetParam().file), made);
  EXPECT_NE(second.errors.find("backup-1' now"), std::string::npos) << second.errors;
  EXPECT_EQ(read_text_file(scratch / "notes.txt"), "mine"); // of no call of ours: untouched
}

INSTANTIATE_TEST_SUITE_P(Samplings, EarlierResults, testing::ValuesIn(samplings), [](auto const& info) {
  std::string name = info.param.name;
  std::erase(name, '-');
  return name;
});

} // namespace
} // namespace mesobridge::workflows
