#include "sdpd/scheme/list.hpp"
#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"
#include <fmt/ranges.h>

namespace mesobridge::workflows {

namespace {

std::string pair_scheme_summaries() {
  std::vector<std::string> words;
  for (auto const& scheme : sdpd::pair_integrators())
    words.push_back(scheme.name + ": " + scheme.summary);
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string conservative_summaries() {
  std::vector<std::string> words;
  for (auto const& integrator : sdpd::conservative_integrators())
    words.push_back(integrator.name + ": " + integrator.summary);
  return fmt::format("{}", fmt::join(words, "; "));
}

} // namespace

std::vector<SceneKey> scheme_keys() {
  Table const scheme{"scheme", &Scene::scheme};
  return {
      scheme("name", &Scene::Scheme::name,
             "what is done with the fluctuation and dissipation of a pair: " + pair_scheme_summaries())
          .choices(sdpd::pair_integrator_names()),
      scheme(
          "dt", &Scene::Scheme::dt,
          "time step. A plain number is in the reduced unit of time: for sdpd (m/rho)^(1/3) (m_0/k_B "
          "T)^(1/2) "
          "with the particle's mass m (sdpd/README.md, Eq. (S1)), for dpd and dpde the cut-off of the "
          "friction times "
          "(mass/k_B T)^(1/2). A text is in seconds (\"2 fs\") or, in scenes in Lennard-Jones units, in "
          "their "
          "unit of time, sigma (m/epsilon)^(1/2) (\"0.05 tau\"). `check` prints it in both. \"auto\": found "
          "by a "
          "short study for the wanted drift, bias or dynamics")
          .required()
          .quantity(Dimension::time, positive),
      scheme("drift", &Scene::Scheme::drift,
             "with dt = \"auto\": wanted rate of the relative energy error of the fluid at rest, such as "
             "\"1e-6/ps\" (a plain number "
             "per unit of time when units = \"lj\"). In scenes that something drives (regions, a reaction, a "
             "piston, walls that slide, open faces, a body force) also a share, such as \"1%\": the energy "
             "that may be "
             "missing "
             "at the end of the run, of what has come from outside or been exchanged between internal and "
             "kinetic "
             "energies (sdpd/README.md, Eq. (S73)); found by trials of the run's beginning"),
      scheme("bias", &Scene::Scheme::bias,
             "with dt = \"auto\": wanted bias of T_kin, T_int and P, such as \"0.5%\", also by the energy "
             "that drifts "
             "over run.steps"),
      scheme(
          "dynamics", &Scene::Scheme::dynamics,
          "with dt = \"auto\": by how much the time step may change self-diffusion, such as \"5%\": long "
          "steps between two of friction make it too large, at most by (S92) of sdpd/README.md, and trials "
          "tell how much of that this fluid has (S93); the viscosity changes less"),
      scheme("dt_chosen_for", &Scene::Scheme::dt_chosen_for,
             "written by the program: the tolerance that dt was chosen for"),
      scheme("diffusion_share", &Scene::Scheme::diffusion_share,
             "written by the program: how much of the excess (S92) of self-diffusion trials have shown")
          .in({.min = -1e6, .max = 1e6}),
      scheme("diffusion_share_se", &Scene::Scheme::diffusion_share_se,
             "written by the program: its standard error")
          .in({.min = 0, .max = 1e6}),
      scheme("splitting", &Scene::Scheme::splitting,
             "a conservative step, then fluctuation and dissipation (lie-trotter), or half of the latter on "
             "either side (strang)")
          .choices({"lie-trotter", "strang"}),
      scheme("conservative", &Scene::Scheme::conservative,
             "integrator of the conservative forces: " + conservative_summaries())
          .choices(sdpd::conservative_names())
          .formerly("two-stage", "mclachlan"),
      scheme("fluctuate_every", &Scene::Scheme::fluctuate_every,
             "conservative steps for one of fluctuation and dissipation (multiple time steps)")
          .in({.min = 1, .max = 1e6}),
      scheme("energy", &Scene::Scheme::energy,
             "free, or kept: what the time step loses is given back to the internal energies")
          .choices({"free", "kept"}),
  };
}

} // namespace mesobridge::workflows
