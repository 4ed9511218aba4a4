#pragma once
#include "md/box.hpp"
#include "workflows/provenance.hpp"
#include "workflows/store/store.hpp"
#include <map>
#include <span>

namespace mesobridge::workflows {

/// A trajectory of N particles in the H5MD 1.1 format (de Buyl, Colberg and Hofling, Comput. Phys. Commun.
/// 185 (2014) 1546), which MDAnalysis, VMD and others open: one group of particles, `all`, with explicit
/// steps and times, and scalar series under `observables`. Each frame is flushed; what
/// was there at the last mark() survives the program's death at any moment.
class H5mdWriter {
 public:
  /// What a number in the caller's units is worth in the file's: nm and ps for SI data (so length = 1e9,
  /// time = 1e12); no units are written for reduced ones (all factors 1).
  struct Units {
    double length = 1;
    double time = 1;
    bool physical = false;
    static Units si() { return {.length = 1e9, .time = 1e12, .physical = true}; }
    static Units reduced() { return {}; }
  };

  /// One frame, in the caller's units; the velocities may be left out, always or never.
  struct Frame {
    std::int64_t step = 0;
    double time = 0;
    Box box;
    std::span<Vec3 const> positions;
    std::span<Vec3 const> velocities;
    /// Further elements, a number a particle, by names that carry their unit ("T_K"): the file calls them T,
    /// with an attribute `unit`. In the units that they have.
    std::span<std::pair<std::string, std::vector<double>> const> scalars = {};
  };

  /// Creates the file, of a box that is periodic along some of its edges. Throws EnvironmentError.
  H5mdWriter(std::filesystem::path const& file, Units units, Provenance const& provenance,
             std::array<bool, 3> periodic = {true, true, true});

  /// Opens a file that an earlier run wrote, to append to it. Throws InputError, EnvironmentError.
  static H5mdWriter continue_file(std::filesystem::path const& file, Units units);

  void append(Frame const& frame);

  /// Step of the last frame in the file, -1 if there is none.
  std::int64_t last_step() const;

  /// Appends one value to the series observables/NAME; the unit ("Pa") is noted at the first one.
  void append_observable(std::string const& name, std::int64_t step, double time, double value,
                         std::string const& unit = "");

  void flush();
  void mark() { store_.mark(); } ///< the frames so far are safe
  void close();

 private:
  H5mdWriter(Store store, Units units)
      : store_(std::move(store)), units_(units), continued_(last_step() >= 0) {}
  void append_scalar(Frame const& frame, std::string const& name, std::vector<double> const& values);
  void describe(std::string const& group, std::string const& unit);
  void append_vectors(std::string const& group, Frame const& frame, std::span<Vec3 const> values,
                      double factor, std::string const& unit);

  Store store_;
  Units units_;
  bool continued_ = false; ///< with the elements that the file has
};

} // namespace mesobridge::workflows
