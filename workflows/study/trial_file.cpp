#include "workflows/study/trial_file.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include "workflows/version.hpp"

namespace mesobridge::workflows {
namespace {

/// Calls f(key, member) for all members of a result: one list serves writing and reading.
template <class Result, class F>
void for_each_member(Result& r, F const& f) {
  f("failure", r.failure), f("dt", r.dt), f("settled", r.settled);
  f("T_kin", r.T_kin), f("T_int", r.T_int), f("P", r.P);
  f("eps_mean", r.eps_mean), f("eps_variance", r.eps_variance);
  f("drift_of_mean", r.drift_of_mean), f("drift_of_walk", r.drift_of_walk);
  f("rejected_out_of_domain", r.rejected_out_of_domain), f("rejected_metropolis", r.rejected_metropolis);
  f("us_per_particle_step", r.us_per_particle_step), f("E_0", r.E_0), f("heat_capacity", r.heat_capacity);
  f("bins", r.bins), f("first_half", r.first_half), f("second_half", r.second_half);
  f("times", r.times), f("energies", r.energies);
}

Json to_json(auto const& value) {
  return value;
}
Json to_json(cg::Estimate const& e) {
  return {e.mean, e.se, e.n_eff};
}
Json to_json(EnergyBins const& b) {
  return {b.lower, b.upper, b.count};
}
Json to_json(sdpd::Drift const& d) {
  return {d.rate, d.se};
}

template <class Value>
void from_json(Json const& json, Value& value) {
  value = json.get<Value>();
}
void from_json(Json const& json, cg::Estimate& e) {
  e = {json.at(0), json.at(1), json.at(2)};
}
void from_json(Json const& json, EnergyBins& b) {
  b = {json.at(0), json.at(1), json.at(2)};
}
void from_json(Json const& json, sdpd::Drift& d) {
  d = {json.at(0), json.at(1)};
}

} // namespace

std::string identity(Trial const& trial) {
  return fmt::format("{}\nbins {} {} {}\n{}", resolved_toml(trial.scene), trial.bins.lower, trial.bins.upper,
                     trial.bins.count, git_commit());
}

void write_trial(std::filesystem::path const& file, std::string const& identity, TrialResult const& result) {
  Json json{{"identity", identity}};
  for_each_member(result, [&](char const* key, auto const& value) { json[key] = to_json(value); });
  write_text_file(file, checked_dump(json) + "\n");
}

std::optional<TrialResult> read_trial(std::filesystem::path const& file, std::string const& identity) {
  if (!std::filesystem::is_regular_file(file))
    return std::nullopt;
  try {
    auto const json = Json::parse(read_text_file(file));
    if (json.at("identity") != identity)
      return std::nullopt;
    TrialResult result;
    for_each_member(result, [&](char const* key, auto& value) { from_json(json.at(key), value); });
    return result;
  } catch (Json::exception const&) {
    return std::nullopt; // it is made again
  }
}

} // namespace mesobridge::workflows
