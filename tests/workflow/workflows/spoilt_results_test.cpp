#include "scratch_directory.hpp"
#include "workflows/lj/grid_file.hpp"
#include "workflows/process.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/summary.hpp"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

// Files of the program's own that were changed, cut or made by others: each command that reads them refuses
// them by name, whatever stands where a number belongs.

namespace mesobridge::workflows {

namespace {

using tests::ScratchDirectory;
using Doubles = std::vector<double>;
using Integers = std::vector<std::int64_t>;

/// Changes a good file, and the words by which it is refused then.
struct Spoilt {
  std::function<void(Store&)> change;
  std::vector<std::string> words;
};

void expect_refused(std::vector<std::string> command, std::filesystem::path const& file,
                    std::function<void()> const& make, std::vector<Spoilt> const& all) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    make();
    {
      Store store(file, Store::Mode::append);
      all[k].change(store);
      store.close();
    }
    auto words = command;
    words.insert(words.begin(), MESOBRIDGE_PROGRAM);
    auto const result = run_process(words);
    EXPECT_EQ(result.status, 2) << k << ": " << result.errors;
    EXPECT_NE(result.errors.find(file.filename().string()), std::string::npos) << k << ": " << result.errors;
    for (auto const& word : all[k].words)
      EXPECT_NE(result.errors.find(word), std::string::npos) << k << ": " << word << "\n" << result.errors;
  }
}

/// Three molecules, 40 frames of independent energies.
void write_blobs(std::filesystem::path const& file, std::string const& kind = "melt") {
  BlobFileHead head;
  head.kind = kind, head.name = "dimer", head.fingerprint = "none";
  head.molecules = 3, head.atoms = 2, head.mass = 2, head.rho = 0.5, head.T = 1;
  BlobFile blobs(file, head, {.command = "none", .seed = 1, .scene = "", .inputs = {}});
  std::vector<cg::BlobFrame> frames(1);
  for (int k = 0; k < 40; ++k) {
    auto& frame = frames[0];
    frame.step = k, frame.time = k, frame.box = {{10, 10, 10}};
    frame.blobs.assign(3, cg::Blob{});
    for (int m = 0; m < 3; ++m) {
      auto& blob = frame.blobs[std::size_t(m)];
      blob.R = {1.0 + m, 1, 1}, blob.P = {std::sin(k + m), std::cos(1.7 * k), std::sin(2.3 * k)};
      blob.U_kin = 1 + 0.5 * std::sin(3.1 * k + m), blob.U_pot = 1 + 0.5 * std::cos(5.3 * k + m);
    }
    blobs.append(frames);
  }
  blobs.close();
}

TEST(SpoiltResults, BlobsAreRefusedByTheColumn) {
  ScratchDirectory const scratch;
  auto const file = scratch / "blobs.h5";
  auto const replaced = [](char const* path, Doubles const& values, Store::Shape const& shape) {
    return [=](Store& store) { store.write(path, std::span<double const>(values), shape); };
  };
  std::vector<Spoilt> const all{
      {replaced("blobs/U_kin", {}, {0, 3}), {"blobs/U_kin", "0 rows"}},
      {replaced("frames/time", {}, {0}), {"frames/time", "0 rows"}},
      {[](Store& s) {
         for (char const* path : {"frames/step", "frames/time", "frames/energy", "frames/pressure"})
           s.write(path, Doubles{}, {0});
         s.write("frames/step", Integers{}, {0});
       },
       {"frames/"}},
      {replaced("blobs/P", Doubles(40 * 3 * 2, 1.0), {40, 3, 2}), {"blobs/P", "40 x 3 x 2", "40 x 3 x 3"}},
      {replaced("blobs/R", Doubles(40 * 2 * 3, 1.0), {40, 2, 3}), {"blobs/R", "40 x 2 x 3"}},
      {replaced("blobs/U_pot", Doubles(40, 1.0), {40}), {"blobs/U_pot", "40", "40 x 3"}},
      {replaced("frames/box", Doubles(40 * 3, 0.0), {40, 3}), {"frames/box", "> 0"}},
      {replaced("blobs/U_kin", Doubles(40 * 3, NAN), {40, 3}), {"blobs/U_kin", "nan", "finite"}},
      {replaced("frames/time", Doubles(40, 1.0), {40}), {"frames/time", "must grow"}},
      {[](Store& s) { s.write("frames/step", Doubles(40, 1.5)); }, {"frames/step", "integers"}},
      {[](Store& s) { s.write("frames/time", std::string("x")); }, {"frames/time"}},
      {[](Store& s) { s.set_attribute("settings", "molecules", std::int64_t{-3}); }, {"molecules", "-3"}},
      {[](Store& s) { s.set_attribute("settings", "molecules", std::int64_t{1} << 40); }, {"molecules"}},
      {[](Store& s) { s.set_attribute("settings", "molecules", 3.0); }, {"molecules", "integer"}},
      {[](Store& s) {
         s.set_attribute("settings", "molecules", Integers{3, 3, 3, 3});
       },
       {"molecules", "one"}},
      {[](Store& s) {
         s.set_attribute("settings", "mass", Integers{1, 2, 3, 4});
       },
       {"mass", "array of 4"}},
      {[](Store& s) { s.set_attribute("settings", "mass", std::string("heavy")); }, {"mass", "number"}},
      {[](Store& s) { s.set_attribute("settings", "mass", 0.0); }, {"mass", "> 0"}},
      {[](Store& s) { s.set_attribute("settings", "kind", 1.0); }, {"kind", "text"}},
      {[](Store& s) {
         s.write("settings/set", Doubles{1, 2});
       },
       {"settings/set", "2", "3"}}};
  ASSERT_EQ(all.size(), 20u);
  for (char const* command : {"entropy", "correlations", "transport"}) {
    std::vector<std::string> words{"cg", command};
    if (std::string(command) == "entropy")
      words.emplace_back("--melt");
    words.insert(words.end(), {file.string(), "-o", (scratch / "out").string()});
    expect_refused(
        words, file, [&] { write_blobs(file); }, all);
  }
}

