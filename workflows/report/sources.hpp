#pragma once
#include <span>
#include <string_view>

namespace mesobridge::workflows {

/// A publication that reports compare with or use.
struct Source {
  std::string_view key;     ///< as texts cite it: "Kolafa and Nezbeda 1994"
  std::string_view authors; ///< all of them
  std::string_view title;
  std::string_view where; ///< journal, volume, pages; or the kind of the work
  int year;
  std::string_view link; ///< of its DOI, or of the archive that keeps it
};

/// All sources that reports know, in the order of their authors.
std::span<Source const> all_sources();

/// The source of a key; throws std::logic_error for one that is not in the list.
Source const& source(std::string_view key);

} // namespace mesobridge::workflows
