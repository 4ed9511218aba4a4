#pragma once
#include "fuzz/trial.hpp"

namespace mesobridge::fuzz {

/// A number as files hold it when something went wrong: not finite, huge, tiny, negative, no number at all.
std::string odd_number(Random& random);

/// One to three changes as editors, spreadsheets, locales and broken disks make them. Says what was done.
std::string change_text(Random& random, std::filesystem::path const& file);

/// The same for bytes: flips, holes, cuts, tails.
std::string change_bytes(Random& random, std::filesystem::path const& file);

} // namespace mesobridge::fuzz
