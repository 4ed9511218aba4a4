#include "workflows/sdpd/method_of.hpp"
#include "md/units.hpp"
#include "workflows/scene/pair_checks.hpp"
#include "workflows/sdpd/column_file.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

bool is_si(Scene const& scene) {
  return scene.units == UnitSystem::SI;
}

/// What `make` makes of a file's table; its refusals name the key and the file.
template <class Make>
auto from_table(std::string const& key, std::string const& file, Make const& make) {
  try {
    return make();
  } catch (InputError const& error) {
    throw InputError(fmt::format("{} = \"{}\": {}", key, file, error.what()));
  }
}

/// What the scene's model of a particle says of two of them, "r" and others by their reduced names; the
/// scene's checks have seen to it that it does.
fitting::PairColumns columns_of_model(Scene const& scene,
                                      fitting::PairColumns fitting::ParticleModel::*part) {
  return particle_model_of(scene).value().*part;
}

sdpd::TabulatedPotential tabulated_potential(Scene const& scene) {
  std::string const r = is_si(scene) ? "r_m" : "r", u = is_si(scene) ? "u_J" : "u",
                    f = is_si(scene) ? "f_N" : "f";
  auto columns = read_columns(*scene.potential.file, {r, u}, {f});
  return from_table("potential.file", *scene.potential.file,
                    [&] { return sdpd::TabulatedPotential(columns[r], columns[u], columns[f]); });
}

/// The scene's checks have seen to it that the keys that a potential needs are there.
sdpd::AnyPotential potential_of(Scene const& scene) {
  if (scene.potential.name == "table")
    return tabulated_potential(scene);
  if (scene.potential.name == "model") {
    auto columns = columns_of_model(scene, &fitting::ParticleModel::potential);
    return from_table("particles.model", *scene.particles.model,
                      [&] { return sdpd::TabulatedPotential(columns["r"], columns["u"], columns["f"]); });
  }
  auto const& kind =
      *std::ranges::find(sdpd::potentials(), scene.potential.name, &sdpd::NamedPotential::name);
  std::vector<double> values;
  for (auto const& parameter : kind.parameters)
    values.push_back(scene.potential.parameters[parameter.name].value());
  return kind.make(values);
}

sdpd::AnyWeightFunction friction_of(Scene const& scene) {
  auto const& friction = scene.friction;
  if (friction == Scene::Friction{}) {
    auto columns = columns_of_model(scene, &fitting::ParticleModel::friction);
    return from_table("particles.model", *scene.particles.model, [&] {
      return sdpd::TabulatedFriction(columns["r"], columns["gamma_par"], columns["gamma_perp"]);
    });
  }
  if (!friction.file)
    return sdpd::PowerFriction(*friction.gamma_par, friction.gamma_perp, *friction.cutoff,
                               friction.exponent.value_or(2));
  std::string const r = is_si(scene) ? "r_m" : "r", par = is_si(scene) ? "gamma_par_kg_s" : "gamma_par",
                    perp = is_si(scene) ? "gamma_perp_kg_s" : "gamma_perp";
  auto columns = read_columns(*friction.file, {r, par}, {perp});
  return from_table("friction.file", *friction.file,
                    [&] { return sdpd::TabulatedFriction(columns[r], columns[par], columns[perp]); });
}

/// The scene's checks have seen to it that a cut-off comes with a conductivity.
std::optional<sdpd::AnyWeightFunction> conduction_of(Scene const& scene, double friction_cutoff) {
  auto const& conduction = scene.conduction;
  if (conduction.file) {
    std::string const r = is_si(scene) ? "r_m" : "r", kappa = is_si(scene) ? "kappa_W_K" : "kappa";
    auto columns = read_columns(*conduction.file, {r, kappa}, {});
    return from_table("conduction.file", *conduction.file,
                      [&] { return sdpd::TabulatedFriction(columns[r], columns[kappa], {}); });
  }
  if (!conduction.kappa) {
    auto columns = columns_of_model(scene, &fitting::ParticleModel::conduction);
    if (columns.empty())
      return std::nullopt;
    return from_table("particles.model", *scene.particles.model,
                      [&] { return sdpd::TabulatedFriction(columns["r"], columns["kappa"], {}); });
  }
  if (*conduction.kappa == 0)
    return std::nullopt;
  return sdpd::PowerFriction(*conduction.kappa, 0, conduction.cutoff.value_or(friction_cutoff),
                             conduction.exponent.value_or(2));
}

