#include "workflows/summary.hpp"
#include "workflows/lj/fit_summary.hpp"
#include "workflows/lj/state_grid_file.hpp"
#include "workflows/lj_to_sdpd/chain.hpp"

namespace mesobridge::workflows {
namespace {

Json runs_json(std::vector<RunResult> const& runs) {
  Json list = Json::array();
  for (auto const& run : runs)
    list.push_back(run.summary);
  return list;
}

} // namespace

Json chain_summary(ChainResults const& results) {
  Json json;
  json["md"] = {{"settings", results.md_description}, {"states", state_grid_json(results.grid)}};
  json["fit"] = fit_json(results.fit);
  auto put_difference = [&](std::string const& name, fitting::LjBwrFit::Difference const& difference) {
    json["fit"]["largest_relative_difference_from_" + name] = {{"U", difference.U}, {"P", difference.P}};
  };
  put_difference("published", results.fit.difference_from_published());
  put_difference("published_in_its_range",
                 results.fit.difference_from_published(fitting::LjBwrFit::published_T_max));
  put_difference("kolafa_nezbeda", results.fit.difference_from_kolafa_nezbeda());
  json["sdpd"] = {{"fluid", runs_json(results.fluid)},
                  {"published", runs_json(results.published)},
                  {"ideal_gas", runs_json(results.ideal)},
                  {"drift", runs_json(results.drift)}};
  for (std::size_t k = 0; k < results.ideal.size(); ++k) {
    auto const test = gamma_test(results.ideal[k]);
    json["sdpd"]["ideal_gas"][k]["kolmogorov_smirnov_distance"] = test.distance;
    json["sdpd"]["ideal_gas"][k]["kolmogorov_smirnov_p"] = test.p_value;
  }
  for (auto const& law : drift_laws(results.drift)) {
    if (law.exponent.n_eff == 0)
      continue;
    Json entry{{"K", law.K}};
    put(entry, "exponent", law.exponent);
    put(entry, "prefactor", law.prefactor);
    json["sdpd"]["drift_laws"].push_back(entry);
  }
  return json;
}

} // namespace mesobridge::workflows
