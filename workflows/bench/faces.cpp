#include "workflows/bench/faces.hpp"
#include "md/processor_clock.hpp"
#include "sdpd/conservative/refresh.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/bench/paired_times.hpp"
#include "workflows/bench/settle.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr std::uint32_t lengths_of_vacuum_box = 10;

/// A system that takes the particles of a checkpoint, moved by some way.
class TimedBox {
 public:
  TimedBox(std::string name, sdpd::SimulationSettings const& settings, Vec3 const& way)
      : name_(std::move(name)), system_(make_system(settings)),
        sub_steps_(sub_steps(settings.scheme, *system_, settings.dt)), features_(settings.features()),
        way_(way) {}

  std::string const& name() const { return name_; }
  double neighbours() const {
    return 2.0 * static_cast<double>(system_->neighbours.pair_count()) / static_cast<double>(system_->size());
  }

  double renewals_per_step() const { return renewals_per_step_; } ///< of the lists, when last timed

  /// Microseconds per particle and step, of all steps and of those that renew no lists (0 where all do).
  struct Cost {
    double of_all, of_plain;
  };
  /// From the particles of the checkpoint on.
  Cost time(sdpd::Checkpoint const& start, int steps) {
    begin(start);
    auto const renewed = system_->renewals;
    double all = 0, plain = 0;
    int plain_steps = 0;
    for (int k = 0; k < steps; ++k) {
      auto const before = system_->renewals;
      md::ProcessorClock const clock; // in which other programs on the machine count for less
      sdpd::step(*system_, sub_steps_);
      double const seconds = clock.seconds();
      all += seconds;
      if (system_->renewals == before)
        plain += seconds, ++plain_steps;
    }
    renewals_per_step_ = static_cast<double>(system_->renewals - renewed) / steps;
    double const scale = 1e6 / static_cast<double>(system_->size());
    return {scale * all / steps, scale * plain / std::max(plain_steps, 1)};
  }

 private:
  void begin(sdpd::Checkpoint const& start) {
    auto& particles = system_->particles;
    particles.resize(start.particles.size(), features_);
    particles.id = start.particles.id, particles.p = start.particles.p;
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles.q[i] = start.particles.q[i] + way_;
    for (auto const& field : sdpd::fields)
      if (field.checkpointed)
        particles.*field.values = start.particles.*field.values;
    system_->step = start.step;
    system_->neighbours.renew(particles);
    refresh(*system_);
  }

  std::string name_;
  std::unique_ptr<sdpd::System> system_;
  std::vector<sdpd::SubStep> sub_steps_;
  sdpd::Features features_;
  Vec3 way_;
  double renewals_per_step_ = 0;
};

/// Positions within the periodic box, as walls need them.
sdpd::Checkpoint settled(sdpd::SimulationSettings const& periodic) {
  sdpd::Simulation simulation(periodic);
  settle(simulation);
  auto checkpoint = simulation.checkpoint();
  for (auto& q : checkpoint.particles.q)
    q = simulation.box().wrap(q);
  return checkpoint;
}

std::vector<TimedBox> boxes_of(sdpd::SimulationSettings const& periodic) {
  auto walls = periodic, open = periodic;
  walls.faces = sdpd::walls_along(2);
  for (auto& face : open.faces[2])
    face.kind = sdpd::FaceKind::open;
  auto vacuum = open;
  vacuum.lattice[2] *= lengths_of_vacuum_box;
  double const length = component(box_of(periodic).edge, 2);
  std::vector<TimedBox> boxes;
  boxes.emplace_back("periodic", periodic, Vec3{});
  boxes.emplace_back("two walls", walls, Vec3{});
  boxes.emplace_back("two open faces", open, Vec3{});
  boxes.emplace_back("90 % vacuum", vacuum, Vec3{0, 0, 0.5 * (lengths_of_vacuum_box - 1) * length});
  return boxes;
}

} // namespace

Json time_faces(sdpd::SimulationSettings const& periodic, FacesTiming const& timing) {
  auto const start = settled(periodic);
  auto boxes = boxes_of(periodic);
  std::vector<PairedTimes> times(boxes.size()), plain(boxes.size());
  for (int repeat = 0; repeat < timing.repeats; ++repeat)
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      auto const cost = boxes[k].time(start, timing.steps);
      times[k].cost.push_back(cost.of_all);
      times[k].ratio.push_back(cost.of_all / times[0].cost.back());
      plain[k].cost.push_back(cost.of_plain);
      plain[k].ratio.push_back(plain[0].cost.back() > 0 ? cost.of_plain / plain[0].cost.back() : 0);
    }
  Json rows = Json::array();
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    Json row{{"box", boxes[k].name()}};
    put_times(row, times[k]);
    if (std::ranges::all_of(plain[k].ratio, [](double ratio) { return ratio > 0; }))
      put_times(row["without_renewals"], plain[k]);
    row["neighbours"] = boxes[k].neighbours();
    row["list_renewals_per_step"] = boxes[k].renewals_per_step();
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string faces_text(Json const& rows) {
  auto text = fmt::format("{} {:>14} {:>24}\n", times_head("box", "times the periodic one"), "renewals/step",
                          "without renewals");
  for (auto const& row : rows) {
    text += fmt::format("{} {:>14.3f}", times_line(row, "box"), row["list_renewals_per_step"].get<double>());
    if (row.contains("without_renewals"))
      text += fmt::format(" {:>14.3f} +- {:.3f}", row["without_renewals"]["ratio"].get<double>(),
                          row["without_renewals"]["ratio_se"].get<double>());
    text += '\n';
  }
  return text;
}

} // namespace mesobridge::workflows
