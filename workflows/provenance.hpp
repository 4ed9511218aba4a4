#pragma once
#include "workflows/command.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// A file that was read, with the SHA-256 of its content as it was when this was made: a file that is edited
/// while the program runs was read before.
struct InputFile {
  std::filesystem::path path;
  std::string sha256;

  /// Throws InputError if it cannot be read.
  InputFile(std::filesystem::path file);
  InputFile(std::filesystem::path file, std::string known)
      : path(std::move(file)), sha256(std::move(known)) {}
};

/// Where a result comes from: enough to make it again.
struct Provenance {
  std::string command; ///< the command line
  std::uint64_t seed = 0;
  std::string scene;             ///< the resolved scene, if there is one
  std::vector<InputFile> inputs; ///< they are named with their SHA-256
};

/// Writes the group "provenance" of a file: version, git commit, command, seed, scene and the hashes of the
/// inputs. Throws EnvironmentError if the file cannot be written.
void write_provenance(Store& store, Provenance const& provenance);

/// The inputs that such a file names.
std::vector<InputFile> read_inputs(Store const& store);

/// The same as JSON.
Json provenance_json(Provenance const& provenance);

/// SHA-256 of a file's content, 64 hexadecimal digits. Throws InputError if it cannot be read.
std::string sha256_of_file(std::filesystem::path const& file);
std::string sha256(std::string_view text);

} // namespace mesobridge::workflows