TEST(SpoiltResults, BlobsInVacuumWithoutTheLevelsOfTheirMoleculesAreRefused) {
  ScratchDirectory const scratch;
  auto const melt = scratch / "melt.h5", vacuum = scratch / "vacuum.h5";
  write_blobs(melt);
  for (auto const& [option, kind] : {std::pair<std::string, std::string>{"--vacuum", "vacuum canonical"},
                                     {"--vacuum-nve", "vacuum microcanonical"}}) {
    std::filesystem::remove(vacuum);
    write_blobs(vacuum, kind);
    auto const result = run_process({MESOBRIDGE_PROGRAM, "cg", "entropy", "--melt", melt.string(), option,
                                     vacuum.string(), "-o", (scratch / "out").string()});
    EXPECT_EQ(result.status, 2) << result.errors;
    for (char const* word : {"vacuum.h5", "settings/set"})
      EXPECT_NE(result.errors.find(word), std::string::npos) << word << "\n" << result.errors;
  }
}

void write_grid(std::filesystem::path const& file) {
  std::vector<md::LjState> const states{{.rho = 0.5, .T = 1.5}};
  LjGridFile grid(file, states, md::LjFluidSettings{},
                  {.command = "none", .seed = 1, .scene = "", .inputs = {}});
  std::vector<md::ThermoSample> samples;
  for (int k = 0; k < 200; ++k)
    samples.push_back({.step = k,
                       .T = 1.5 + 0.1 * std::sin(3.1 * k),
                       .U = -3 + 0.1 * std::sin(5.3 * k),
                       .P = 1 + 0.1 * std::cos(2.9 * k)});
  grid.append(0, samples);
  grid.close(true);
}

TEST(SpoiltResults, AGridOfRunsIsRefusedByWhatIsWrong) {
  ScratchDirectory const scratch;
  auto const file = scratch / "lj-grid.h5";
  write_grid(file);
  auto const command =
      std::vector<std::string>{"cg", "state-grid", file.string(), "-o", (scratch / "out").string()};
  auto good = command;
  good.insert(good.begin(), MESOBRIDGE_PROGRAM);
  ASSERT_EQ(run_process(good).status, 0) << "the file is good before it is spoilt";
  std::vector<Spoilt> const all{
      {[](Store& s) {
         s.set_attribute("states/0000", "rho", Integers{1, 2, 3, 4, 5, 6});
       },
       {"rho", "array of 6"}},
      {[](Store& s) {
         s.set_attribute("settings", "atoms", Integers{1, 2, 3, 4});
       },
       {"atoms", "array of 4"}},
      {[](Store& s) { s.set_attribute("settings", "atoms", std::int64_t{0}); }, {"atoms", ">= 1"}},
      {[](Store& s) { s.set_attribute("settings", "atoms", std::int64_t{1} << 33); }, {"atoms"}},
      {[](Store& s) { s.set_attribute("settings", "complete", std::string("yes")); },
       {"complete", "integer"}},
      {[](Store& s) { s.set_attribute("settings", "description", 1.0); }, {"description", "text"}},
      {[](Store& s) { s.set_attribute("states/0000", "T", NAN); }, {"'T'", "nan"}},
      {[](Store& s) { s.write("states/0000/P", Doubles(200, INFINITY)); }, {"states/0000/P", "inf"}},
      {[](Store& s) {
         s.write("states/0000/U", Doubles(400, 1.0), {200, 2});
       },
       {"states/0000/U", "200 x 2"}},
      {[](Store& s) { s.write("states/0000/step", Doubles(200, 0.5)); }, {"states/0000/step", "integers"}},
      {[](Store& s) { s.write("states/0001", Doubles{1}); }, {"rho"}}};
  ASSERT_EQ(all.size(), 11u);
  expect_refused(
      command, file, [&] { write_grid(file); }, all);
}

} // namespace

} // namespace mesobridge::workflows
