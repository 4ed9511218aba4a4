#include "sdpd/setup/calibrate_density.hpp"
#include "fitting/eos/evaluate.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/observe/runaway.hpp"
#include "sdpd/setup/equilibration.hpp"

namespace mesobridge::sdpd {
namespace {

/// Stages and their shares of the steps; in front of each a third of its length for the equilibrium.
constexpr std::array<double, 5> shares{0.0625, 0.0625, 0.125, 0.25, 0.5};
constexpr double settling = 0.25;

/// Below this ratio of the particles' pressure to rho (dP/drho)_T an error of the density by one per cent
/// would change the scale by more than 20 %.
constexpr double least_pressure = 0.05;

/// The largest box that is run, in particles; boxes must hold the kernel twice.
constexpr double enough_particles = 1000;

/// What the particles' equation of state says at the set density and temperature, reduced.
struct Target {
  double P;            ///< of the fluid
  double motion;       ///< n k_B T
  double bulk_modulus; ///< rho (dP/drho)_T of the particles
};

Target target_of(SimulationSettings const& s) {
  require_one_species(s, "pressure");
  auto const units = s.units();
  auto const& fluid = s.as<Sdpd>();
  double const motion = s.noise ? 1 / fluid.K : 0;
  return std::visit(
      [&](auto const& eos) {
        auto const isochore = eos.isochore(s.rho);
        double const P = isochore.pressure(s.T) / units.pressure();
        double const modulus = s.rho * isochore.pressure_density_slope(s.T) / units.pressure();
        return Target{P, motion, modulus - (fluid.centre_of_mass == CentreOfMass::free ? motion : 0)};
      },
      fluid.eos);
}

/// The particles' part of the pressure against their bulk modulus.
double relative_pressure(Target const& target) {
  return (target.P - target.motion) / target.bulk_modulus;
}

/// The lattice of the box that is run, which is periodic.
std::array<std::uint32_t, 3> small_box(SimulationSettings const& s) {
  constexpr double widest_skin = 0.7;
  double count = 1;
  for (auto const n : s.lattice)
    count *= n;
  auto const side = static_cast<std::uint32_t>(
      std::max(std::round(std::cbrt(enough_particles)), std::ceil(2 * (s.range() + widest_skin))));
  bool const periodic = periodic_axes(s.faces) == std::array{true, true, true};
  if (!periodic || (count > enough_particles && count > double(side) * side * side))
    return {side, side, side};
  return s.lattice;
}

/// One stage's series.
struct Samples {
  std::vector<double> rho, P, response;
};

class Calibration {
 public:
  Calibration(SimulationSettings const& settings, ScaleCondition condition,
              std::function<bool()> const& keep_going)
      : condition_(condition), keep_going_(keep_going), dt_(settings.dt), target_(target_of(settings)),
        simulation_(settings), correction_(settings.as<Sdpd>().density_correction),
        W_0_(std::visit([](auto const& kernel) { return kernel.W(0.0); },
                        make_kernel(settings.as<Sdpd>().kernel, settings.range()))) {
    check_calibration(settings, condition);
  }

  DensityCalibration run(std::uint64_t steps) {
    DensityCalibration result;
    for (double const share : shares) {
      auto const length =
          std::max<std::uint64_t>(32, std::llround(share * static_cast<double>(steps) / (1 + settling)));
      auto const settle = std::max<std::uint64_t>(32, std::llround(settling * static_cast<double>(length)));
      equilibrate(simulation_, settle, keep_going_);
      auto const samples = sample(length);
      result = improved(samples);
      correction_ = result.constants;
      simulation_.set_density_correction(correction_);
    }
    result.particles = simulation_.size();
    result.steps = simulation_.step();
    return result;
  }

 private:
  Samples sample(std::uint64_t steps) {
    constexpr std::uint64_t every = 2, response_every = 8;
    Samples samples;
    for (std::uint64_t k = 0; k < steps; k += every) {
      simulation_.advance(every);
      auto const now = simulation_.observe();
      if (!(now.T_kin < absurd_temperature(simulation_.units().K)))
        refuse_runaway(now, dt_);
      samples.rho.push_back(now.rho), samples.P.push_back(now.P);
      if (condition_ == ScaleCondition::response)
        samples.response.push_back(k % response_every == 0 ? simulation_.compression_response()
                                                           : samples.response.back());
      if (k % 32 == 0 && !keep_going_())
        throw Interrupted("stopped while the densities were calibrated");
    }
    return samples;
  }

