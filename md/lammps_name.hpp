#pragma once
#include <filesystem>
#include <string>

namespace mesobridge::md {

/// A file under a name that LAMMPS takes as it stands. In a path as people write them LAMMPS would put steps
/// and ranks in the place of * and %, put other letters in the place of those beyond ASCII, and end the name
/// at a quotation mark; such a path is given as one beneath /proc/self/fd, which holds while this lives.
class LammpsName {
 public:
  /// Of a file that LAMMPS reads, or writes into a folder that is there. Throws EnvironmentError when the
  /// file or the folder cannot be opened, and InputError for a new file whose own name LAMMPS would change.
  explicit LammpsName(std::filesystem::path const& file);
  ~LammpsName();
  LammpsName(LammpsName const&) = delete;
  LammpsName& operator=(LammpsName const&) = delete;

  std::string const& text() const { return text_; }

 private:
  std::string text_;
  int descriptor_ = -1; ///< of the file or its folder; none where the path serves as it is
};

} // namespace mesobridge::md
