#include "sdpd/reaction/reaction.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/reaction/rates.hpp"
#include "sdpd/system/sum_over_particles.hpp"
#include "sdpd/thermodynamics/reacting.hpp"

namespace mesobridge::sdpd {
namespace {

constexpr double most_parts = 1e5; ///< of a time step

/// d lambda/dt of particle i.
double speed(System const& system, std::size_t i) {
  auto const& of = system.particles;
  auto const [forward, backward] = system.rates[of.id[i]];
  return forward * (1 - of.progress[i]) - backward * of.progress[i];
}

/// The largest over the particles of f(i) >= 0.
template <class F>
double largest(System const& system, F const& f) {
  return fold_over_particles(system, f, 0, [](double most, double value) {
    return value <= most ? most : value; // which NaN is not
  });
}

/// In how many parts of a time the rates of now may be taken as constant.
template <class Law>
double parts_of(System const& system, Law const& law, double time) {
  auto const& of = system.particles;
  double const parts =
      std::ceil(time * largest(system, [&](std::size_t i) {
                  double const c = 1 / (of.caloric[i].inverse_C_0 * of.mass_of(i));
                  return std::abs(speed(system, i)) / law.longest_change(of.T[i], c, system.reaction->heat);
                }));
  if (!(parts <= most_parts))
    throw PhysicsError(
        fmt::format("step {} (dt = {:.6g} reduced): the reaction is so fast that it would take "
                    "{} parts of the time step; take a shorter one",
                    system.step, system.dt, parts));
  return std::max(parts, 1.0);
}

/// lambda and eps after the time h at the rates, from those of the start: exactly, d lambda/dt = A - (A + B)
/// lambda (sdpd/README.md, Eq. (S65)).
void advance(System& system, double h) {
  auto& of = system.particles;
  auto const& start = system.reaction_start;
  for_each_index(system.size(), system.threads, [&](std::size_t i) {
    auto const [A, B] = system.rates[of.id[i]];
    double const both = A + B, before = start.progress[i];
    double const after = both > 0 ? before + (A / both - before) * -std::expm1(-both * h) : before;
    of.progress[i] = after;
    of.eps[i] = start.eps[i] + system.reaction->heat * of.mass_of(i) * (after - before);
  });
}

void note_start(System& system) {
  auto& start = system.reaction_start;
  start.progress.resize(system.size()), start.eps.resize(system.size());
  for_each_index(system.size(), system.threads, [&](std::size_t i) {
    start.progress[i] = system.particles.progress[i], start.eps[i] = system.particles.eps[i];
  });
}

/// A change of lambda whose heat changes no rate by more than about 1e-9.
constexpr double without_heat = 1e-10;

/// T, S and P of the particles whose lambda has changed by more than so much since the start.
void follow(System& system, double change) {
  Failure failure;
  auto const& of = system.particles;
  auto const& start = system.reaction_start;
  auto const changed = [&](std::size_t i) {
    return std::abs(of.progress[i] - start.progress[i]) > change &&
           (of.eps[i] != start.eps[i] || of.progress[i] >= pure_below);
  };
  for_each_range(system, [&](Range range) {
    for (std::size_t begin = range.begin, end = begin; begin < range.end; begin = end) {
      bool const some = changed(begin);
      while (end < range.end && changed(end) == some)
        ++end;
      if (some)
        system.thermodynamics->from_energy(system.particles, {begin, end}, failure);
    }
  });
  system.stop_at(failure);
}

/// The rates of a part at its beginning, and again in its middle where the integrator asks for them.
template <class Law>
void react_from_the_start(System& system, Law const& law, double dt) {
  for (double left = dt; left > 0;) {
    note_start(system);
    find_rates(system, law, left);
    double const parts = parts_of(system, law, left), h = left / parts;
    if (system.reaction->integrator == RateIntegrator::midpoint) {
      advance(system, 0.5 * h);
      follow(system, without_heat);
      find_rates(system, law, h);
    }
    advance(system, h);
    left = parts > 1 ? left - h : 0;
    if (left > 0)
      follow(system, 0);
  }
}

/// The rates after half of one of `parts` of the time `left` from the start at those of now. They ask for no
/// pressures, and a time step that is one part for no other heat capacities.
void find_rates_in_the_middle(System& system, SecondOrder const& law, double left, double parts) {
  double const h = left / parts;
  advance(system, 0.5 * h);
  if (parts > 1)
    thermodynamics_from_energy(system);
  else
    temperature_from_energy(system);
  find_rates(system, law, h);
}

/// One sum over pairs a part: what leads to its middle are the rates in the middle of the part before, where
/// they are known (sdpd/README.md, Eq. (S100)).
void react_by_earlier_rates(System& system, SecondOrder const& law, double dt, bool known) {
  for (double left = dt; left > 0; known = true) {
    note_start(system);
    if (!known) {
      thermodynamics_from_energy(system);
      find_rates(system, law, left);
    }
    double parts = parts_of(system, law, left);
    find_rates_in_the_middle(system, law, left, parts);
    if (known)
      if (double const more = parts_of(system, law, left); more > parts) { // it has become faster
        parts = more;
        find_rates_in_the_middle(system, law, left, parts);
      }
    double const h = left / parts;
    advance(system, h);
    left = parts > 1 ? left - h : 0;
  }
}

template <class Law>
void react(System& system, Law const& law, double dt, bool) {
  react_from_the_start(system, law, dt);
}
void react(System& system, SecondOrder const& law, double dt, bool rates_are_known) {
  if (looks_back(*system.reaction))
    react_by_earlier_rates(system, law, dt, rates_are_known);
  else
    react_from_the_start(system, law, dt);
}

/// A front that nobody asks.
void react(System& system, PrescribedBurn const& law, double, bool) {
  auto& of = system.particles;
  for_each_index(system.size(), system.threads, [&](std::size_t i) {
    double const before = of.progress[i];
    of.progress[i] = law.progress(before, of.q[i].z, system.reaction_time);
    of.eps[i] += system.reaction->heat * of.mass_of(i) * (of.progress[i] - before);
  });
}

/// Sees to it that mixtures have a state next time, too; energies and densities stay as they are, but for the
/// heat of what burns up.
void keep_balances(System& system) {
  auto& of = system.particles;
  auto const follow = [&](std::size_t i, MixtureFate fate) {
    switch (fate) {
    case MixtureFate::goes_on:
      break;
    case MixtureFate::burns_up:
      of.eps[i] += system.reaction->heat * of.mass_of(i) * (1 - of.progress[i]);
      of.progress[i] = 1;
      break;
    case MixtureFate::counts_as_reactant:
      of.log_density_ratio[i] = no_product;
      break;
    case MixtureFate::mixes_again:
      of.log_density_ratio[i] = 0; // a search will find it
    }
  };
  for_each_range(system, [&](Range range) {
    std::array<MixtureFate, range_length> fates;
    system.thermodynamics->fates(of, range, std::span(fates).first(range.end - range.begin));
    for (std::size_t i = range.begin; i < range.end; ++i)
      follow(i, fates[i - range.begin]);
  });
}

} // namespace

bool looks_back(Reaction const& reaction) {
  return std::holds_alternative<SecondOrder>(reaction.kinetics) &&
         reaction.integrator == RateIntegrator::midpoint;
}

SubStep reaction(System const&, double dt) {
  using enum Conserved;
  return {.name = "reaction", .conserves = {positions, momenta, energy}, .run = [=](System& system) {
            if (system.walls_held)
              return;
            bool const known = system.reaction_time > 0;
            system.reaction_time += dt;
            std::visit([&](auto const& law) { react(system, law, dt, known); }, system.reaction->kinetics);
            keep_balances(system);
          }};
}

} // namespace mesobridge::sdpd
