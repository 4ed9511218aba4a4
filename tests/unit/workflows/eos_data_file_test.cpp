#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/eos_fit/data_columns.hpp"
#include "workflows/eos_fit/data_file.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using fitting::DataPath;
using fitting::Quantity;
using tests::ScratchDirectory;

EosData read(std::string const& text, RelativeErrors const& errors = {}) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "data.csv", text);
  return read_eos_data(scratch / "data.csv", errors);
}

void expect_datum(fitting::Datum const& datum, Quantity quantity, double value, double se) {
  EXPECT_EQ(datum.quantity, quantity);
  EXPECT_DOUBLE_EQ(datum.value, value);
  EXPECT_DOUBLE_EQ(datum.se, se);
}

TEST(EosDataFile, StatesOfAGridWithCorrelatedErrors) {
  auto const data = read("# a comment\n"
                         "rho_kg_m3,T_K,P_Pa,P_se_Pa,e_J_kg,e_se_J_kg,P_e_correlation,phase\n"
                         "\n"
                         "8000, 900, 5e9, 1e7, -2e5, 300, 0.4, liquid\n"
                         "8100,900,6e9,2e7,,,,\n");
  ASSERT_EQ(data.observations.size(), 2u);
  auto const& first = data.observations[0];
  EXPECT_EQ(first.path, DataPath::state);
  EXPECT_FALSE(first.start);
  ASSERT_EQ(first.given.size(), 2u);
  expect_datum(first.given[0], Quantity::rho, 8000, 0);
  expect_datum(first.given[1], Quantity::T, 900, 0);
  ASSERT_EQ(first.measured.size(), 2u);
  expect_datum(first.measured[0], Quantity::e, -2e5, 300);
  expect_datum(first.measured[1], Quantity::P, 5e9, 1e7);
  EXPECT_EQ(first.P_e_correlation, 0.4);
  EXPECT_TRUE(first.origin.ends_with("data.csv:4"));
  EXPECT_EQ(data.observations[1].measured.size(), 1u);
}

TEST(EosDataFile, UnitsAndBothPlacesOfTheErrorMark) {
  auto const data = read("rho_g_cm3,e_MJ_kg,P_GPa,P_GPa_se,sound_speed_km_s,sound_speed_se_km_s\n"
                         "8,0.3,5,0.1,3.1,0.02\n");
  auto const& state = data.observations.at(0);
  expect_datum(state.given.at(0), Quantity::rho, 8000, 0);
  expect_datum(state.given.at(1), Quantity::e, 3e5, 0);
  expect_datum(state.measured.at(0), Quantity::P, 5e9, 1e8);
  expect_datum(state.measured.at(1), Quantity::sound_speed, 3100, 20);
}

TEST(EosDataFile, ShocksOfMolecularDynamicsAreGivenByTheirDensity) {
  auto const data = read("rho0_kg_m3,T0_K,v_P_m_s,v_P_se_m_s,v_S_m_s,v_S_se_m_s,rho_kg_m3,P_Pa,P_se_Pa,T_K,T_"
                         "se_K,e_J_kg,e_se_J_kg\n"
                         "7290,300,500,1,3355,20,8567,1.2e10,1e8,500,5,1e5,100\n");
  auto const& shock = data.observations.at(0);
  EXPECT_EQ(shock.path, DataPath::hugoniot);
  EXPECT_EQ(shock.start->rho, 7290);
  EXPECT_EQ(shock.start->T, 300);
  ASSERT_EQ(shock.given.size(), 1u);
  expect_datum(shock.given[0], Quantity::rho, 8567, 0);
  ASSERT_EQ(shock.measured.size(), 2u); // v_P, v_S and e are no further information
  expect_datum(shock.measured[0], Quantity::T, 500, 5);
  expect_datum(shock.measured[1], Quantity::P, 1.2e10, 1e8);
  ASSERT_EQ(data.notes.size(), 1u);
  EXPECT_NE(data.notes[0].find("e, v_P, v_S"), std::string::npos) << data.notes[0];
}

TEST(EosDataFile, ShocksOfExperimentsAreGivenByTheirVelocities) {
  RelativeErrors errors;
  add_relative_error(errors, "0.02");
  add_relative_error(errors, "v_S=0.01");
  auto const data =
      read("rho0_kg_m3,T0_K,v_P_km_s,v_P_se_km_s,v_S_km_s,rho_kg_m3,P_GPa\n7290,300,0.5,0.005,3,8748,10.9\n",
           errors);
  auto const& shock = data.observations.at(0);
  expect_datum(shock.given.at(0), Quantity::v_P, 500, 5);
  ASSERT_EQ(shock.measured.size(), 1u);
  expect_datum(shock.measured[0], Quantity::v_S, 3000, 30);
}

