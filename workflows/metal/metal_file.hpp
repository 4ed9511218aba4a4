#pragma once
#include "md/metal.hpp"
#include "workflows/provenance.hpp"
#include "workflows/store/store.hpp"
#include <span>

namespace mesobridge::workflows {

/// The samples of one state of a metal; `end` is there once the run is complete.
struct MetalSeries {
  md::MetalState state;
  std::vector<md::MetalSample> samples;
  std::optional<md::MetalEnd> end;
};

/// The raw series of runs of a metal as they arrive, in SI. Every batch is flushed: what an interrupted run
/// has sampled stays readable, and its complete states can be kept by the next.
class MetalFile {
 public:
  /// Creates the file with the settings and the series that an earlier run left. A file of the same name is
  /// replaced in one go. Throws EnvironmentError.
  MetalFile(std::filesystem::path const& file, md::MetalSettings const& settings,
            Provenance const& provenance, std::span<MetalSeries const> kept);

  /// A further state; returns its index in the file.
  std::size_t add(md::MetalState state);
  void append(std::size_t index, std::span<md::MetalSample const> samples);
  void finish(std::size_t index, md::MetalEnd const& end);
  void close();

 private:
  Store store_;
  std::size_t states_ = 0;
};

struct MetalData {
  std::string fingerprint; ///< of all settings that decide the samples
  std::vector<MetalSeries> series;
};

/// A text that is the same for the same settings: their description, the seed and the hash of the potential
/// file.
std::string fingerprint(md::MetalSettings const& settings);

/// Throws InputError if the file is missing or holds something else.
MetalData read_metal_file(std::filesystem::path const& file);

} // namespace mesobridge::workflows
