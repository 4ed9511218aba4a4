#pragma once
#include "fitting/fit_eos.hpp"
#include "fitting/parametric_file.hpp"
#include "md/error.hpp"

namespace mesobridge::fitting {

/// Extremes of what the data say, to set bounds by. Absent: nothing of the kind is in the data.
struct DataSummary {
  double rho_start = 0; ///< where the data start: the least rho0 of shocks, or else the least density
  double rho_min = 0, rho_max = 0;
  std::optional<double> T_min, T_max;
  bool energies = false; ///< energies on a scale of the data's own occur
};

DataSummary summarise(std::span<Observation const> data);

/// A family of plain structs of numbers: `parameters` in the order of the model's file.
template <ParametricModel Model>
EosFamily parametric_family(std::vector<Parameter> parameters, DataSummary const& data) {
  using Form = FileForm<Model>;
  static constexpr std::size_t size = Form::keys.size();
  if (parameters.size() != size)
    throw std::logic_error("a family needs all parameters of its model");
  for (std::size_t i = 0; i < size; ++i)
    parameters[i].key = Form::keys[i].name;
  parameters.push_back({.name = "energy_offset",
                        .key = "energy_offset_J_kg",
                        .unit = "J/kg",
                        .meaning = "an energy of the data minus that of the model at the same state",
                        .start = 0,
                        .lower = -1e8,
                        .upper = 1e8,
                        .free = data.energies});
  return {.name = std::string(Form::kind),
          .parameters = std::move(parameters),
          .build = [](Eigen::VectorXd const& values) -> AnyEos {
            typename Form::P p{};
            for (std::size_t i = 0; i < size; ++i)
              p.*Form::keys[i].member = values[static_cast<Eigen::Index>(i)];
            return Model(p);
          },
          .values_of =
              [](AnyEos const& any) {
                auto const* const model = std::get_if<Model>(&any);
                require(model != nullptr, "model to start from", "of another kind",
                        fmt::format("must be {}", Form::kind));
                Eigen::VectorXd values(size);
                for (std::size_t i = 0; i < size; ++i)
                  values[static_cast<Eigen::Index>(i)] = model->parameters().*Form::keys[i].member;
                return values;
              }};
}

} // namespace mesobridge::fitting
