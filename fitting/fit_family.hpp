#pragma once
#include "fitting/data_summary.hpp"
#include "fitting/fit_eos.hpp"

namespace mesobridge::fitting {

/// The family of a model that describes itself, with bounds that suit the data. Throws InputError when they
/// say no density.
template <DescribedModel Model>
EosFamily family_of(std::span<Observation const> observations) {
  auto const& description = Model::description();
  auto const data = summarise(observations);
  EosFamily family{.name = std::string(description.kind),
                   .parameters = {},
                   .build = [&description](Eigen::VectorXd const& values) -> AnyEos {
                     typename Model::Parameters parameters{};
                     Eigen::Index i = 0;
                     for (auto const& parameter : description.parameters)
                       parameters.*parameter.member = values[i++];
                     return Model(parameters);
                   },
                   .values_of =
                       [&description](AnyEos const& any) {
                         auto const* const model = std::get_if<Model>(&any);
                         require(model != nullptr, "model to start from", "of another kind",
                                 fmt::format("must be {}", description.kind));
                         Eigen::VectorXd values(static_cast<Eigen::Index>(description.parameters.size()));
                         Eigen::Index i = 0;
                         for (auto const& parameter : description.parameters)
                           values[i++] = model->parameters().*parameter.member;
                         return values;
                       }};
  for (auto const& parameter : description.parameters)
    family.parameters.push_back({.name = std::string(parameter.name),
                                 .key = parameter.key(),
                                 .unit = std::string(parameter.unit),
                                 .meaning = std::string(parameter.meaning),
                                 .start = parameter.fit.start.in(data),
                                 .lower = parameter.fit.lower.in(data),
                                 .upper = parameter.fit.upper.in(data),
                                 .logarithmic = parameter.fit.logarithmic,
                                 .free = parameter.fit.free,
                                 .linear = parameter.fit.linear});
  family.parameters.push_back({.name = "energy_offset",
                               .key = "energy_offset_J_kg",
                               .unit = "J/kg",
                               .meaning = "an energy of the data minus that of the model at the same state",
                               .start = 0,
                               .lower = -1e8,
                               .upper = 1e8,
                               .free = data.energies && !description.knows_energy_zero});
  return family;
}

/// A kind of equation of state that can be fitted.
struct FittableKind {
  std::string name;     ///< "mie-gruneisen"
  std::string material; ///< what it describes, in words
  std::string example;  ///< what follows `mesobridge fit NAME`
  EosFamily (*family)(std::span<Observation const>);
};

/// One for every model of AnyEos whose description leaves a parameter free.
std::vector<FittableKind> fittable_kinds();

} // namespace mesobridge::fitting
