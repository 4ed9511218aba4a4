#include "workflows/trajectory/h5md_trajectory.hpp"
#include "md/error.hpp"
#include "workflows/trajectory/edge_vectors.hpp"
#include "workflows/trajectory/h5md_kinds.hpp"
#include <algorithm>
#include <map>
#include <numeric>

namespace mesobridge::workflows {

namespace {

using Shape = Store::Shape;

/// The particles' group that is meant.
std::string group_of(Store const& store, std::string const& wanted) {
  std::vector<std::string> names;
  if (store.is_group("particles"))
    for (auto const& name : store.list("particles"))
      if (store.contains("particles/" + name + "/position"))
        names.push_back(name);
  if (names.empty())
    throw InputError(
        fmt::format("'{}' has no group of particles with a position (particles/all/position, say)",
                    store.file().string()));
  if (wanted.empty() && names.size() > 1)
    throw InputError(fmt::format("'{}' has several groups of particles: choose one with --group: {}",
                                 store.file().string(), fmt::join(names, ", ")));
  if (!wanted.empty() && std::ranges::find(names, wanted) == names.end())
    throw InputError(
        fmt::format("--group {}: '{}' has {}", wanted, store.file().string(), fmt::join(names, ", ")));
  return "particles/" + (wanted.empty() ? names[0] : wanted);
}

class H5mdTrajectory {
 public:
  H5mdTrajectory(Store const& store, TrajectoryReading const& how)
      : store_(store), how_(how), group_(group_of(store, how.group)), position_(element("position")),
        velocity_(element("velocity")), edges_(element("box/edges")) {
    if (store.contains(group_ + "/id"))
      id_.emplace(store, group_ + "/id");
    if (!id_ && !how_.atoms.empty())
      how_.warn(fmt::format(
          "'{}': {} has no element id: its atoms are taken as those of the data file in the order "
          "of their ids",
          store.file().string(), group_));
    if (position_.fixed())
      position_.refuse("has no steps: a trajectory is needed");
    check_shapes();
    kinds_.emplace(store, group_, position_.frame_shape()[0], how);
    read_boundary();
    length_ = factor(position_, position_.unit(), 1, 0);
    edge_ = factor(edges_, edges_.unit(), 1, 0);
    velocity_factor_ = factor(velocity_, velocity_.unit(), 1, -1);
    time_ = factor(position_, position_.time_unit(), 0, 1);
  }

  void read_all(std::function<void(TrajectoryFrame const&)> const& consume) {
    std::map<std::string, std::size_t> missing;
    std::size_t used = 0;
    for (std::size_t row = 0; row < position_.steps().size(); ++row) {
      auto const step = position_.steps()[row];
      std::vector<H5mdElement const*> others{&velocity_, &edges_};
      if (id_)
        others.push_back(&*id_);
      bool whole = true;
      for (auto const* other : others)
        if (!other->has(step))
          ++missing[other->path()], whole = false;
      if (whole)
        consume(frame(row, step)), ++used;
    }
    auto const all = position_.steps().size();
    for (auto const& [path, count] : missing) {
      auto const what = fmt::format("'{}': the element {} has no row at {} of the {} steps of the positions",
                                    store_.file().string(), path, count, all);
      if (used == 0)
        throw InputError(what + ": no frame has all that is needed");
      how_.warn(fmt::format("{}: the {} frames that have all are used", what, used));
    }
  }

 private:
  H5mdElement element(std::string const& name) const {
    auto const path = group_ + "/" + name;
    if (!store_.contains(path))
      throw InputError(
          fmt::format("'{}' has no {}: positions, velocities and the edges of the box are needed",
                      store_.file().string(), path));
    return H5mdElement(store_, path);
  }

