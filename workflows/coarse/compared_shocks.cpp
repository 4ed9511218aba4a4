#include "workflows/coarse/compared_shocks.hpp"
#include "fitting/particle_model_file.hpp"
#include "md/error.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/shock_study/shock_tables.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

constexpr double ahead = 8; ///< mean distances of beads before the front

/// Mean over the distances ahead of the front, whose errors are not independent.
cg::Estimate ahead_of(ShockOfRun const& shock, std::vector<cg::Estimate> const& values, double spacing) {
  double sum = 0, errors = 0, n = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (shock.depth[k] > ahead * spacing)
      sum += values[k].mean, errors += values[k].se, ++n;
  if (n == 0)
    throw PhysicsError("no slice is ahead of the front for long enough: take a longer box, --shock-along");
  return {sum / n, errors / n};
}

cg::Estimate energy_of(ShockedState const& s, double mass) {
  double const volume = 1 / s.rho_0.mean - 1 / s.rho.mean, P = (s.P.mean + s.P_0.mean) / 2;
  double const of_P = volume / 2 * std::hypot(s.P.se, s.P_0.se),
               of_volume =
                   P * std::hypot(s.rho_0.se / std::pow(s.rho_0.mean, 2), s.rho.se / std::pow(s.rho.mean, 2));
  return {mass * P * volume, mass * std::hypot(of_P, of_volume)};
}

cg::Estimate heat_of(ShockedState const& s, fitting::AnyInternalEnergy const& internal_energy) {
  return std::visit(
      [&](auto const& of) {
        double const heat = of.energy(s.T.mean) - of.energy(s.T_0.mean) + 1.5 * (s.T.mean - s.T_0.mean);
        return cg::Estimate{heat, (of.heat_capacity(s.T.mean) + 1.5) * std::hypot(s.T.se, s.T_0.se)};
      },
      internal_energy);
}

/// A row of the comparison.
struct Compared {
  char const *key, *what;
  cg::Estimate ShockedState::*value;
};
constexpr std::array<Compared, 10> rows{
    {{"rho_ahead", "density ahead", &ShockedState::rho_0},
     {"P_ahead", "pressure ahead", &ShockedState::P_0},
     {"T_ahead", "temperature ahead", &ShockedState::T_0},
     {"v_S", "velocity of the front", &ShockedState::v_S},
     {"rho", "density behind", &ShockedState::rho},
     {"P", "pressure behind", &ShockedState::P},
     {"T", "temperature behind, of beads and of internal energies", &ShockedState::T},
     {"T_motion", "the same of the centres' motion", &ShockedState::T_motion},
     {"energy", "energy given to a molecule", &ShockedState::energy},
     {"heat", "heat in it by S(U)", &ShockedState::heat}}};

double apart(cg::Estimate const& a, cg::Estimate const& b) {
  return (b.mean - a.mean) / std::hypot(a.se, b.se);
}

Table table_of(ComparedShocks const& shocks) {
  Table table{
      .header = {"", "molecules", "particles", "difference", "in standard errors"},
      .rows = {},
      .caption = "Of the front and of both sides of it. The energy is what a steady shock gives a molecule "
                 "that the piston has brought to its velocity (cg/README.md, Eq. (C44)), the heat what of it "
                 "raises the temperature (Eq. (C45)); the rest is stored in the places of the molecules."};
  for (auto const& [key, what, value] : rows) {
    auto const &a = (*shocks.of_melt).*value, &b = (*shocks.of_particles).*value;
    table.rows.push_back({what, with_error_text(a), with_error_text(b),
                          fmt::format("{:+.2f} %", 100 * (b.mean / a.mean - 1)),
                          fmt::format("{:+.1f}", apart(a, b))});
  }
  return table;
}

Series profile(std::string label, ShockOfRun const& shock, std::vector<cg::Estimate> const& values,
               SeriesStyle style) {
  Series series{.label = std::move(label), .x = shock.depth, .y = {}, .y_error = {}, .style = style};
  for (auto const& value : values) {
    series.y.push_back(value.mean);
    if (style == SeriesStyle::points)
      series.y_error.push_back(value.se);
  }
  return series;
}

std::string drawing(std::string const& name, std::string const& title, std::string const& label,
                    std::vector<Series> series) {
  Plot plot{.name = "shockof" + name,
            .title = title,
            .x = {.label = "distance from the front"},
            .panels = {Panel{}}};
  plot.panels[0].y.label = label, plot.panels[0].series = std::move(series);
  return draw_svg(plot);
}

