#include "fitting/eigen.hpp"
#include "fitting/eos/tabulated.hpp"
#include <numbers>
#include <random>

namespace mesobridge::fitting {
namespace {

using quintic::Axis;

/// The splines of an axis at its sites, factorised.
Eigen::PartialPivLU<Eigen::MatrixXd> collocation(Axis const& axis) {
  int const n = axis.coefficients();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    auto const [cell, t] = axis.place(axis.site(i));
    auto const w = quintic::weights_of(t);
    for (int j = 0; j < quintic::order; ++j)
      A(i, cell + j) = w[j];
  }
  return A.partialPivLu();
}

/// Splines of `densities` x `energies` cells through the model.
EntropyTable interpolate(TableSource const& source, TableRegion const& region, int densities, int energies) {
  EntropyTable table{};
  table.m0 = source.m0, table.boltzmann = source.boltzmann;
  table.R = source.boltzmann / source.m0;
  table.T_min = region.T_min, table.T_max = region.T_max;
  table.e_1 = 1.5 * table.R * region.T_min;
  table.density = {region.rho_min, region.rho_max, densities};
  int const rows = table.density.coefficients();
  auto const over_density = collocation(table.density);

  Eigen::VectorXd rho(rows), base(rows);
  double y_max = 0;
  for (int i = 0; i < rows; ++i) {
    rho(i) = table.density.site(i);
    double const cold = source.energy(region.T_min, rho(i)), hot = source.energy(region.T_max, rho(i));
    base(i) = cold - table.e_1;
    y_max = std::max(y_max, std::log((hot - base(i)) / table.e_1));
  }
  // Room for the round-off of states at the very edge, and for e_0 between its sites.
  constexpr double edge = 1e-7;
  table.y = {-edge, y_max + edge, energies};
  int const columns = table.y.coefficients();
  Eigen::MatrixXd S(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      S(i, j) = source.entropy(base(i) + table.e_1 * std::exp(table.y.site(j)), rho(i)) +
                table.R * std::log(rho(i));
  Eigen::VectorXd const e_0 = over_density.solve(base);
  Eigen::MatrixXd const half = over_density.solve(S);
  Eigen::MatrixXd const coefficients = collocation(table.y).solve(half.transpose()).transpose();

  constexpr std::size_t padding = quintic::lanes - quintic::order;
  table.e_0.assign(e_0.begin(), e_0.end());
  table.e_0.resize(table.e_0.size() + padding);
  table.stride = static_cast<std::size_t>(columns) + padding;
  table.S.assign(table.stride * static_cast<std::size_t>(rows), 0.0);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      table.S[static_cast<std::size_t>(i) * table.stride + static_cast<std::size_t>(j)] = coefficients(i, j);
  return table;
}

TableAccuracy measure(EntropyTable const& table, TableSource const& source, TableRegion const& region) {
  constexpr int states = 20000;
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> angle(0, std::numbers::pi);
  auto const toward_the_edges = [&] {
    return 0.5 * (1 - std::cos(angle(generator)));
  }; // where splines err most
  TableAccuracy worst{0, 0, 0, states};
  for (int n = 0; n < states; ++n) {
    double const rho = std::lerp(region.rho_min, region.rho_max, toward_the_edges());
    double const T = region.T_min * std::pow(region.T_max / region.T_min, toward_the_edges());
    auto const s = table.at(source.energy(T, rho), rho);
    double const P = source.pressure(T, rho), C = source.heat_capacity(T, rho);
    worst.T = std::max(worst.T, std::abs(1 / s.e / T - 1));
    worst.P = std::max(worst.P, std::abs(-rho * rho * s.rho / s.e - P) / (std::abs(P) + rho * table.R * T));
    worst.C = std::max(worst.C, std::abs(-s.e * s.e / s.ee / C - 1));
  }
  return worst;
}

void check(TableRegion const& region, double relative_error) {
  auto interval = [](std::string_view what, double low, double high) {
    require(low > 0 && high > low && std::isfinite(high), what, fmt::format("{} ... {}", low, high),
            "must be an interval of positive numbers");
  };
  interval("densities of a table", region.rho_min, region.rho_max);
  interval("temperatures of a table", region.T_min, region.T_max);
  require(relative_error >= 1e-12 && relative_error <= 1e-2, "relative error of a table", relative_error,
          "must lie in 1e-12 ... 1e-2");
}

} // namespace

Tabulated::Tabulated(TableSource const& source, TableRegion const& region, double relative_error) {
  check(region, relative_error);
  constexpr int most_cells = 700;
  constexpr double margin = 0.7; // for the states that were not looked at
  // First derivatives of quintic splines converge with the fifth power of the width.
  for (int cells = 24;;) {
    auto table = interpolate(source, region, cells, cells);
    table.accuracy = measure(table, source, region);
    double const excess = std::max(table.accuracy.T, table.accuracy.P) / (margin * relative_error);
    if (excess <= 1) {
      table_ = std::make_shared<EntropyTable const>(std::move(table));
      return;
    }
    int const wanted =
        static_cast<int>(std::ceil(cells * std::clamp(1.05 * std::pow(excess, 0.2), 1.1, 2.0)));
    if (!(wanted <= most_cells))
      throw PhysicsError(
          fmt::format("a table of {} x {} cells has the relative errors {:.2g} of T and {:.2g} "
                      "of P; {:.2g} cannot be reached: is the model smooth over the region?",
                      cells, cells, table.accuracy.T, table.accuracy.P, relative_error));
    cells = wanted;
  }
}

} // namespace mesobridge::fitting
