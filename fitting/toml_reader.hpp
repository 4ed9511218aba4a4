#pragma once
#include "md/error.hpp"
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <vector>

namespace mesobridge::fitting {

/// Strict access to one TOML table: whatever is missing, of the wrong type, not finite or unknown throws
/// InputError "file:line: key: what is allowed".
class TomlReader {
 public:
  TomlReader(toml::table const& table, std::string file, std::string path = "");

  bool has(std::string_view key) const { return table_.contains(key); }
  double number(std::string_view key);
  /// Exactly `count` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count);
  std::string text(std::string_view key);
  /// Different texts, each one of those allowed.
  std::vector<std::string> names(std::string_view key, std::vector<std::string> const& allowed);
  TomlReader table(std::string_view key);
  /// Every key of a table of strings.
  std::vector<std::pair<std::string, std::string>> texts();
  /// Refuses keys that no one asked for. To be called when everything has been read.
  void refuse_unknown() const;
  [[noreturn]] void refuse(toml::node const& node, std::string_view key,
                           std::string_view what_is_allowed) const;

 private:
  toml::node const& node(std::string_view key, std::string_view what_is_allowed);
  double finite(toml::node const& node, std::string_view key) const;

  toml::table const& table_;
  std::string file_, path_;
  std::vector<std::string> known_;
};

/// The keys that model files of every kind may have: `data_hash`, and the texts of the table [provenance].
template <class Model>
void read_origin(TomlReader& file, Model& model) {
  if (file.has("data_hash"))
    model.data_hash = file.text("data_hash");
  if (file.has("provenance"))
    for (auto& [key, value] : file.table("provenance").texts())
      model.provenance.emplace(key, value);
}

/// Throws InputError with file and line when the text is no TOML, or nested too deep (see refuse_deep_toml).
toml::table parse_toml(std::string_view text, std::string const& file);

/// What `read` makes of a file's table. An InputError of the models' own checks, which do not know the file,
/// gets its name.
template <class Read>
auto read_toml(std::string_view text, std::string const& file, Read const& read) {
  auto const table = parse_toml(text, file);
  try {
    return read(table, file);
  } catch (InputError const& error) {
    std::string const what = error.what();
    throw InputError(what.starts_with(file) ? what : fmt::format("{}: {}", file, what));
  }
}

} // namespace mesobridge::fitting