  void check_shapes() const {
    auto const shape = position_.frame_shape();
    if (shape.size() != 2 || shape[1] != 3)
      position_.refuse(fmt::format("has a frame of {}: must be atoms x 3", extents_text(shape)));
    auto const atoms = shape[0], each = how_.atoms.empty() ? how_.atoms_per_molecule : how_.atoms.size();
    if (!how_.atoms.empty() && atoms != each)
      position_.refuse(fmt::format("has {} atoms: the data file of the mapping has {} (it must be that of "
                                   "the whole system, as write_data writes it)",
                                   atoms, each));
    if (position_.steps().empty())
      position_.refuse("has no frame");
    if (atoms == 0 || atoms % each != 0)
      throw InputError(
          fmt::format("'{}' has {} atoms, the mapping's molecules {} each: {} atoms are left out. "
                      "Map every atom",
                      store_.file().string(), atoms, each, atoms % each));
    if (auto const other = velocity_.frame_shape(); other != shape)
      velocity_.refuse(
          fmt::format("has frames of {}, the positions of {}", extents_text(other), extents_text(shape)));
    if (id_ && id_->frame_shape() != Shape{atoms})
      id_->refuse(fmt::format("has frames of {}: must be {}, one for each atom",
                              extents_text(id_->frame_shape()), atoms));
    if (auto const edges = edges_.frame_shape(); edges != Shape{3} && edges != Shape{3, 3})
      edges_.refuse(fmt::format("has frames of {}: must be 3 (the edges' lengths) or 3 x 3 (their vectors)",
                                extents_text(edges)));
  }

  void read_boundary() {
    auto const box = group_ + "/box";
    if (store_.has_attribute(box, "dimension") && store_.read_integer_attribute(box, "dimension") != 3)
      throw InputError(
          fmt::format("'{}': the attribute 'dimension' of {} must be 3", store_.file().string(), box));
    if (!store_.has_attribute(box, "boundary")) {
      how_.warn(fmt::format("'{}': {} has no attribute 'boundary': it is taken as periodic",
                            store_.file().string(), box));
      return;
    }
    auto const texts = store_.read_text_attributes(box, "boundary");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto const& text = texts.at(texts.size() == 3 ? axis : 0); // one for all, as some programs write
      if ((texts.size() != 3 && texts.size() != 1) || (text != "periodic" && text != "none"))
        throw InputError(fmt::format("'{}': the attribute 'boundary' of {} is [{}]: must be \"periodic\" or "
                                     "\"none\", three times",
                                     store_.file().string(), box, fmt::join(texts, ", ")));
      periodic_[axis] = text == "periodic";
    }
  }

  /// What the element's unit is worth in the mapping's; without one it is in the mapping's.
  double factor(H5mdElement const& element, std::optional<std::string> const& unit, int lengths,
                int times) const {
    if (!unit || unit->empty() || *unit == "1")
      return 1;
    double si = 0;
    try {
      si = value_in_si(*unit, lengths, times);
    } catch (InputError const& error) {
      element.refuse(fmt::format("cannot be read: {}", error.what()));
    }
    if (how_.units.reduced())
      element.refuse(
          fmt::format("is in '{}', the mapping in units = \"{}\"{}: say in the mapping which units its "
                      "own values have (units = \"real\", \"metal\", \"si\", ...)",
                      *unit, how_.units.name, how_.units_given ? "" : " (the default)"));
    return si / (std::pow(how_.units.length, lengths) * std::pow(how_.units.time, times));
  }

  TurnedBox box_at(std::int64_t step) const {
    auto const e = edges_.numbers(step);
    if (e.size() == 9) {
      auto const edge = [&](std::size_t row) { return edge_ * Vec3{e[row], e[row + 1], e[row + 2]}; };
      auto const found = box_of_edges(edge(0), edge(3), edge(6));
      if (!found)
        edges_.refuse(
            fmt::format("at step {} are the vectors {}, which make no box: they must be right-handed and "
                        "not lie in one plane",
                        step, fmt::join(e, ", ")));
      return *found;
    }
    Vec3 const edge{e[0], e[1], e[2]};
    if (!(std::min({edge.x, edge.y, edge.z}) > 0))
      edges_.refuse(
          fmt::format("at step {} is {} x {} x {}: edges must be > 0", step, edge.x, edge.y, edge.z));
    return {.box = {edge_ * edge}};
  }

