#pragma once
#include "md/lj_grid.hpp"
#include "workflows/provenance.hpp"
#include "workflows/store/store.hpp"
#include <span>

namespace mesobridge::workflows {

/// The raw series of a grid of Lennard-Jones runs as they arrive, in reduced units. Every batch is flushed:
/// what an interrupted run has sampled stays readable.
class LjGridFile {
 public:
  /// Creates the file with the states and the settings. Throws EnvironmentError.
  LjGridFile(std::filesystem::path const& file, std::span<md::LjState const> states,
             md::LjFluidSettings const& settings, Provenance const& provenance);

  void append(std::size_t state, std::span<md::ThermoSample const> samples);

  /// Marks the file as complete, or not, and closes it.
  void close(bool complete);

 private:
  Store store_;
};

/// What such a file holds.
struct LjGridData {
  struct Series {
    md::LjState state;
    std::vector<md::ThermoSample> samples;
  };
  std::vector<Series> series;
  int atoms = 0;
  std::string description; ///< of the runs, for people
  bool complete = false;   ///< false: the run was interrupted, and some series are short or empty
};

/// Throws InputError if the file is missing or holds something else.
LjGridData read_lj_grid(std::filesystem::path const& file);

} // namespace mesobridge::workflows
