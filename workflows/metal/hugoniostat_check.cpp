#include "workflows/metal/hugoniostat_check.hpp"
#include "cg/equilibration.hpp"
#include "md/error.hpp"
#include "md/hugoniostat.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/summary.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

struct Series {
  std::vector<double> T, rho, e, residual;
};

/// The means of what follows the equilibration of all of them.
HugoniostatCheck analyse(Series const& series, cg::HugoniotPoint const& point) {
  std::size_t start = 0;
  for (auto const* values : {&series.T, &series.rho, &series.e, &series.residual})
    start = std::max(start, cg::detect_equilibration(*values).start);
  auto const mean = [&](std::vector<double> const& values) {
    return cg::estimate_mean(std::span(values).subspan(start));
  };
  auto const deviation = [](cg::Estimate const& a, double value, double se) {
    return (a.mean - value) / std::hypot(a.se, se);
  };
  HugoniostatCheck check{.P = point.P.mean,
                         .T = mean(series.T),
                         .rho = mean(series.rho),
                         .e = mean(series.e),
                         .residual = mean(series.residual)};
  check.T_deviation = deviation(check.T, point.T.mean, point.T.se);
  check.rho_deviation = deviation(check.rho, point.rho, 0);
  check.e_deviation = deviation(check.e, point.e.mean, point.e.se);
  return check;
}

} // namespace

std::vector<HugoniostatCheck> check_by_hugoniostat(cg::MetalPoint const& initial,
                                                   std::span<cg::HugoniotPoint const> points,
                                                   md::MetalSettings const& settings,
                                                   Context const& context) {
  constexpr int slower = 3;
  auto own = settings;
  own.equilibration_steps *= slower;
  own.sampling_steps *= slower;
  own.log_file = settings.log_file.parent_path() / "lammps-hugoniostat.log";
  auto const samples = std::size_t((own.sampling_steps + own.sample_every - 1) / own.sample_every);
  auto progress = context.progress(fmt::format("Hugoniostat at {} pressures", points.size()),
                                   double(points.size() * samples));
  std::vector<HugoniostatCheck> checks;
  md::MpiWorld const world;
  for (auto const& point : points) {
    Series series;
    md::ShockTarget const target{.initial = initial.state,
                                 .P0 = initial.P.mean,
                                 .e0 = initial.e.mean,
                                 .P = point.P.mean,
                                 .nearby = {.rho = point.rho, .T = point.T.mean}};
    auto const consume = [&](md::HugoniostatSample const& sample) {
      series.T.push_back(sample.T);
      series.rho.push_back(sample.rho);
      series.e.push_back(sample.e);
      double const work = (sample.P + target.P0) * (1 / target.initial.rho - 1 / sample.rho) / 2;
      series.residual.push_back(sample.e - target.e0 - work);
      progress.update(double(checks.size() * samples + series.T.size()));
      return !interrupt_requested();
    };
    if (!md::sample_hugoniostat(world, target, own, consume,
                                checks.empty() ? md::Log::replace : md::Log::append))
      throw Interrupted("interrupted; the curve itself is written, without the Hugoniostat beside it");
    checks.push_back(analyse(series, point));
  }
  progress.finish();
  return checks;
}

Json hugoniostat_json(std::span<HugoniostatCheck const> checks) {
  Json list = Json::array();
  for (auto const& check : checks) {
    Json object{{"P_Pa", check.P}};
    put(object, "T_K", check.T);
    put(object, "rho_kg_m3", check.rho);
    put(object, "e_J_kg", check.e);
    put(object, "residual_J_kg", check.residual);
    object["deviations_in_se"] = {
        {"T", check.T_deviation}, {"rho", check.rho_deviation}, {"e", check.e_deviation}};
    list.push_back(std::move(object));
  }
  return list;
}

std::string hugoniostat_text(std::span<HugoniostatCheck const> checks) {
  auto text = fmt::format(
      "Hugoniostat of LAMMPS (in brackets: difference in standard errors)\n{:>8}  {:<24} {:<24} {}\n",
      "P GPa", "T K", "rho kg/m^3", "e kJ/kg", "residual kJ/kg");
  auto const entry = [](cg::Estimate const& estimate, double deviation) {
    return fmt::format("{} [{:+.1f}]", with_error_text(estimate), deviation);
  };
  for (auto const& check : checks)
    text += fmt::format("{:8.3f}  {:<24} {:<24} {:<24} {}\n", check.P / 1e9,
                        entry(check.T, check.T_deviation), entry(check.rho, check.rho_deviation),
                        entry({check.e.mean / 1e3, check.e.se / 1e3, 0}, check.e_deviation),
                        with_error_text({check.residual.mean / 1e3, check.residual.se / 1e3, 0}));
  return text;
}

} // namespace mesobridge::workflows
