#include "error_text.hpp"
#include "fitting/model_file.hpp"
#include "unit/fitting/synthetic_grid.hpp"
#include <bit>
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

EosModel fitted_model() {
  std::mt19937_64 generator(31);
  auto const fit = fit_lj_bwr(measured_grid(different_fluid(0.004, generator), {}, generator));
  return model_of(
      fit, argon_units, "sha256:0123",
      {{"command", "fit lj-bwr \"grid\".h5"}, {"note", "line 1\nline 2 \\ \t é"}, {"two words", "x"}});
}

void expect_same_bits(double a, double b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b));
}

TEST(ModelFile, AFitReturnsBitForBit) {
  auto const model = fitted_model();
  auto const back = parse_model(to_toml(model), "argon.toml");
  auto const& written = std::get<LjBwr>(model.eos);
  auto const& read = std::get<LjBwr>(back.eos);
  int cases = 0;
  for (int j = 0; j < bwr::parameters; ++j, ++cases)
    expect_same_bits(written.set().x[j], read.set().x[j]);
  EXPECT_EQ(cases, 32);
  expect_same_bits(written.set().gamma, read.set().gamma);
  expect_same_bits(written.set().T_low, read.set().T_low);
  expect_same_bits(written.set().T_max, read.set().T_max);
  expect_same_bits(written.set().rho_max, read.set().rho_max);
  expect_same_bits(written.units()->sigma, read.units()->sigma);
  expect_same_bits(written.units()->epsilon, read.units()->epsilon);
  expect_same_bits(written.units()->mass, read.units()->mass);
  EXPECT_TRUE(*model.covariance_factor == *back.covariance_factor);
  EXPECT_GT(back.covariance_factor->norm(), 0);
  EXPECT_EQ(*model.valid, *back.valid);
  EXPECT_EQ(model.data_hash, back.data_hash);
  EXPECT_EQ(model.provenance, back.provenance);
  EXPECT_EQ(to_toml(back), to_toml(model));
}

TEST(ModelFile, EveryMaterialReturns) {
  std::size_t cases = 0;
  for (auto const& material : materials()) {
    auto const text = to_toml({material.eos, {}, {}, {}, {}});
    auto const back = parse_model(text, "m.toml");
    EXPECT_EQ(back.eos.index(), material.eos.index());
    EXPECT_EQ(to_toml(back), text);
    double const rho = material.name.starts_with("lj") ? 0.7 : 1000, T = rho < 1 ? 5 : 700;
    auto energy = [&](auto const& eos) { return eos.energy_from_temperature(T, rho); };
    expect_same_bits(std::visit(energy, back.eos), std::visit(energy, material.eos));
    ++cases;
  }
  EXPECT_GE(cases, 9u);
}

TEST(ModelFile, AnyNumberReturnsBitForBit) {
  // Random bit patterns: every magnitude from the denormal to the largest.
  std::mt19937_64 generator(33);
  auto positive = [&] {
    for (;;)
      if (double const x = std::abs(std::bit_cast<double>(generator())); std::isfinite(x) && x > 0)
        return x;
  };
  int cases = 0;
  for (; cases < 5000; ++cases) {
    IdealGas const gas(positive(), positive(), positive());
    auto const back = std::get<IdealGas>(parse_model(to_toml({gas, {}, {}, {}, {}}), "gas.toml").eos);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(gas.molecular_mass()),
              std::bit_cast<std::uint64_t>(back.molecular_mass()));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(gas.dof()), std::bit_cast<std::uint64_t>(back.dof()));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(gas.boltzmann()), std::bit_cast<std::uint64_t>(back.boltzmann()));
  }
  EXPECT_EQ(cases, 5000);
}

