#pragma once
#include "sdpd/observe/equilibrium.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <optional>

/// Finished parts of a study in files, so that an interrupted study goes on. What a part is made of stands in
/// an overload of
///     template <class Result, class F> void for_each_member(Result& result, F const& f)
/// which calls f(key, member) for all members: one list serves writing and reading. Numbers read back to the
/// same bits.
namespace mesobridge::workflows {

namespace stored {

template <class Value>
Json to_json(Value const& value) {
  return value;
}
inline Json to_json(cg::Estimate const& e) {
  return {e.mean, e.se, e.n_eff};
}
inline Json to_json(sdpd::Drift const& d) {
  return {d.rate, d.se};
}

template <class Value>
void from_json(Json const& json, Value& value) {
  value = json.get<Value>();
}
inline void from_json(Json const& json, cg::Estimate& e) {
  e = {json.at(0), json.at(1), json.at(2)};
}
inline void from_json(Json const& json, sdpd::Drift& d) {
  d = {json.at(0), json.at(1)};
}

} // namespace stored

/// Writes a part; `identity` says what it was made of. Throws EnvironmentError.
template <class Part>
void write_part(std::filesystem::path const& file, std::string const& identity, Part const& part) {
  Json json{{"identity", identity}};
  for_each_member(part, [&](char const* key, auto const& value) { json[key] = stored::to_json(value); });
  write_text_file(file, checked_dump(json) + "\n");
}

/// The stored part; nothing if there is none, if the file is damaged, or if it was made of something else.
template <class Part>
std::optional<Part> read_part(std::filesystem::path const& file, std::string const& identity) {
  if (!std::filesystem::is_regular_file(file))
    return std::nullopt;
  try {
    auto const json = Json::parse(read_text_file(file));
    if (json.at("identity") != identity)
      return std::nullopt;
    Part part;
    for_each_member(part, [&](char const* key, auto& value) { stored::from_json(json.at(key), value); });
    return part;
  } catch (Json::exception const&) {
    return std::nullopt; // it is made again
  }
}

/// The stored part, or else what make() returns, which is stored.
template <class Make>
auto stored_or_made(std::filesystem::path const& file, std::string const& identity, Make const& make) {
  using Part = decltype(make());
  if (auto part = read_part<Part>(file, identity))
    return std::move(*part);
  auto part = make();
  write_part(file, identity, part);
  return part;
}

} // namespace mesobridge::workflows
