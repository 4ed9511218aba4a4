#include "fitting/eos_problem.hpp"
#include "md/error.hpp"

namespace mesobridge::fitting {
namespace {

/// Calls f with the model itself. Only linear models are fitted.
template <class F>
auto with_linear(AnyEos const& any, F&& f) {
  return std::visit(
      [&]<class Model>(Model const& model) -> decltype(f(std::declval<MieGruneisen const&>())) {
        if constexpr (FittableModel<Model>)
          return f(model);
        else
          throw std::logic_error("a fit of a model that is not linear in T");
      },
      any);
}

double offset_of(Eigen::VectorXd const& values) {
  return values[values.size() - 1];
}

template <class Model>
void predict(Model const& model, Observation const& observation, double offset,
             Eigen::Ref<Eigen::VectorXd> out) {
  auto const state = reach(model, observation, offset);
  for (std::size_t k = 0; k < observation.measured.size(); ++k)
    out[static_cast<Eigen::Index>(k)] = quantity_of(model, state, observation.measured[k].quantity, offset);
}

Eigen::Index size_of(Observation const& observation) {
  return static_cast<Eigen::Index>(observation.measured.size());
}

Eigen::MatrixXd whitening_of(Eigen::MatrixXd const& noise) {
  Eigen::MatrixXd const L = noise.llt().matrixL();
  return L.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(L.rows(), L.cols()));
}

constexpr int densities_checked = 33;

} // namespace

EosProblem::EosProblem(EosFamily const& family, std::vector<Observation> const& data, EosRegion const& region)
    : family_(family), data_(data), region_(region) {
  for (auto const& observation : data) {
    check(observation);
    size_ += size_of(observation);
    noise_.push_back(measurement_noise(observation));
    whitening_.push_back(whitening_of(noise_.back()));
  }
}

Eigen::MatrixXd EosProblem::measurement_noise(Observation const& observation) const {
  auto const& measured = observation.measured;
  Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(size_of(observation), size_of(observation));
  for (std::size_t i = 0; i < measured.size(); ++i)
    for (std::size_t k = 0; k < measured.size(); ++k) {
      bool const P_and_e = (measured[i].quantity == Quantity::P && measured[k].quantity == Quantity::e) ||
                           (measured[i].quantity == Quantity::e && measured[k].quantity == Quantity::P);
      double const correlation = i == k ? 1 : P_and_e ? observation.P_e_correlation : 0;
      double const systematic = i == k ? measured[i].systematic * measured[i].systematic : 0;
      noise(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          correlation * measured[i].se * measured[k].se + systematic;
    }
  return noise;
}

Eigen::VectorXd EosProblem::residuals(Eigen::VectorXd const& values) const {
  double const offset = offset_of(values);
  Eigen::VectorXd result(size_);
  with_linear(family_.build(values), [&](auto const& model) {
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < data_.size(); ++i) {
      auto const n = size_of(data_[i]);
      Eigen::VectorXd difference(n);
      predict(model, data_[i], offset, difference);
      for (Eigen::Index k = 0; k < n; ++k)
        difference[k] = data_[i].measured[static_cast<std::size_t>(k)].value - difference[k];
      result.segment(row, n).noalias() = whitening_[i] * difference;
      row += n;
    }
  });
  return result;
}

Eigen::VectorXd EosProblem::sound_speeds_squared(Eigen::VectorXd const& values) const {
  constexpr double unit = 1e6; // (km/s)^2
  double const offset = offset_of(values);
  std::vector<double> result;
  with_linear(family_.build(values), [&](auto const& model) {
    // At fixed density c^2 is linear in T for these models: the ends of the temperatures speak for all.
    for (int i = 0; i < densities_checked; ++i) {
      double const rho = region_.rho_min + (region_.rho_max - region_.rho_min) * i / (densities_checked - 1);
      auto const isochore = model.isochore(rho);
      for (double const T : {region_.T_min, region_.T_max})
        if (T > 0)
          result.push_back(sound_speed_squared(isochore, T) / unit);
    }
    for (auto const& observation : data_)
      if (observation.path != DataPath::state) {
        auto const state = reach(model, observation, offset);
        result.push_back(sound_speed_squared(model.isochore(state.rho), state.T) / unit);
      }
  });
  return Eigen::Map<Eigen::VectorXd>(result.data(), static_cast<Eigen::Index>(result.size()));
}

ReachedState EosProblem::reached(Observation const& observation, Eigen::VectorXd const& values) const {
  return with_linear(family_.build(values),
                     [&](auto const& model) { return reach(model, observation, offset_of(values)); });
}

Eigen::VectorXd EosProblem::predictions(Observation const& observation, Eigen::VectorXd const& values) const {
  Eigen::VectorXd result(size_of(observation));
  with_linear(family_.build(values),
              [&](auto const& model) { predict(model, observation, offset_of(values), result); });
  return result;
}

bool EosProblem::renew_noise(Eigen::VectorXd const& values) {
  constexpr double step = 1e-3; // of a standard error
  bool any = false;
  for (std::size_t i = 0; i < data_.size(); ++i) {
    Eigen::MatrixXd noise = measurement_noise(data_[i]);
    for (std::size_t k = 0; k < data_[i].given.size(); ++k) {
      double const h = step * data_[i].given[k].se;
      if (h == 0)
        continue;
      Observation above = data_[i], below = data_[i];
      above.given[k].value += h;
      below.given[k].value -= h;
      Eigen::VectorXd const spread = (predictions(above, values) - predictions(below, values)) / (2 * step);
      noise += spread * spread.transpose();
      any = true;
    }
    noise_[i] = noise;
    whitening_[i] = whitening_of(noise);
  }
  return any;
}

Eigen::VectorXd EosProblem::standard_errors(std::size_t observation) const {
  return noise_[observation].diagonal().cwiseSqrt();
}

double predicted(EosFamily const& family, Observation const& observation, Quantity quantity,
                 Eigen::VectorXd const& values) {
  return with_linear(family.build(values), [&](auto const& model) {
    double const offset = offset_of(values);
    return quantity_of(model, reach(model, observation, offset), quantity, offset);
  });
}

} // namespace mesobridge::fitting
