#include "sdpd/thermodynamics/reacting.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

// What becomes of mixtures whose parts come to the end of their balance (sdpd/README.md, Eqs. (S66), (S67)).

namespace mesobridge::sdpd {
namespace {

/// One particle of nitromethane and its products, which is expanded and compressed without loss of heat.
class OneMixture {
 public:
  OneMixture(double lambda, double rho, double T)
      : units_(burning_nitromethane(100, 0.01).units()),
        thermodynamics_(make_reacting_thermodynamics(
            {fitting::material("nitromethane").eos, fitting::material("nitromethane-products").eos}, units_,
            CentreOfMass::bulk)) {
    of.resize(1, {.reacts = true});
    of.id = {0}, of.progress = {lambda}, of.rho = {rho / units_.density}, of.T = {T / units_.temperature};
    of.log_density_ratio = {0};
    thermodynamics_->energy_from_temperature(of, {0, 1}, failure);
    thermodynamics_->from_energy(of, {0, 1}, failure);
  }
  MixtureFate fate() const { return thermodynamics_->fate(of, 0); }
  Thermodynamics const& thermodynamics() const { return *thermodynamics_; }
  double density() const { return of.rho[0] * units_.density; }
  double energy() const { return of.eps[0] * units_.specific_energy(); }
  double pressure() const { return of.P[0] * units_.pressure(); }

  /// By an isentropic change of the density, as in a step; whether there is a state.
  bool change_density(double factor) {
    of.rho[0] *= factor;
    thermodynamics_->from_entropy(of, {0, 1}, failure);
    return !failure.any();
  }
  void find_by_energy() { thermodynamics_->from_energy(of, {0, 1}, failure); }

  Particles of;
  Failure failure;

