#include "fitting/lj_bwr_design.hpp"

namespace mesobridge::fitting {

ResidualRows residual_rows(double rho, double T, double gamma) {
  auto const basis = bwr::density_functions(rho, gamma);
  std::array<double, bwr::series_terms> U_of_power, P_of_power;
  for (int m = 0; m < bwr::series_terms; ++m) {
    TemperatureSeries<double> unit;
    unit.c[m] = 1;
    U_of_power[m] = unit.energy(T);
    P_of_power[m] = unit.value(T);
  }
  ResidualRows rows;
  for (int j = 0; j < bwr::parameters; ++j) {
    auto const [density, power] = bwr::table[j];
    rows.U(j) = basis.f[density] * U_of_power[power];
    rows.P(j) = basis.p[density] * P_of_power[power];
  }
  return rows;
}

} // namespace mesobridge::fitting