std::string replaced(std::string text, std::string const& what, std::string const& with) {
  auto const at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(ModelFile, ErrorsNameFileLineAndKey) {
  auto const good = to_toml(fitted_model());
  struct Case {
    std::string text, message;
  };
  std::vector<Case> const cases{
      {replaced(good, "gamma = 3.0", "gama = 3.0"), "lj_bwr.gamma: missing"},
      {replaced(good, "gamma = 3.0", "gamma = 3.0\ncolour = 1"),
       "lj_bwr.colour: unknown key; known here: gamma, T_low"},
      {replaced(good, "gamma = 3.0", "gamma = \"3\""), "lj_bwr.gamma: must be a finite number"},
      {replaced(good, "gamma = 3.0", "gamma = nan"), "lj_bwr.gamma: must be a finite number"},
      {replaced(good, "gamma = 3.0", "gamma = true"), "lj_bwr.gamma: must be a finite number"},
      {replaced(good, "gamma = 3.0", "gamma = -3"), "gamma"},
      {replaced(good, "x = [", "x = [1.0, "), "lj_bwr.x: must be an array of 32"},
      {replaced(good, "x = [",
                "x = ["
                "[1.0], "),
       "lj_bwr.x"},
      {replaced(good, "\nL = [", "\nL = [1.0, "), "covariance.L: must be an array of 528"},
      {replaced(good, "kind = \"lj-bwr\"", "kind = \"jwell\""),
       "kind: must be one of \"ideal-gas\", \"lj-bwr\", \"lj-kn\", \"lj-thol\", \"mie-gruneisen\""},
      {replaced(good, "equation of state 1", "equation of state 9"), "format: must be"},
      {replaced(good, "kind =", "sort ="), "kind: missing"},
      {replaced(good, "[valid]", "[walid]"), "walid: unknown key"},
      {replaced(good, "data_hash = ", "data_hash = 3 #"), "data_hash: must be a string"},
      {replaced(good, "sigma_m = 3.405e-10", "sigma_m = -3.405e-10"), "LJ sigma"},
      {replaced(good, "gamma = 3.0", "gamma = "), ""},
  };
  std::size_t refused = 0;
  for (auto const& [text, message] : cases) {
    try {
      parse_model(text, "argon.toml");
      ADD_FAILURE() << "accepted: " << message;
    } catch (InputError const& error) {
      std::string const what = error.what();
      EXPECT_EQ(what.rfind("argon.toml:", 0), 0u) << what;
      EXPECT_NE(what.find(message), std::string::npos) << what;
      ++refused;
    }
  }
  EXPECT_EQ(refused, cases.size());
}

std::string refusal(std::string const& text) {
  return tests::error_text([&] { parse_model(text, "m.toml"); });
}

/// Spoils every key of a parametric model's file in turn; returns how many spoilt files were tried.
template <class Model>
int spoil_each_key(Model const& model) {
  auto const text = to_toml({model, {}, {}, {}, {}});
  auto const table = Model::description().table();
  int cases = 0;
  for (auto const& key : Model::description().parameters) {
    std::string const name = key.key(), line = "\n" + name + " = ";
    auto expect = [&](std::string const& with, std::string const& message) {
      auto const what = refusal(replaced(text, line, with));
      EXPECT_EQ(what.rfind("m.toml:", 0), 0u) << what;
      EXPECT_NE(what.find(table + "." + name + message), std::string::npos) << what;
      ++cases;
    };
    if (key.if_missing) { // older files do not have it
      EXPECT_EQ(refusal(replaced(text, line, "\n#" + name + " = ")), "no error");
    } else {
      expect("\n#" + name + " = ", ": missing");
      expect("\n" + name + "x = 1\n#", ": missing");
    }
    expect(line + "nan #", ": must be a finite number");
    expect(line + "true #", ": must be a finite number");
  }
  EXPECT_NE(
      refusal(replaced(text, "\n[" + table + "]", "\n[" + table + "]\ncolour = 1")).find("colour: unknown"),
      std::string::npos);
  EXPECT_NE(refusal(replaced(text, "c_v_J_kg_K = ", "c_v_J_kg_K = -")).find("c_v"), std::string::npos);
  return cases;
}

TEST(ModelFile, ParametricModelsAreReadStrictly) {
  int cases = 0;
  for (auto const& material : materials())
    std::visit(
        [&]<class Model>(Model const& model) {
          if constexpr (DescribedModel<Model>)
            cases += spoil_each_key(model);
        },
        material.eos);
  EXPECT_GE(cases, 4 * (11 + 8 + 12 + 5) + 2 * 1);
}

TEST(ModelFile, LjReferencesReturnInTheirUnits) {
  auto const text = to_toml({LjThol(argon_units), {}, {}, {}, {}});
  auto const back = std::get<LjThol>(parse_model(text, "thol.toml").eos);
  EXPECT_EQ(back.units()->sigma, argon_units.sigma);
  expect_same_bits(back.energy_from_temperature(300, 1150),
                   LjThol(argon_units).energy_from_temperature(300, 1150));
  EXPECT_EQ(to_toml({back, {}, {}, {}, {}}), text);
}

TEST(ModelFile, TheLineIsTheRightOne) {
  std::string const text =
      "format = \"mesobridge equation of state 1\"\nkind = \"ideal-gas\"\n[ideal_gas]\nm0 = 1e-25\n"
      "dof = \"three\"\nk_B = 1.380649e-23\n";
  try {
    parse_model(text, "gas.toml");
    FAIL() << "no exception";
  } catch (InputError const& error) {
    EXPECT_STREQ(error.what(), "gas.toml:5: ideal_gas.dof: must be a finite number");
  }
}

TEST(ModelFile, RefusesAModelWithoutUniqueTemperatures) {
  LjBwrSet set = lj_bwr_1993;
  set.T_low = 0.5;
  EXPECT_THROW(parse_model(to_toml({LjBwr(set), {}, {}, {}, {}}), "cold.toml"), InputError);
}

TEST(ModelFile, LoadsMaterialsByNameAndFilesByReader) {
  std::string asked;
  auto const read = [&](std::string const& file) {
    asked = file;
    return to_toml({IdealGas(2e-25), {}, {}, {}, {}});
  };
  EXPECT_EQ(std::get<LjBwr>(load_eos("lj", read).eos).boltzmann(), 1);
  EXPECT_TRUE(asked.empty());
  EXPECT_EQ(std::get<IdealGas>(load_eos("my/gas.toml", read).eos).molecular_mass(), 2e-25);
  EXPECT_EQ(asked, "my/gas.toml");
  EXPECT_THROW(load_eos("argonn", read), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
