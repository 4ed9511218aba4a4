#pragma once
#include "workflows/command.hpp"
#include <map>

namespace mesobridge::workflows {

/// A command of this program that is one stage of a chain, as a user would type it.
struct Stage {
  std::string title; ///< "melt of 6-3 stars"
  std::vector<std::string> words;
  std::filesystem::path product;        ///< a file that it writes at its end
  std::filesystem::path begun = {};     ///< a file from which it goes on with --resume; empty: it cannot
  std::vector<std::string> afresh = {}; ///< further words where it does not go on
  bool beside_next = false;             ///< does not need to end before the next one begins
};

/// The stage as a line for a shell.
std::string line_of(Stage const& stage);

/// The processor time of each stage of a journal, in its last call, by its line [s]. Throws InputError where
/// the file is no journal.
std::map<std::string, double> stage_seconds(std::filesystem::path const& journal);

/// Whether some of them went on after an interruption, so that its seconds are not those of the whole.
bool has_resumed(std::filesystem::path const& journal);

/// Makes those of the stages that are not there yet, each as a process of its own, one after the other or
/// several at once, and notes in `journal` what is done and what is begun; one that was interrupted goes on.
/// From the first stage that is called otherwise than the journal says, or whose product is not there, all
/// are made anew, those of a longer list that the journal has, too. Throws as farm.
void make_stages(std::vector<Stage> const& stages, std::filesystem::path const& journal,
                 Context const& context);

} // namespace mesobridge::workflows