 private:
  ReducedUnits units_;
  std::unique_ptr<Thermodynamics const> thermodynamics_;
};

// It is told in time: the mixture still follows several steps of a fast expansion.
TEST(MixtureFate, BurnsUpBeforeTheReactantsBalanceEnds) {
  int told = 0;
  for (double const lambda : {0.5, 0.9, 0.994}) {
    OneMixture mixture(lambda, 1500, 4700);
    ASSERT_FALSE(mixture.failure.any()) << mixture.failure.message();
    EXPECT_EQ(mixture.fate(), MixtureFate::goes_on);
    while (mixture.fate() == MixtureFate::goes_on)
      ASSERT_TRUE(mixture.change_density(0.998)) << lambda << ": not told at " << mixture.density();
    EXPECT_EQ(mixture.fate(), MixtureFate::burns_up);
    EXPECT_GT(mixture.density(), 700);
    for (int step = 0; step < 3; ++step)
      EXPECT_TRUE(mixture.change_density(0.998)) << lambda << " at " << mixture.density();
    bool ends = false; // and it would have ended soon
    for (int step = 0; step < 400 && !ends; ++step)
      ends = !mixture.change_density(0.998);
    EXPECT_TRUE(ends) << lambda;
    ++told;
  }
  EXPECT_EQ(told, 3);
}

/// Notes what the particle is at each density until its fate is told, and two that wait.
void note_way(Particles& all, double lambda, double rho, double T, double factor) {
  OneMixture mixture(lambda, rho, T);
  auto const note = [&](double log_density_ratio) {
    all.progress.push_back(lambda), all.rho.push_back(mixture.of.rho[0]), all.T.push_back(mixture.of.T[0]);
    all.eps.push_back(mixture.of.eps[0]), all.log_density_ratio.push_back(log_density_ratio);
  };
  note(no_product), note(0);
  for (;;) {
    note(mixture.of.log_density_ratio[0]);
    if (mixture.fate() != MixtureFate::goes_on || all.rho.size() % 97 == 0)
      return note(no_product);
    ASSERT_TRUE(mixture.change_density(factor));
  }
}

// Many at once, as steps ask for them, and one by one: in ranges that begin and end anywhere.
TEST(MixtureFate, IsTheSameManyAtOnce) {
  Particles all;
  note_way(all, 0.9, 1500, 4700, 0.99);
  note_way(all, 0.003, 1300, 600, 1.01);
  note_way(all, 0.3, 1500, 3000, 1.001); // of a progress at which no balance comes to an end
  note_way(all, 0.994, 1500, 4700, 0.99);
  OneMixture const any(0.5, 1500, 4700);
  std::array<int, 4> seen{};
  std::size_t const n = all.rho.size();
  for (auto const& range : {Range{0, n}, Range{3, n - 2}, Range{5, 6}, Range{1, 14}}) {
    std::vector<MixtureFate> fates(range.end - range.begin);
    any.thermodynamics().fates(all, range, fates);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      auto const alone = any.thermodynamics().fate(all, static_cast<Index>(i));
      EXPECT_EQ(fates[i - range.begin], alone) << i;
      ++seen[static_cast<std::size_t>(alone)];
    }
  }
  for (int const of_each : seen)
    EXPECT_GT(of_each, 0);
  EXPECT_GT(n, 50u);
}

TEST(MixtureFate, LetsATraceOfProductWaitWhereItsModelEnds) {
  OneMixture mixture(0.003, 1300, 600);
  ASSERT_FALSE(mixture.failure.any()) << mixture.failure.message();
  EXPECT_EQ(mixture.fate(), MixtureFate::goes_on);
  while (mixture.fate() == MixtureFate::goes_on)
    ASSERT_TRUE(mixture.change_density(1.002)) << "not told at " << mixture.density();
  EXPECT_EQ(mixture.fate(), MixtureFate::counts_as_reactant);
  double const eps = mixture.of.eps[0], P = mixture.pressure(), highest = mixture.density();
  mixture.of.log_density_ratio[0] = no_product;
  mixture.find_by_energy();
  ASSERT_FALSE(mixture.failure.any()) << mixture.failure.message();
  EXPECT_EQ(mixture.of.eps[0], eps);
  EXPECT_NEAR(mixture.pressure(), P, 0.05 * P); // of 70 GPa: it jumps
  EXPECT_EQ(mixture.fate(), MixtureFate::goes_on);
  EXPECT_TRUE(mixture.change_density(1.05)); // pure, it can go on
  while (mixture.fate() == MixtureFate::goes_on)
    ASSERT_TRUE(mixture.change_density(0.998)) << "never again at " << mixture.density();
  EXPECT_EQ(mixture.fate(), MixtureFate::mixes_again);
  EXPECT_LT(mixture.density(), highest);
  mixture.of.log_density_ratio[0] = 0;
  mixture.find_by_energy();
  EXPECT_FALSE(mixture.failure.any()) << mixture.failure.message();
  EXPECT_EQ(mixture.fate(), MixtureFate::goes_on);
}

/// Compressed until it would be told to wait, and a step back.
void bring_to_the_edge(OneMixture& mixture) {
  while (mixture.fate() == MixtureFate::goes_on)
    ASSERT_TRUE(mixture.change_density(1.002));
  ASSERT_TRUE(mixture.change_density(1 / 1.002));
  ASSERT_EQ(mixture.fate(), MixtureFate::goes_on);
}

// As before a wall, where a front that comes back compresses it by a tenth between two looks.
TEST(MixtureFate, ATraceOfProductMayComeToItsEndWithinOneStep) {
  fitting::Hz const reactant(fitting::nitromethane_parameters);
  int ended = 0;
  for (double const lambda : {2e-4, 0.003}) {
    OneMixture mixture(lambda, 1300, 600);
    bring_to_the_edge(mixture);
    double const e = mixture.energy(), rho = mixture.density();
    EXPECT_TRUE(mixture.change_density(1.05)) << mixture.failure.message();
    EXPECT_EQ(mixture.of.log_density_ratio[0], no_product);
    // From the state that it left, as the pure reactant does without loss of heat.
    double const expected = reactant.energy_from_entropy(reactant.entropy(e, rho), mixture.density());
    EXPECT_NEAR(mixture.energy(), expected, 1e-8 * (expected - e));
    EXPECT_GT(expected - e, 0.1 * e);
    EXPECT_NEAR(mixture.pressure() / reactant.pressure(expected, mixture.density()), 1, 1e-9);
    mixture.find_by_energy(); // and so it goes on
    EXPECT_FALSE(mixture.failure.any()) << mixture.failure.message();
    ++ended;
  }
  EXPECT_EQ(ended, 2);
}

// Nothing is known of where an entropy that was changed comes from: the run ends, with the cause.
TEST(MixtureFate, AnEntropyWithoutAMixtureIsRefused) {
  OneMixture mixture(0.003, 1300, 600);
  bring_to_the_edge(mixture);
  mixture.of.S[0] -= 2000; // of some thousands
  EXPECT_FALSE(mixture.change_density(1));
  EXPECT_NE(mixture.failure.message().find("mixture of progress"), std::string::npos);
}

} // namespace
} // namespace mesobridge::sdpd
