#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/trajectory/h5md_kinds.hpp"
#include <array>
#include <gtest/gtest.h>
#include <numeric>

namespace mesobridge::workflows {
namespace {

/// What a file says of four atoms, and what is made of it: a refusal or a warning that holds a word of each.
struct Said {
  std::vector<std::int64_t> species;
  std::vector<double> masses;
  std::string unit, refused, warned;
  bool each_step = false;
};

/// Types 1 2 1 3, of which 1 and 3 may be the same element.
TrajectoryReading four_atoms() {
  return {.atoms = {{11, 1, 12.0}, {12, 2, 1.0}, {13, 1, 12.0}, {14, 3, 12.0}}};
}

void write(Store& store, Said const& of) {
  std::string const species = of.each_step ? "particles/all/species/value" : "particles/all/species";
  std::size_t const n = of.species.size();
  if (n > 0 && of.each_step) {
    store.write(species, of.species, {n / 4, 4});
    store.write("particles/all/species/step", std::vector<std::int64_t>{0, 10});
  } else if (n > 0)
    store.write(species, of.species);
  if (!of.masses.empty())
    store.write("particles/all/mass", of.masses);
  if (!of.unit.empty())
    store.set_attribute("particles/all/mass", "unit", of.unit);
  store.close();
}

/// What is refused of both steps; `warned` gets the warnings.
std::string refusal(std::filesystem::path const& file, TrajectoryReading how, std::string& warned) {
  how.warn = [&](std::string const& text) { warned += text; };
  Store const store(file, Store::Mode::read);
  std::vector<std::size_t> order(4);
  std::iota(order.begin(), order.end(), std::size_t{0});
  try {
    H5mdKinds const kinds(store, "particles/all", 4, how);
    for (std::int64_t const step : {0, 10})
      kinds.check(step, order);
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}

TEST(H5mdKinds, SpeciesAndMassesOfOtherAtomsAreRefused) {
  tests::ScratchDirectory const scratch;
  std::vector<Said> const all{
      {{1, 2, 1, 3}, {12, 1, 12, 12}, "", "", ""},
      {{6, 1, 6, 6}, {}, "", "", ""}, // numbers of elements
      {{1, 2, 1, 3, 1, 2, 1, 3}, {}, "", "", "", true},
      {{1, 2, 1, 3, 1, 2, 3, 1}, {}, "", "says 3 of atom 13 at step 10", "", true},
      {{2, 1, 2, 3}, {}, "", "says 2 of atom 11 at step 0, which has the type 1", ""}, // the types' numbers
      {{6, 6, 1, 6}, {}, "", "says 6 of atom 11 and 1 of atom 13", ""},
      {{}, {12.0004, 1, 12, 12}, "", "", ""},
      {{}, {12, 12, 1, 12}, "", "says 12 of the atom in place 2 at step 0: by the mapping it is 1", ""},
      {{}, {0.012, 0.001, 0.012, 0.012}, "kg mol-1", "", ""},
      {{}, {0.012, 0.001, 0.012, 0.012}, "", "says 0.012", ""},
      {{}, {0.012, 0.001, 0.012, 0.013}, "kg mol-1", "in the unit of the first, 'kg mol-1'", ""},
      {{1, 2, 1}, {}, "", "", "has frames of 3: must be 4"},
      {{}, {12, 0, 12, 12}, "", "", "not compared"},
  };
  std::size_t tried = 0;
  for (auto const& of : all) {
    auto const file = scratch / fmt::format("{}.h5", tried);
    {
      Store store(file, Store::Mode::create);
      write(store, of);
    }
    std::string warned;
    auto const refused = refusal(file, four_atoms(), warned);
    EXPECT_EQ(refused.empty(), of.refused.empty()) << tried << refused;
    EXPECT_NE(refused.find(of.refused), std::string::npos) << tried << refused;
    EXPECT_EQ(warned.empty(), of.warned.empty()) << tried << warned;
    EXPECT_NE(warned.find(of.warned), std::string::npos) << tried << warned;
    ++tried;
  }
  EXPECT_EQ(tried, 13u);
}

TEST(H5mdKinds, MassesOfAMappingsOwnMoleculesAreCompared) {
  tests::ScratchDirectory const scratch;
  {
    Store store(scratch / "a.h5", Store::Mode::create);
    write(store, {{5, 5, 5, 5}, {1, 2, 1, 2}, "", "", ""});
  }
  std::string warned;
  EXPECT_EQ(refusal(scratch / "a.h5", {.masses = {1, 2}}, warned), "");
  EXPECT_NE(refusal(scratch / "a.h5", {.masses = {2, 1}}, warned).find("says 1"), std::string::npos);
  EXPECT_EQ(refusal(scratch / "a.h5", {}, warned), ""); // nothing is expected
  EXPECT_EQ(warned, "");
}

} // namespace
} // namespace mesobridge::workflows
