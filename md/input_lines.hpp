#pragma once
#include "md/error.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace mesobridge::md {

/// A line of a file of LAMMPS's kind, without its comment.
struct InputLine {
  std::string origin; ///< "in.settings:12"
  std::vector<std::string> words;
  std::string comment; ///< what follows #, without blanks about it

  std::string text() const; ///< the words with a blank between each two
};

/// The lines of a file, also those without words. Lines that end in & are joined with the next where
/// `joined`. Throws InputError when the file cannot be read.
std::vector<InputLine> read_input_lines(std::filesystem::path const& file, bool joined);

/// One finite number, or a whole one. Throw InputError with the line's origin and `what` the word is.
double number_in(InputLine const& line, std::size_t word, std::string const& what);
std::int64_t whole_in(InputLine const& line, std::size_t word, std::string const& what);

/// Throws InputError that begins with the line's origin.
[[noreturn]] void refuse_line(InputLine const& line, std::string const& why);

} // namespace mesobridge::md
