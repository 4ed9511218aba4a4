#pragma once
#include <span>
#include <string>
#include <string_view>

namespace mesobridge::workflows {

/// The candidate with the smallest edit distance to the word (insertions, deletions, replacements and swaps
/// of neighbours count one each), or an empty string when none is near enough to be a misspelling.
std::string nearest(std::string_view word, std::span<std::string const> candidates);

/// "; did you mean 'x'?" or nothing.
std::string did_you_mean(std::string_view word, std::span<std::string const> candidates);

/// Throws InputError: "unknown shell 'fihs'; did you mean 'fish'?; known: bash, zsh, fish".
[[noreturn]] void refuse_unknown(std::string_view what, std::string_view word,
                                 std::span<std::string const> known);

} // namespace mesobridge::workflows
