#include "workflows/study/trial_file.hpp"
#include "workflows/sdpd/scene_inputs.hpp"
#include "workflows/study/stored_part.hpp"
#include "workflows/version.hpp"

namespace mesobridge::workflows {

template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, sdpd::TrialResult>
void for_each_member(Result& r, F const& f) {
  f("failure", r.failure), f("dt", r.dt), f("settled", r.settled);
  f("T_kin", r.T_kin), f("T_int", r.T_int), f("P", r.P), f("D", r.D);
  f("eps_mean", r.eps_mean), f("eps_variance", r.eps_variance);
  f("drift_unknown", r.drift_unknown), f("drift_of_mean", r.drift_of_mean),
      f("drift_of_walk", r.drift_of_walk);
  f("rejected_out_of_domain", r.rejected_out_of_domain), f("rejected_metropolis", r.rejected_metropolis);
  f("us_per_particle_step", r.us_per_particle_step), f("E_0", r.E_0), f("heat_capacity", r.heat_capacity);
  f("bins_lower", r.bins.lower), f("bins_upper", r.bins.upper), f("bins_count", r.bins.count);
  f("first_half", r.first_half), f("second_half", r.second_half);
  f("times", r.times), f("energies", r.energies);
}

std::string identity(Scene const& scene, cg::Bins const& bins) {
  return fmt::format("{}\nbins {} {} {}\n{}{}", resolved_toml(scene), bins.lower, bins.upper, bins.count,
                     git_commit(), input_hashes(scene));
}

void write_trial(std::filesystem::path const& file, std::string const& identity,
                 sdpd::TrialResult const& result) {
  write_part(file, identity, result);
}

std::optional<sdpd::TrialResult> read_trial(std::filesystem::path const& file, std::string const& identity) {
  return read_part<sdpd::TrialResult>(file, identity);
}

} // namespace mesobridge::workflows