TEST(EosDataFile, KindsOfRowsMayBeMixed) {
  RelativeErrors errors;
  add_relative_error(errors, "rho=0.01");
  auto const data = read("kind,rho0_kg_m3,e0_J_kg,P0_Pa,rho_kg_m3,e_J_kg,P_GPa,P_se_GPa,D_m_s,D_se_m_s\n"
                         "cj,1128,0,0,1570,,12.5,0.5,6280,60\n"
                         "isentrope,1570,,1.25e10,1000,,4,0.1,,\n"
                         "hugoniot,1128,1e5,0,1700,,20,1,,\n"
                         "state,,,,1000,3e6,4,0.1,,\n",
                         errors);
  ASSERT_EQ(data.observations.size(), 4u);
  auto const& cj = data.observations[0];
  EXPECT_EQ(cj.path, DataPath::cj);
  EXPECT_TRUE(cj.given.empty());
  ASSERT_EQ(cj.measured.size(), 3u);
  expect_datum(cj.measured[0], Quantity::rho, 1570, 15.7);
  expect_datum(cj.measured[1], Quantity::P, 1.25e10, 5e8);
  expect_datum(cj.measured[2], Quantity::v_S, 6280, 60);
  auto const& isentrope = data.observations[1];
  EXPECT_EQ(isentrope.path, DataPath::isentrope);
  EXPECT_EQ(isentrope.start->P, 1.25e10);
  EXPECT_FALSE(isentrope.start->e);
  expect_datum(isentrope.given.at(0), Quantity::rho, 1000, 0);
  auto const& crussard = data.observations[2];
  EXPECT_EQ(crussard.path, DataPath::hugoniot);
  EXPECT_EQ(crussard.start->e, 1e5);
  EXPECT_EQ(crussard.start->P, 0);
  EXPECT_EQ(data.observations[3].path, DataPath::state);
  expect_datum(data.observations[3].given.at(1), Quantity::e, 3e6, 0);
}

TEST(EosDataFile, Hdf5HoldsTheSameColumns) {
  ScratchDirectory const scratch;
  std::vector<double> const rho{8000, 8100}, T{900, 950}, P{5e9, 6e9}, P_se{1e7, 2e7}, order{0.1, 0.2};
  {
    Store store(scratch / "grid.h5", Store::Mode::create);
    store.write("metal_grid/rho_kg_m3", rho);
    store.write("metal_grid/T_K", T);
    store.write("metal_grid/P_Pa", P);
    store.write("metal_grid/P_se_Pa", P_se);
    store.write("metal_grid/lattice_order", order);
    store.set_attribute("provenance", "program", std::string("mesobridge"));
    store.close();
  }
  auto const data = read_eos_data(scratch / "grid.h5", {});
  ASSERT_EQ(data.observations.size(), 2u);
  expect_datum(data.observations[1].given.at(0), Quantity::rho, 8100, 0);
  expect_datum(data.observations[1].measured.at(0), Quantity::P, 6e9, 2e7);
  ASSERT_EQ(data.notes.size(), 1u);
  EXPECT_NE(data.notes[0].find("lattice_order"), std::string::npos);
}

TEST(EosDataFile, WhatIsWrongIsSaidWithLineAndColumn) {
  struct Case {
    std::string text, words;
  };
  std::string const header = "rho_kg_m3,T_K,P_Pa,P_se_Pa\n";
  std::vector<Case> const cases{
      {"", "holds no data"},
      {header, "holds no data"},
      {"rho_kg_m3,T_K,P_pa\n8000,900,1\n", ":1: unknown column 'P_pa'; did you mean 'P_Pa'?"},
      {"rho_kg_m3,T_K,P\n8000,900,1\n",
       ":1: column 'P' does not say its unit; units of P: Pa, kPa, MPa, GPa"},
      {"rho_kg_m3,T_K,P_Pa,T_K\n8000,900,1,2\n", ":1: column 'T_K' stands there twice"},
      {"rho_kg_m3,rho_g_cm3,T_K,P_Pa,P_se_Pa\n8000,8,900,1,1\n", "rho is given twice"},
      {header + "# fine\n8000,900,5e9\n", ":3: 3 cells, but the header names 4 columns"},
      {header + "8000,900,abc,1\n", ":2: column 'P_Pa': 'abc' must be a finite number"},
      {header + "8000,900,nan,1\n", ":2: column 'P_Pa': 'nan' must be a finite number"},
      {header + "8000,900,1e9,\n",
       ":2: P has no standard error: add a column P_se_(unit), or give --relative-error"},
      {header + "8000,900,1e9,-1\n", ":2: standard error of P = -1: must be > 0"},
      {header + "-8000,900,1e9,1\n", ":2: rho = -8000: must be > 0"},
      {header + "8000,,1e9,1\n", ":2: a state needs rho and T, or rho and e"},
      {"kind,rho_kg_m3,T_K,P_Pa,P_se_Pa\nshock,8000,300,1e9,1e7\n",
       "'shock' must be state, hugoniot, isentrope or cj"},
      {"rho0_kg_m3,v_P_m_s,v_S_m_s,v_S_se_m_s\n7290,500,3355,30\n", ":2: the start needs one of T0, e0, P0"},
  };
  int ran = 0;
  for (auto const& [text, words] : cases) {
    try {
      read(text);
      ADD_FAILURE() << words;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find("data.csv"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
    ++ran;
  }
  EXPECT_EQ(ran, 15);
}

TEST(EosDataFile, RelativeErrorsAreChecked) {
  RelativeErrors errors;
  for (auto const* const text : {"1.5", "0", "-0.1", "abc", "P=", "Q=0.01", "P=2"})
    EXPECT_THROW(add_relative_error(errors, text), InputError) << text;
  add_relative_error(errors, "P=0.01");
  EXPECT_EQ(errors.of.at(Quantity::P), 0.01);
}

} // namespace
} // namespace mesobridge::workflows