  /// ln(c'/c) for each sample, linear about the means, so that its mean has the error of the scale.
  std::vector<double> log_scale(Samples const& s) const {
    std::vector<double> change(s.rho.size());
    if (condition_ == ScaleCondition::response) {
      double const mean = cg::estimate_mean(s.response).mean;
      for (std::size_t k = 0; k < change.size(); ++k)
        change[k] = -std::log(mean) - (s.response[k] / mean - 1);
      return change;
    }
    // At given positions the virial goes as c P(rho)/rho^2.
    double const needed = target_.P - target_.motion, slope = target_.bulk_modulus - 2 * needed;
    auto at_mean_density = [&](double P, double rho) { return P - target_.motion + slope * (1 - rho); };
    double const mean = at_mean_density(cg::estimate_mean(s.P).mean, cg::estimate_mean(s.rho).mean);
    if (!(mean > 0.3 * needed))
      throw PhysicsError(fmt::format("no constants of the densities give the pressure {:.4g} (reduced): the "
                                     "particles' pressure at the mean density is {:.4g}",
                                     target_.P, mean));
    for (std::size_t k = 0; k < change.size(); ++k)
      change[k] = std::log(needed / mean) - (at_mean_density(s.P[k], s.rho[k]) / mean - 1);
    return change;
  }

  DensityCalibration improved(Samples const& s) const {
    auto const change = log_scale(s);
    auto const [c, eps] = correction_;
    double const factor = std::exp(cg::estimate_mean(change).mean), c_new = c * factor;
    std::vector<double> self(s.rho.size());
    for (std::size_t k = 0; k < self.size(); ++k) {
      double const sum = (s.rho[k] - (c - eps) * W_0_) / c; // over the neighbours, for c = 1
      double const c_k = c_new * (1 + change[k] - std::log(factor));
      self[k] = c_k - (1 - c_k * sum) / W_0_;
    }
    auto const scale = cg::estimate_mean(change), self_term = cg::estimate_mean(self);
    DensityCalibration result{.constants = {c_new, self_term.mean},
                              .scale_se = c_new * scale.se,
                              .self_se = self_term.se,
                              .rho = cg::estimate_mean(s.rho),
                              .P = cg::estimate_mean(s.P),
                              .P_eos = target_.P};
    if (!(std::abs(result.constants.self) < c_new))
      throw PhysicsError(
          fmt::format("the densities cannot be calibrated: the self term would have to be {:.4g} "
                      "with the scale {:.4g}, and must be smaller than that",
                      result.constants.self, c_new));
    return result;
  }

  ScaleCondition condition_;
  std::function<bool()> const& keep_going_;
  double dt_;
  Target target_;
  Simulation simulation_;
  DensityCorrection correction_;
  double W_0_;
};

} // namespace

void check_calibration(SimulationSettings const& settings, ScaleCondition condition) {
  auto const target = target_of(settings);
  require(condition != ScaleCondition::pressure || relative_pressure(target) > least_pressure,
          "pressure of the particles in units of rho (dP/drho)_T", relative_pressure(target),
          fmt::format("must be > {} to calibrate the densities by the pressure; calibrate them by their "
                      "response to compression",
                      least_pressure));
}

std::optional<ScaleCondition> suitable_condition(SimulationSettings const& settings) {
  auto const target = target_of(settings);
  double const pressure = relative_pressure(target);
  if (!(target.bulk_modulus > 0) || pressure < -least_pressure)
    return std::nullopt;
  return pressure > least_pressure ? ScaleCondition::pressure : ScaleCondition::response;
}

double calibrated_particles(SimulationSettings const& s) {
  auto const small = small_box(s);
  return double(small[0]) * small[1] * small[2];
}

DensityCalibration calibrate_density(SimulationSettings settings, ScaleCondition condition,
                                     std::uint64_t steps, std::function<bool()> const& keep_going) {
  check(settings);
  settings.lattice = small_box(settings);
  settings.faces = {};
  return Calibration(settings, condition, keep_going).run(steps);
}

} // namespace mesobridge::sdpd