fitting::AnyInternalEnergy internal_energy_of(Scene const& scene) {
  auto const& [heat_capacity, file] = scene.internal_energy;
  if (heat_capacity)
    return fitting::ConstantHeatCapacity(*heat_capacity);
  if (!file)
    return particle_model_of(scene).value().internal_energy;
  auto const model = fitting::parse_particle_model(read_text_file(*file), *file);
  bool const constant = std::holds_alternative<fitting::ConstantHeatCapacity>(model.internal_energy);
  require(constant || model.reduced != is_si(scene), "internal_energy.model", *file,
          model.reduced ? "its temperatures are reduced, but units = \"SI\""
                        : "its temperatures are in kelvin, but units = \"lj\"");
  return model.internal_energy;
}

sdpd::PairFluid pair_fluid_of(Scene const& scene) {
  return {.mass = *scene.particles.mass,
          .boltzmann = is_si(scene) ? k_B : 1,
          .potential = potential_of(scene),
          .friction = friction_of(scene)};
}

sdpd::AnyKinetics kinetics_of(Scene const& scene) {
  auto const& of = scene.reaction;
  auto const& named = sdpd::kinetics_named(of.kinetics);
  std::vector<double> values;
  for (auto const& parameter : named.parameters)
    values.push_back(of.parameters[parameter.name].value());
  auto kinetics = named.make(values);
  if (auto* const pairs = std::get_if<sdpd::SecondOrder>(&kinetics))
    pairs->weights =
        of.weights == "kernel" ? sdpd::NeighbourWeights::kernel : sdpd::NeighbourWeights::normalised;
  return kinetics;
}

std::optional<sdpd::SdpdReaction> reaction_of(Scene const& scene) {
  auto const& of = scene.reaction;
  if (!of.product)
    return std::nullopt;
  double const m0 = std::visit([](auto const& eos) { return eos.molecular_mass(); }, eos_of(scene));
  return sdpd::SdpdReaction{.product = product_of(scene),
                            .additive_volumes = of.volumes == "additive",
                            .heat = of.heat ? *of.heat : *of.heat_per_molecule / m0,
                            .kinetics = kinetics_of(scene),
                            .integrator = of.integrator == "euler" ? sdpd::RateIntegrator::euler
                                                                   : sdpd::RateIntegrator::midpoint,
                            .progress = of.progress};
}

sdpd::AnyMethod make(std::type_identity<sdpd::Sdpd>, Scene const& scene) {
  return sdpd::Sdpd{.eos = eos_of(scene),
                    .K = scene.particles.K,
                    .centre_of_mass = scene.fluid.centre_of_mass == "free" ? sdpd::CentreOfMass::free
                                                                           : sdpd::CentreOfMass::bulk,
                    .kernel = scene.particles.kernel,
                    .density_correction = density_correction_of(scene),
                    .h_factor = scene.particles.h_factor,
                    .eta = scene.transport.friction(),
                    .zeta = scene.transport.zeta,
                    .kappa = scene.transport.kappa,
                    .reaction = reaction_of(scene)};
}

sdpd::AnyMethod make(std::type_identity<sdpd::Dpde>, Scene const& scene) {
  auto const particles = pair_fluid_of(scene);
  return sdpd::Dpde{particles, internal_energy_of(scene), conduction_of(scene, particles.friction_cutoff())};
}

sdpd::AnyMethod make(std::type_identity<sdpd::Dpd>, Scene const& scene) {
  return sdpd::Dpd{pair_fluid_of(scene)};
}

} // namespace

sdpd::AnyMethod method_of(Scene const& scene) {
  std::optional<sdpd::AnyMethod> method;
  sdpd::for_method(scene.method.name, [&](auto type) { method = make(type, scene); });
  return method.value();
}

} // namespace mesobridge::workflows
