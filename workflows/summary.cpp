#include "workflows/summary.hpp"
#include "md/error.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {

namespace {

void refuse_non_finite(Json const& value, std::string const& path) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw PhysicsError(fmt::format("result '{}' is {}: it is not written", path, value.get<double>()));
  if (value.is_object())
    for (auto const& [key, member] : value.items())
      refuse_non_finite(member, path.empty() ? key : path + "." + key);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      refuse_non_finite(value[i], fmt::format("{}[{}]", path, i));
}

} // namespace

void put(Json& object, std::string const& key, cg::Estimate const& estimate) {
  object[key] = estimate.mean;
  object[key + "_se"] = estimate.se;
}

std::string checked_dump(Json const& value) {
  refuse_non_finite(value, "");
  return value.dump(2, ' ', false, Json::error_handler_t::replace); // a byte that is no text becomes U+FFFD
}

void write_summary(std::filesystem::path const& file, Json const& value) {
  write_text_file(file, checked_dump(value) + "\n");
}

Result with_report(std::filesystem::path const& folder, Json summary, std::string const& html) {
  write_summary(folder / "summary.json", summary);
  auto const report = folder / "report.html";
  write_text_file(report, html);
  Result result{.json = std::move(summary), .text = report.string(), .complaint = {}};
  result.json["report"] = report.string();
  return result;
}

} // namespace mesobridge::workflows
