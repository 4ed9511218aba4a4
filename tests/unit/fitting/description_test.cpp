#include "fitting/fit_family.hpp"
#include "md/error.hpp"
#include <gtest/gtest.h>
#include <set>

// What every model that describes itself must say, whatever it is.

namespace mesobridge::fitting::test {
namespace {

/// Calls f<Model>() for every described model, with its kind in the messages; returns how many there were.
template <class F>
int for_each_kind(F&& f) {
  int models = 0;
  for_each_described_model([&]<class Model>() {
    SCOPED_TRACE(Model::description().kind);
    f.template operator()<Model>();
    ++models;
  });
  return models;
}

TEST(Description, NamesKeysAndMaterialsAreUnique) {
  std::set<std::string> kinds, names;
  int const models = for_each_kind([&]<class Model>() {
    auto const& description = Model::description();
    EXPECT_TRUE(kinds.insert(std::string(description.kind)).second);
    EXPECT_FALSE(description.material.empty());
    std::set<std::string> keys;
    for (auto const& parameter : description.parameters) {
      EXPECT_TRUE(keys.insert(parameter.key()).second) << parameter.key();
      EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
    }
    // Every number of the struct has its row, or a file would lose it.
    EXPECT_EQ(description.parameters.size() * sizeof(double), sizeof(typename Model::Parameters));
    EXPECT_FALSE(description.materials.empty());
  });
  EXPECT_GE(models, 4);
  for (auto const& material : materials())
    EXPECT_TRUE(names.insert(material.name).second) << material.name;
}

TEST(Description, KeysCarryTheirUnits) {
  std::vector<std::string> keys;
  for (auto const& parameter : Hz::description().parameters)
    keys.push_back(parameter.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"Gamma_0", "rho_0_kg_m3", "c_0_m_s", "s", "c_v_J_kg_K", "T_0_K",
                                            "P_0_Pa", "m0_kg"}));
  EXPECT_EQ(StiffenedGas::description().parameters.back().key(), "b_m3_kg");
  EXPECT_EQ(StiffenedGas::description().table(), "stiffened_gas");
}

/// Whether the parameters are refused in words that name the parameter.
template <class Model>
bool refused_by_name(typename Model::Parameters const& parameters, std::string_view name) {
  try {
    Model{parameters};
  } catch (InputError const& error) {
    std::string const what = error.what();
    return what.starts_with(Model::name) && what.find(name) != std::string::npos;
  }
  return false;
}

TEST(Description, ParametersThatAreNotAllowedAreRefusedByName) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  int cases = 0;
  int const models = for_each_kind([&]<class Model>() {
    for (auto const& parameter : Model::description().parameters) {
      std::vector<double> values{NAN, infinity, -infinity};
      if (auto const& allowed = parameter.allowed; std::isfinite(allowed.min))
        values.push_back(allowed.open ? allowed.min : std::nextafter(allowed.min, -infinity));
      for (double const value : values) {
        auto spoilt = Model::description().materials.front().parameters;
        spoilt.*parameter.member = value;
        EXPECT_TRUE(refused_by_name<Model>(spoilt, parameter.name)) << parameter.name << " " << value;
        ++cases;
      }
    }
  });
  EXPECT_GT(cases, 100);
  EXPECT_GE(models, 4);
}

TEST(Description, FitsBeginWithinTheirBoundsAtAllowedValues) {
  std::vector<Observation> const data{
      {.given = {{Quantity::rho, 1200}, {Quantity::T, 400}}, .measured = {{Quantity::P, 1e9, 1e7}}},
      {.given = {{Quantity::rho, 1500}, {Quantity::T, 900}}, .measured = {{Quantity::P, 9e9, 1e7}}}};
  std::size_t fittable = 0;
  for_each_kind([&]<class Model>() {
    auto const& description = Model::description();
    auto const family = family_of<Model>(data);
    EXPECT_EQ(family.parameters.size(), description.parameters.size() + 1); // the energies' zero
    EXPECT_EQ(family.parameters.back().name, "energy_offset");
    std::size_t i = 0;
    for (auto const& parameter : description.parameters) {
      auto const& fit = family.parameters[i++];
      EXPECT_TRUE(parameter.allowed.contains(fit.start)) << fit.name;
      if (!fit.free)
        continue;
      EXPECT_TRUE(fit.lower <= fit.start && fit.start <= fit.upper && fit.lower < fit.upper) << fit.name;
      EXPECT_TRUE(!fit.logarithmic || fit.lower > 0) << fit.name;
      EXPECT_TRUE(parameter.allowed.contains(fit.lower) && parameter.allowed.contains(fit.upper)) << fit.name;
    }
    fittable += description.fittable();
    EXPECT_EQ(description.fittable(), !description.example.empty());
    // There and back again.
    AnyEos const model = Model(description.materials.front().parameters);
    auto const values = family.values_of(model);
    EXPECT_TRUE(family.values_of(family.build(values)) == values);
  });
  EXPECT_EQ(fittable, fittable_kinds().size());
  EXPECT_GE(fittable, 3u);
}

} // namespace
} // namespace mesobridge::fitting::test