  /// Places of the atoms in the order of those that are expected, or of their ids.
  std::vector<std::size_t> order_at(std::int64_t step, std::vector<std::int64_t>& ids) const {
    std::vector<std::size_t> order(position_.frame_shape()[0]);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!how_.atoms.empty())
      return expected_order_at(step, ids);
    if (!id_)
      return order;
    auto const found = id_->integers(step, {.least = 0});
    std::ranges::sort(order, {}, [&](std::size_t k) { return found[k]; });
    for (auto const k : order)
      ids.push_back(found[k]);
    if (auto const twice = std::ranges::adjacent_find(ids); twice != ids.end())
      id_->refuse(fmt::format("has the id {} twice at step {}", *twice, step));
    return order;
  }

  /// Without an element `id` atom k has the id k + 1.
  std::vector<std::size_t> expected_order_at(std::int64_t step, std::vector<std::int64_t>& ids) const {
    std::map<std::int64_t, std::size_t> place;
    auto const atoms = how_.atoms.size();
    auto const found = id_ ? id_->integers(step, {.least = 0}) : std::vector<std::int64_t>{};
    for (std::size_t k = 0; k < atoms; ++k)
      place[id_ ? found[k] : std::int64_t(k + 1)] = k;
    std::vector<std::size_t> order;
    for (auto const& atom : how_.atoms) {
      auto const at = place.find(atom.id);
      if (at == place.end())
        position_.refuse(fmt::format("has no atom {} at step {}, which the mapping's data file has{}",
                                     atom.id, step, id_ ? "" : " (no element id: atoms are counted from 1)"));
      order.push_back(at->second), ids.push_back(atom.id);
    }
    return order;
  }

  TrajectoryFrame frame(std::size_t row, std::int64_t step) const {
    auto const box = box_at(step);
    TrajectoryFrame frame{
        .step = step, .box = box.box, .may_tilt = edges_.frame_shape() == Shape{3, 3}, .periodic = periodic_};
    if (auto const time = position_.time(row))
      frame.time = *time * time_;
    auto const order = order_at(step, frame.ids);
    kinds_->check(step, order);
    auto const q = position_.numbers(step), v = velocity_.numbers(step);
    for (auto const k : order) {
      frame.q.push_back(box.turned(length_ * Vec3{q[3 * k], q[3 * k + 1], q[3 * k + 2]}));
      frame.v.push_back(box.turned(velocity_factor_ * Vec3{v[3 * k], v[3 * k + 1], v[3 * k + 2]}));
      check_distance(frame, k, step);
    }
    return frame;
  }

  void check_distance(TrajectoryFrame const& frame, std::size_t atom, std::int64_t step) const {
    constexpr double most_edges = 1e6; // farther away a position has lost the digits that tell its neighbours
    Vec3 const part = frame.box.parts(frame.q.back());
    if (!(std::max({std::abs(part.x), std::abs(part.y), std::abs(part.z)}) < most_edges))
      position_.refuse(
          fmt::format("has atom {} at step {} more than {:g} box edges away", atom, step, most_edges));
  }

  Store const& store_;
  TrajectoryReading const& how_;
  std::string group_;
  H5mdElement position_, velocity_, edges_;
  std::optional<H5mdElement> id_;
  std::optional<H5mdKinds> kinds_;
  std::array<bool, 3> periodic_{true, true, true};
  double length_ = 1, edge_ = 1, velocity_factor_ = 1, time_ = 1;
};

} // namespace

void read_h5md_trajectory(std::filesystem::path const& file, TrajectoryReading const& how,
                          std::function<void(TrajectoryFrame const&)> const& consume) {
  Store const store(file, Store::Mode::read);
  H5mdTrajectory(store, how).read_all(consume);
}

} // namespace mesobridge::workflows
