#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace mesobridge::md {
struct MoleculeStyles;
}

namespace mesobridge::workflows {

/// Options that several commands have. The values that they go to live as long as the parser.

/// --preset: quick, standard or paper.
CLI::Option* add_preset(CLI::App& app, std::string& preset, std::string const& text);

/// The command's one argument, one of some words, by its name ("shell"); whoever takes it refuses others.
void add_word(CLI::App& app, std::string const& name, std::string& word,
              std::vector<std::string> const& known);

/// The scene's file, and --set for its keys.
void add_scene(CLI::App& app, std::string& scene, std::vector<std::string>& set);

/// A file of blobs.
void add_blob_file(CLI::App& app, std::filesystem::path& file);

/// LAMMPS's data file of equal molecules, its commands for their force field, and styles that neither names.
void add_molecule_files(CLI::App& app, std::filesystem::path& data, std::filesystem::path& forces,
                        md::MoleculeStyles& styles);

/// Not for users: run_on_ranks says by it that another process tells the result.
void add_started_by_ourselves(CLI::App& app, bool& started_by_ourselves);

/// --checkpoint-every and --resume of a run of LAMMPS on several ranks, and the word for its ranks.
void add_restarts(CLI::App& app, std::int64_t& checkpoint_every, bool& resume, bool& started_by_ourselves);

/// One of several words; the help shows the default.
void add_choice(CLI::App& app, std::string const& name, std::string& value,
                std::vector<std::string> const& choices, std::string const& text);

/// Numbers separated by commas; the help's text says what they are where none are given.
void add_list(CLI::App& app, std::string const& name, std::vector<double>& values, std::string const& text);

/// A number within bounds; the help shows the default.
template <class Number, class Bound>
void add_bounded(CLI::App& app, std::string const& name, Number& value, Bound least, Bound most,
                 std::string const& text) {
  app.add_option(name, value, text)->check(CLI::Range(least, most))->capture_default_str();
}

} // namespace mesobridge::workflows
