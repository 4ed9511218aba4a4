#pragma once
#include "md/box.hpp"
#include "sdpd/fluctuation/exact_pair.hpp"
#include "sdpd/fluctuation/pair_lanes.hpp"
#include "sdpd/lammps/rank_pairs.hpp"
#include "sdpd/method/parts.hpp"
#include "sdpd/simd/lanes.hpp"
#include <optional>

namespace mesobridge::sdpd {

/// How pairs that an integrator of this name steps one after the other go on; none for other integrators.
std::optional<PairScheme> scheme_in_turn(std::string_view integrator);

/// Pairs one after the other (SSA, AMS, EMS) on many ranks (sdpd/README.md, Eq. (S98)): the box is cut into
/// cells, each parity of cells begins blocks of two by two by two that share none, and all pairs of a block
/// are worked on by the rank in whose part of the box its middle lies, in an order that cells and ids decide.
/// So eight phases step every pair once, in the same order on any number of ranks.
class BlockSweep {
 public:
  /// Needs four cells at least along each axis: see fits().
  BlockSweep(Box const& box, double range);
  static bool fits(Box const& box, double range);

  /// How far from its part of the box a rank has to see, without the lists' skin.
  double reach() const { return std::max({cell_.x, cell_.y, cell_.z}); }

  struct Inputs {
    MethodParts const& parts;
    RankParticles const& particles;
    Particles const& own; ///< eps, rho, T and expansions of the own particles, where there are energies
    GhostExchange& ghosts;
    std::uint64_t seed, step;
    double time; ///< of the pairs' steps
    PairScheme scheme;
    PairCounts& counts; ///< of the pairs that this rank steps
  };
  /// Velocities and heat of the own particles after the sweep: rows (v, u).
  template <class Law>
  std::vector<Row> const& run(Law const& law, Inputs const& in, Failure& failure);

 private:
  static constexpr int fixed_stride = 8;
  enum Fixed { cell, T_0, inverse_C_0, curvature, limit, density, energy, fixed_width };
  using Cell = std::array<std::uint32_t, 3>;
  /// A particle in its cell; copies of one particle are no two.
  struct Member {
    std::uint32_t id, place;
    auto operator<=>(Member const&) const = default;
  };
  std::uint32_t number(Cell const& at) const { return (at[2] * count_[1] + at[1]) * count_[0] + at[0]; }
  Cell cell_of(double const* q) const;
  template <class Law>
  void begin(Inputs const& in);
  void sort_into_cells(RankParticles const& particles);
  std::array<std::vector<std::uint32_t>, 3> own_blocks(RankParticles const& particles) const;
  std::span<Member const> members(Cell const& at) const;
  void add_block(RankParticles const& particles, Cell const& base);
  void finish_blocks();
  template <class Law>
  void step_blocks(Law const& law, Inputs const& in, Failure& failure);
  void add_pairs(unsigned one, unsigned other);
  template <class Law>
  void draw_noise(Law const& law, Inputs const& in);
  template <class Law>
  void step_pairs(Law const& law, Inputs const& in, Failure& failure);
  /// Temperatures and 1/C of eight particles.
  struct ThermalLanes {
    Lanes T, inverse_C;
  };
  ThermalLanes thermal(Inputs const& in, ParticleLanes const& of, std::uint32_t const* who,
                       Failure& failure) const;
  template <class Law>
  Bath<Lanes> bath_of(Law const& law, Inputs const& in, ParticleLanes const& a, ParticleLanes const& b,
                      EightPairs const& at, Failure& failure) const;
  /// Eight pairs of a matching, from its pair `first` on, and the step that is proposed to them.
  template <class Law>
  struct Proposed {
    std::size_t first;
    ParticleLanes const &a, &b;
    EightPairs const& at;
    InputLanes<Law::across, Lanes> const& input;
    typename Bath<Lanes>::Directions const& step;
    VectorLanes<Lanes> const &v, &dv;
    Lanes const& heat;
  };
  /// The pairs whose step is made, a bit each. Those that an expansion does not reach are dealt with here,
  /// and are not among them.
  template <class Law>
  unsigned judge(Law const& law, Inputs const& in, Proposed<Law> const& of, Failure& failure);
  template <class Law>
  unsigned pass_metropolis(Law const& law, Inputs const& in, Proposed<Law> const& of, unsigned made) const;
  template <class Law>
  void step_exactly(Law const& law, Inputs const& in, Proposed<Law> const& of, std::size_t lane,
                    Failure& failure);

  Box box_;
  double range_;
  Cell count_;
  Vec3 cell_;
  std::vector<Row> state_, before_;            ///< of all; of the ghosts at the begin of a phase
  std::vector<double> fixed_;                  ///< rows of Fixed, which a sweep leaves as they are
  Particles seen_;                             ///< energies and rho of all, where an expansion does not reach
  std::vector<Member> members_;                ///< cell by cell
  std::vector<std::uint32_t> begins_, counts_; ///< of each cell's
  // Of some blocks of a phase, so that matchings fill their lanes: particles, cell by cell, and two phantoms;
  // pairs in matchings. Blocks share no particle, so each one's matchings are what they are alone.
  std::vector<Member> block_;
  std::array<std::size_t, 9> cells_;          ///< where each cell of the last block begins
  std::vector<Row> rows_;                     ///< positions and 1/rho
  std::array<std::vector<double>, 3> places_; ///< the positions once more
  std::vector<FluctuatingParticle> states_;
  std::vector<LocalPair> pairs_, ordered_;
  std::vector<std::uint32_t> ends_;
  std::array<std::vector<float>, 3> noise_;
  std::vector<std::uint32_t> bits_; ///< spare ones of the noise
};

} // namespace mesobridge::sdpd