Figure figure_of(ShockOfRun const& melt, ShockOfRun const& particles) {
  auto const both = [&](auto member) {
    return std::vector<Series>{profile("molecules", melt, melt.*member, SeriesStyle::points),
                               profile("particles", particles, particles.*member, SeriesStyle::lines)};
  };
  std::vector<Series> temperatures{
      profile("beads", melt, melt.T, SeriesStyle::points),
      profile("centres of molecules", melt, melt.T_motion, SeriesStyle::points),
      profile("internal energies of particles", particles, particles.T, SeriesStyle::lines),
      profile("motion of particles", particles, particles.T_motion, SeriesStyle::dashes)};
  return {{drawing("rho", "Density", "ρ", both(&ShockOfRun::rho)),
           drawing("v", "Velocity", "v", both(&ShockOfRun::velocity)),
           drawing("P", "Pressure", "P", both(&ShockOfRun::P)),
           drawing("T", "Temperature", "T", std::move(temperatures))},
          "Means over the frames in the frame of the front, where the velocity falls through v_P/2."};
}

/// What the numbers say of the potential and of S(U).
std::string reading(ComparedShocks const& shocks) {
  auto const &a = *shocks.of_melt, &b = *shocks.of_particles;
  auto const share = [](ShockedState const& of) { return 100 * of.heat.mean / of.energy.mean; };
  return fmt::format(
      "The shock gives a molecule {} and a particle {} of energy; by S(U) {:.0f} % of it are heat in "
      "the melt and {:.0f} % in the particles. The temperature rises by {:.3f} and by {:.3f}. A "
      "potential between centres is a free energy: what it stores is heat where the forces between "
      "molecules come from the entropy of their places.",
      with_error_text(a.energy), with_error_text(b.energy), share(a), share(b), a.T.mean - a.T_0.mean,
      b.T.mean - b.T_0.mean);
}

} // namespace

ShockedState shocked_state(ShockOfRun const& shock, double spacing, double mass,
                           fitting::AnyInternalEnergy const& internal_energy) {
  ShockedState state{.rho_0 = ahead_of(shock, shock.rho, spacing),
                     .P_0 = ahead_of(shock, shock.P, spacing),
                     .T_0 = ahead_of(shock, shock.T, spacing),
                     .v_S = shock.measured.v_S,
                     .rho = shock.mass_per_volume,
                     .P = shock.measured.P,
                     .T = shock.measured.T,
                     .T_motion = shock.T_kin,
                     .energy = {},
                     .heat = {}};
  state.energy = energy_of(state, mass), state.heat = heat_of(state, internal_energy);
  return state;
}

ComparedShocks read_shocks(StarToDpdePlan const& plan, std::filesystem::path const& directory) {
  auto const model_file = model_stages(plan, directory).back().product;
  auto const model = fitting::parse_particle_model(read_text_file(model_file), model_file.string());
  RunFolder const run(directory / "shock/run");
  Scene const scene = load_scene(run.scene());
  auto of_melt = shock_data_of(read_piston(directory / "shock/melt/piston-shock.h5"));
  auto of_run = shock_data_of(Store(run.run_file(), Store::Mode::read), scene, settings_of(scene, 1));
  double const spacing = std::cbrt(1 / plan.melt.rho), mass = plan.melt.star.atoms();
  of_melt.scale.spacing = spacing;
  ComparedShocks shocks;
  shocks.melt = shock_in(of_melt);
  if (of_run) {
    of_run->scale.spacing = spacing;
    shocks.particles = shock_in(*of_run);
  }
  if (shocks.melt)
    shocks.of_melt = shocked_state(*shocks.melt, spacing, mass, model.internal_energy);
  if (shocks.particles)
    shocks.of_particles = shocked_state(*shocks.particles, spacing, mass, model.internal_energy);
  return shocks;
}

Json shocks_json(ComparedShocks const& shocks) {
  Json json;
  for (auto const& [key, what, value] : rows) {
    if (shocks.of_melt)
      put(json, std::string(key) + "_md", (*shocks.of_melt).*value);
    if (shocks.of_particles)
      put(json, std::string(key) + "_dpde", (*shocks.of_particles).*value);
    if (shocks.both())
      json[std::string(key) + "_standard_errors_apart"] =
          apart((*shocks.of_melt).*value, (*shocks.of_particles).*value);
  }
  return json;
}

Section shocks_section(ComparedShocks const& shocks, double v_P, std::vector<Stage> const& stages) {
  Section section{fmt::format("A piston at {:g}", v_P), {}};
  if (!shocks.both()) {
    section.content.emplace_back(Paragraph{
        fmt::format("There is no steady shock in the box of the {}: take a longer one, --shock-along.",
                    shocks.of_melt ? "particles" : "molecules")});
    return section;
  }
  section.content = {Paragraph{reading(shocks)}, table_of(shocks),
                     figure_of(*shocks.melt, *shocks.particles)};
  for (auto const& stage : stages)
    section.content.emplace_back(Paragraph{"`" + line_of(stage) + "`"});
  section.content.emplace_back(Files{{{"shock/melt/report.html", "the piston in the melt"},
                                      {"shock/run/report.html", "the piston in the particles"}}});
  return section;
}

} // namespace mesobridge::workflows
