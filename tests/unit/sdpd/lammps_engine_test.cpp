#include "pair_fluid_fixtures.hpp"
#include "scratch_directory.hpp"
#include "sdpd/lammps/lammps_engine.hpp"
#include <gtest/gtest.h>

// The engine inside LAMMPS beside the built-in one, on one rank.

namespace mesobridge::sdpd {
namespace {

/// How far apart two simulations of the same particles are: the largest difference of positions, momenta and
/// internal energies.
struct Apart {
  double q = 0, p = 0, eps = 0;
};
Apart apart(Simulation const& a, Simulation const& b) {
  auto const one = a.snapshot(), other = b.snapshot();
  Apart most;
  for (std::size_t i = 0; i < one.size(); ++i) {
    most.q = std::max(most.q, norm(a.box().minimum_image(one.q[i] - other.q[i])));
    most.p = std::max(most.p, norm(one.p[i] - other.p[i]));
    if (!one.eps.empty())
      most.eps = std::max(most.eps, std::abs(one.eps[i] - other.eps[i]));
  }
  return most;
}

SimulationSettings with_ser(SimulationSettings settings) {
  settings.scheme.pairs = "ser";
  settings.dt = 0.005;
  return settings;
}

std::vector<SimulationSettings> fluids() {
  auto across = dpd_fluid(), power = dpde_fluid(60, 0.01, 2), table = dpde_fluid(60),
       ideal = dpde_ideal(60, 0.01, 1);
  across.as<Dpd>().friction = PowerFriction(4.5, 2, 1, 2);
  power.as<Dpde>().friction = PowerFriction(4.5, 2, 1, 3);
  table.as<Dpde>().friction = TabulatedFriction({0.1, 0.6, 1.2}, {4, 2, 0}, {2, 1, 0});
  auto rare = dpde_fluid(20);
  rare.scheme.verlet_steps = 3;
  auto gas = ideal_gas(20, 0.01), dense = argon(1000, 0.01), seldom = argon(100, 0.01),
       still = argon(100, 0.01);
  gas.as<Sdpd>().kernel = "wendland-c4", gas.as<Sdpd>().zeta = 1e-3;
  dense.as<Sdpd>().density_correction = {.scale = 1.02, .self = 0.3};
  seldom.scheme.verlet_steps = 2;
  still.noise = false;
  for (auto* const of : {&gas, &dense, &seldom, &still})
    of->disorder = 0.1;
  return {dpd_fluid(), across, dpde_fluid(60), power, table, ideal, rare, gas, dense, seldom, still};
}

/// How far the momenta may be apart after one step. The built-in engine takes directions and friction in
/// single precision, the pairs inside LAMMPS in double: some 1e-7, and more by the root of a weight near the
/// cut-off that is right to 1e-7 of its largest, as tables and powers but the square are.
double one_step_apart(SimulationSettings const& settings) {
  auto const* const of = std::get_if<Dpde>(&settings.method);
  bool const square = !of || std::holds_alternative<PowerFriction>(of->friction);
  bool const power =
      of && square && std::abs(std::get<PowerFriction>(of->friction)(0.5).par - 4.5 / 4) > 1e-9;
  return square && !power ? 4e-7 : 2e-4;
}

TEST(LammpsEngine, GoesTheWayOfTheBuiltInEngine) {
  tests::ScratchDirectory const scratch;
  md::MpiWorld const world;
  constexpr std::uint64_t steps = 24;
  int compared = 0;
  for (auto const& fluid : fluids()) {
    auto const settings = with_ser(fluid);
    Simulation built_in(settings), inside(settings);
    LammpsEngine engine(world, settings, scratch / "lammps.log");
    built_in.advance(1), engine.advance(inside, 1);
    double const allowed = one_step_apart(settings);
    EXPECT_LT(apart(built_in, inside).p, allowed) << compared;
    built_in.advance(steps - 1);
    engine.advance(inside, 4), engine.advance(inside, steps - 5);
    EXPECT_EQ(inside.step(), steps);
    auto const difference = apart(built_in, inside);
    EXPECT_LT(difference.q, allowed) << compared;
    EXPECT_LT(difference.p, 10 * allowed) << compared;
    EXPECT_LT(difference.eps, 20 * allowed) << compared;
    auto other = settings;
    other.seed = settings.seed + 1;
    Simulation elsewhere(settings);
    LammpsEngine other_noise(world, other, scratch / "other.log");
    other_noise.advance(elsewhere, steps);
    if (fluid.noise) {
      EXPECT_GT(apart(built_in, elsewhere).p, 0.1) << compared;
    }
    ++compared;
  }
  EXPECT_EQ(compared, 11);
}

TEST(LammpsEngine, KeepsMomentumAndEnergyAcrossTheFacesOfTheBox) {
  tests::ScratchDirectory const scratch;
  md::MpiWorld const world;
  for (auto const* const scheme : {"ser", "ssa", "ams", "ems"}) {
    auto settings = with_ser(dpde_ideal(60, 0.005, 1)); // no forces: the step of friction and noise alone
    settings.scheme.pairs = scheme;
    Simulation simulation(settings);
    LammpsEngine engine(world, settings, scratch / "lammps.log");
    auto const before = simulation.observe();
    engine.advance(simulation, 200);
    auto const after = simulation.observe();
    EXPECT_NEAR(after.energy(), before.energy(), 1e-12 * before.energy() * 200) << scheme;
    EXPECT_LT(norm(after.momentum - before.momentum), 1e-10) << scheme;
    EXPECT_GT(std::abs(after.kinetic - before.kinetic), 1e-4 * before.kinetic) << scheme;
  }
}

/// The share of the particles whose momenta agree to single precision after a step of SSA by either engine.
double share_alike(SimulationSettings const& settings) {
  tests::ScratchDirectory const scratch;
  md::MpiWorld const world;
  Simulation built_in(settings), inside(settings);
  LammpsEngine engine(world, settings, scratch / "lammps.log");
  auto const begin = built_in.snapshot();
  built_in.advance(1), engine.advance(inside, 1);
  auto const one = built_in.snapshot(), other = inside.snapshot();
  double stepped = 0, alike = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    if (norm(one.p[i] - begin.p[i]) > 1e-3) {
      ++stepped;
      alike += norm(one.p[i] - other.p[i]) < 1e-5 &&
               (one.eps.empty() || std::abs(one.eps[i] - other.eps[i]) < 1e-4);
    }
  EXPECT_GT(stepped, 100);
  return alike / stepped;
}

/// Engines step pairs in orders of their own, which tells where pairs share a particle: seldom in a rare gas,
/// where half of the particles have no neighbour.
TEST(LammpsEngine, StepsPairsInTurnAsTheBuiltInEngineDoes) {
  auto gas = dpde_ideal(60, 0.01, 2);
  gas.rho = 0.1, gas.lattice = {16, 16, 16}, gas.disorder = 0.4;
  EXPECT_GT(share_alike(gas), 0.8);
  for (auto const* const scheme : {"ams", "ems"}) { // small particles, of whose steps some are not made
    auto small = gas;
    small.as<Dpde>().internal_energy = fitting::ConstantHeatCapacity(3);
    small.scheme.pairs = scheme, small.dt = 0.5;
    EXPECT_GT(share_alike(small), 0.8) << scheme;
  }
  auto cold = dpd_fluid();
  cold.as<Dpd>().potential = NoPotential{};
  cold.rho = 0.1, cold.lattice = {16, 16, 16}, cold.disorder = 0.4;
  EXPECT_GT(share_alike(cold), 0.8);
}

TEST(LammpsEngine, EndsWhereAStepInTurnLeavesNoTemperature) {
  tests::ScratchDirectory const scratch;
  md::MpiWorld const world;
  auto const settings = dpde_ideal(2, 0.5, 1); // steps too long for particles so small
  Simulation simulation(settings);
  LammpsEngine engine(world, settings, scratch / "lammps.log");
  try {
    engine.advance(simulation, 100);
    FAIL() << "energies below zero were taken";
  } catch (PhysicsError const& error) {
    std::string const what = error.what();
    EXPECT_NE(what.find("particle "), std::string::npos) << what;
    EXPECT_NE(what.find("its temperature is not positive there"), std::string::npos) << what;
  }
}

/// In short steps the order tells less and less: all at once and in turn come to the same.
TEST(LammpsEngine, StepsPairsOfSdpdInTurnAsAllAtOnceInShortSteps) {
  tests::ScratchDirectory const scratch;
  md::MpiWorld const world;
  double before = 1;
  for (double const dt : {1e-2, 1e-4, 1e-6}) {
    auto settings = with_ser(argon(100, dt));
    settings.dt = dt, settings.lattice = {11, 11, 11}, settings.disorder = 0.1;
    auto in_turn = settings;
    in_turn.scheme.pairs = "ssa";
    Simulation start(settings), all_at_once(settings), one_by_one(settings);
    LammpsEngine first(world, settings, scratch / "first.log"),
        second(world, in_turn, scratch / "second.log");
    first.advance(all_at_once, 1), second.advance(one_by_one, 1);
    auto const difference = apart(all_at_once, one_by_one), change = apart(start, all_at_once);
    double const share = std::max(difference.p / change.p, difference.eps / change.eps);
    EXPECT_GT(share, 1e-9);
    EXPECT_LT(share, before / 3) << dt;
    before = share;
  }
  EXPECT_LT(before, 0.01);
}

/// What SDPD loses of its energy is the forces' error, which the built-in engine has as well: friction and
/// noise give back all that they take.
TEST(LammpsEngine, DriftsAsTheBuiltInEngineDoes) {
  tests::ScratchDirectory const scratch;
  md::MpiWorld const world;
  auto settings = with_ser(argon(100, 0.02));
  settings.dt = 0.02;
  Simulation inside(settings), built_in(settings);
  LammpsEngine engine(world, settings, scratch / "lammps.log");
  auto const before = inside.observe();
  engine.advance(inside, 200), built_in.advance(200);
  auto const after = inside.observe();
  double const changed = after.energy() - before.energy(),
               as_built_in = built_in.observe().energy() - before.energy();
  EXPECT_GT(std::abs(as_built_in), 1e-7 * before.energy());
  EXPECT_NEAR(changed, as_built_in, 0.05 * std::abs(as_built_in));
  EXPECT_LT(norm(after.momentum - before.momentum), 1e-10);
}

/// Constants that the first rank's run has found count, whatever the engine was made with.
TEST(LammpsEngine, TakesTheConstantsOfDensitiesThatARunHasFound) {
  tests::ScratchDirectory const scratch;
  md::MpiWorld const world;
  auto const made_with = with_ser(argon(100, 0.01));
  auto found = made_with;
  found.as<Sdpd>().density_correction = {.scale = 1.05, .self = 0.4};
  Simulation built_in(found), inside(found), unsettled(found);
  LammpsEngine engine(world, made_with, scratch / "lammps.log"),
      other(world, made_with, scratch / "other.log");
  engine.settle(found);
  built_in.advance(8), engine.advance(inside, 8), other.advance(unsettled, 8);
  EXPECT_LT(apart(built_in, inside).p, 1e-5);
  EXPECT_GT(apart(built_in, unsettled).p, 1e-3);
}

TEST(LammpsEngine, HasPowersInDoublePrecision) {
  int compared = 0;
  for (double const s : {0.1, 0.7, 3.0, 20.0})
    for (double x = 1; x > 1e-12; x *= 0.77, ++compared) {
      double const exact = std::pow(x, s);
      EXPECT_NEAR(power(broadcast(x), s)[3], exact, 1e-13 * exact) << x << " " << s;
    }
  EXPECT_GT(compared, 400);
}

TEST(LammpsEngine, NamesWhatItCannotRun) {
  auto const refused = [](SimulationSettings const& settings) {
    auto const found = lammps_refusals(settings);
    return found.empty() ? std::string() : found.front();
  };
  EXPECT_EQ(refused(with_ser(dpd_fluid())), "");
  EXPECT_EQ(refused(dpd_fluid()), ""); // one pair after the other
  auto narrow = dpd_fluid();
  narrow.lattice = {5, 5, 5};
  EXPECT_NE(refused(narrow).find("scheme.name: pairs in turn"), std::string::npos);
  for (auto const* const name : {"ssa", "ams", "ems"}) {
    auto in_turn = dpde_fluid(60);
    in_turn.scheme.pairs = name;
    EXPECT_EQ(refused(in_turn), "");
  }
  auto implicit = dpde_fluid(60);
  implicit.scheme.pairs = "implicit";
  EXPECT_NE(refused(implicit).find("scheme.name: the LAMMPS engine has"), std::string::npos);
  EXPECT_EQ(refused(with_ser(argon(100, 0.01))), "");
  EXPECT_NE(refused(with_ser(burning_nitromethane(100, 0.01))).find("reaction"), std::string::npos);
  EXPECT_EQ(lammps_refusals(burning_nitromethane(100, 0.01)).size(), 1u);
  auto conducting = with_ser(with_pair_conduction(dpde_fluid(60), PowerFriction(1, 0, 1, 2)));
  EXPECT_NE(refused(conducting).find("conduction"), std::string::npos);
  EXPECT_NE(refused(with_conduction(with_ser(argon(100, 0.01)), 1)).find("conduction"), std::string::npos);
  auto strang = with_ser(dpd_fluid());
  strang.scheme.splitting = Splitting::strang;
  EXPECT_NE(refused(strang).find("splitting"), std::string::npos);
  EXPECT_THROW(refuse_for_lammps(implicit), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
