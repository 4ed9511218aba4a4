#pragma once
#include <boost/iostreams/filtering_stream.hpp>
#include <filesystem>
#include <string>

namespace mesobridge::workflows {

/// The lines of a text file, which may be packed: gzip, Zstandard, bzip2 and xz are told by their first
/// bytes, whatever the file's name.
class UnpackedLines {
 public:
  /// Throws InputError for a file that cannot be read.
  explicit UnpackedLines(std::filesystem::path const& file);

  /// Puts the next line there, without its end; false where the file ends, and for a last line without an
  /// end: it was cut off, as is a packed file that was not closed. Throws InputError where packed bytes are
  /// seen to be damaged.
  bool next(std::string& line);

  /// Whether a packed file ended without its own end, and so without a check of what was read. Zstandard does
  /// not tell.
  bool cut() const { return cut_; }

  bool packed() const { return packed_; }

 private:
  std::filesystem::path file_;
  boost::iostreams::filtering_istream in_;
  bool packed_ = false, cut_ = false;
};

} // namespace mesobridge::workflows
