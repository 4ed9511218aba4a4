#include "workflows/coarse/potential_beside.hpp"
#include "md/error.hpp"
#include "sdpd/potential/tabulated_potential.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/column_file.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {
namespace {

sdpd::TabulatedPotential read_potential(std::filesystem::path const& file) {
  auto columns = read_columns(file, {"r", "u"}, {"f", "u_se"});
  try {
    return {columns["r"], columns["u"], columns["f"]};
  } catch (InputError const& error) {
    throw InputError(fmt::format("--beside '{}': {}", file.string(), error.what()));
  }
}

/// Root mean squares of differences, and of the errors that ours have, over pairs.
class Apart {
 public:
  void add(double difference, double se, double pairs) {
    difference_ += pairs * difference * difference, noise_ += pairs * se * se, pairs_ += pairs;
  }
  cg::Estimate estimate() const {
    return {std::sqrt(difference_ / pairs_), std::sqrt(noise_ / pairs_), pairs_};
  }

 private:
  double difference_ = 0, noise_ = 0, pairs_ = 0;
};

} // namespace

PotentialBeside potential_beside(cg::MatchedForce const& ours, std::filesystem::path const& file) {
  auto const other = read_potential(file);
  PotentialBeside beside{};
  beside.name = file.string();
  Apart u_apart, f_apart;
  for (std::size_t bin = 0; bin < ours.f.size(); ++bin) {
    double const r = ours.r(bin);
    if (r < std::max(ours.first, other.inner()))
      continue;
    auto const at = r < other.cutoff() ? other(r, 1 / r) : sdpd::PairForce<double>{0, 0};
    double const u = at.energy, f = at.strength * r;
    if (beside.r.empty())
      beside.first_bin = bin;
    beside.r.push_back(r), beside.u.push_back(u), beside.f.push_back(f);
    beside.u_se.push_back(cg::deviation(ours.u[bin], u));
    beside.f_se.push_back(cg::deviation(ours.f[bin], f));
    u_apart.add(ours.u[bin].mean - u, ours.u[bin].se, ours.pairs[bin]);
    f_apart.add(ours.f[bin].mean - f, ours.f[bin].se, ours.pairs[bin]);
  }
  require(!beside.r.empty(), "--beside", file.string(), "has no distance in common with the pairs");
  beside.u_apart = u_apart.estimate(), beside.f_apart = f_apart.estimate();
  return beside;
}

Json beside_json(PotentialBeside const& beside) {
  Json json{{"file", beside.name}, {"r", beside.r}, {"u", beside.u}, {"f", beside.f}};
  json["u_deviation"] = beside.u_se, json["f_deviation"] = beside.f_se;
  put(json, "u_rms_apart", beside.u_apart);
  put(json, "f_rms_apart", beside.f_apart);
  return json;
}

std::string beside_text(PotentialBeside const& beside) {
  auto const farthest = [&](std::vector<double> const& in_se) {
    auto const at = std::ranges::max_element(in_se, {}, [](double x) { return std::abs(x); });
    return fmt::format("at most {:+.1f} standard errors, at r = {:.4g}", *at,
                       beside.r[std::size_t(at - in_se.begin())]);
  };
  return fmt::format("beside {}, root mean square over pairs:\n"
                     "  u     {} apart, where errors make {}; {}\n"
                     "  f     {} apart, where errors make {}; {}\n",
                     beside.name, number_text(beside.u_apart.mean, 3), number_text(beside.u_apart.se, 2),
                     farthest(beside.u_se), number_text(beside.f_apart.mean, 3),
                     number_text(beside.f_apart.se, 2), farthest(beside.f_se));
}

} // namespace mesobridge::workflows
