#include "sdpd/kinetics/list.hpp"
#include "workflows/scene/keys/parameter_line.hpp"
#include "workflows/scene/keys/tables.hpp"
#include <fmt/ranges.h>

// The keys of reactions, with those of the laws of kinetics as these describe themselves.

namespace mesobridge::workflows {
namespace {

bool reacts(Scene const& scene) {
  return scene.reaction.product.has_value();
}

SceneKey key_of_kinetics() {
  std::vector<std::string> names, meanings;
  for (auto const& law : sdpd::kinetics()) {
    names.emplace_back(law.name);
    meanings.push_back(fmt::format("{}, {}", law.name, law.summary));
  }
  return Line(
             "reaction", "kinetics", [](Scene& s) { return &s.reaction.kinetics; },
             fmt::format("how fast the reactant becomes the product: {}", fmt::join(meanings, "; ")))
      .choices(names)
      .written_if(reacts)
      .of<sdpd::Sdpd>();
}

} // namespace

std::vector<sdpd::Parameter> kinetics_parameters() {
  return parameters_of(sdpd::kinetics());
}

std::vector<SceneKey> reaction_keys() {
  using Reaction = Scene::Reaction;
  Table const reaction{"reaction", &Scene::reaction};
  std::vector<SceneKey> keys{
      reaction("product", &Reaction::product,
               "what the fluid reacts to, as fluid.eos, which is the reactant: models with a constant heat "
               "capacity; without it nothing reacts")
          .of<sdpd::Sdpd>(),
      reaction("heat", &Reaction::heat, "heat of reaction, given to the fluid; or heat_per_molecule")
          .quantity(Dimension::specific_energy, any_number)
          .of<sdpd::Sdpd>(),
      reaction("heat_per_molecule", &Reaction::heat_per_molecule, "the same of one molecule of the reactant")
          .quantity(Dimension::energy, any_number)
          .of<sdpd::Sdpd>(),
      reaction("volumes", &Reaction::volumes,
               "how those of reactant and product make that of a mixture: additive, by one entropy; paper, "
               "the thesis's mean of the densities, which does not conserve energy")
          .choices({"additive", "paper"})
          .written_if(reacts)
          .of<sdpd::Sdpd>(),
      key_of_kinetics(),
  };
  for (auto const& parameter : kinetics_parameters())
    keys.push_back(
        parameter_line("reaction", &Scene::reaction, parameter, sdpd::kinetics()).of<sdpd::Sdpd>());
  std::vector<SceneKey> const rest{
      reaction("weights", &Reaction::weights,
               "of neighbours in second-order kinetics: kernel, W_ij in reduced units, whose sum is nearly "
               "rho/fluid.rho; normalised, m_j W_ij/rho_j, whose sum is 1")
          .choices({"kernel", "normalised"})
          .written_if(reacts)
          .of<sdpd::Sdpd>(),
      reaction("integrator", &Reaction::integrator,
               "midpoint, of second order; euler, of first. Both keep the progress within 0 and 1")
          .choices(sdpd::rate_integrator_names())
          .written_if(reacts)
          .of<sdpd::Sdpd>(),
      reaction("progress", &Reaction::progress,
               "the product's share of the mass at the start, where no region says otherwise")
          .in(sdpd::SdpdReaction::shares)
          .written_if(reacts)
          .of<sdpd::Sdpd>(),
  };
  keys.insert(keys.end(), rest.begin(), rest.end());
  return keys;
}

} // namespace mesobridge::workflows
