#pragma once
#include "workflows/lj/preset.hpp"
#include "workflows/report/report.hpp"
#include <optional>

namespace mesobridge::workflows {

/// What a reproduction has found: its numbers and what a reader sees of them. The command adds provenance and
/// writes both.
struct Reproduced {
  Json summary; ///< keys with units; an uncertain number has a twin `_se`
  Report report;
};

/// How long to work and where scratch files may lie.
struct ReproduceOptions {
  md::Preset preset = md::Preset::quick;
  std::filesystem::path directory; ///< exists
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<std::string> fit = std::nullopt; ///< a fitted equation of the Lennard-Jones fluid
};

/// A figure or table of the thesis: ours beside the printed one.
struct Reproduction {
  std::string name;  ///< "table-4.1"
  std::string shows; ///< one line
  std::function<Reproduced(ReproduceOptions const&, Context const&)> run;
  bool takes_fit = false; ///< compares with ReproduceOptions::fit, too
};

/// Every figure and table that the program reproduces, in the order of the thesis. A new one is its own file
/// in this folder, and its name in list.cpp.
std::vector<Reproduction> const& reproductions();

} // namespace mesobridge::workflows
