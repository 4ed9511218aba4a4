#include "fitting/toml_text.hpp"
#include <fmt/core.h>
#include <sstream>
#include <toml++/toml.h>

namespace mesobridge::fitting {

std::string exact(double x) {
  std::string const text = fmt::format("{}", x);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string quoted(std::string const& text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

std::string array(std::span<double const> values) {
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i % 4 == 0 ? "\n  " : " ") + exact(values[i]) + ",";
  return text + "\n]";
}

std::string data_hash_text(std::string const& hash) {
  return hash.empty() ? "" : "data_hash = " + quoted(hash) + "\n";
}

std::string provenance_text(std::map<std::string, std::string> const& provenance) {
  std::string text = provenance.empty() ? "" : "\n[provenance]\n";
  for (auto const& [key, value] : provenance)
    text += quoted(key) + " = " + quoted(value) + "\n";
  return text;
}

} // namespace mesobridge::fitting
