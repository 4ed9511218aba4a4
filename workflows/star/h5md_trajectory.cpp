#include "workflows/star/h5md_trajectory.hpp"
#include "md/error.hpp"
#include "workflows/store/store.hpp"
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace mesobridge::workflows {

namespace {

using Shape = Store::Shape;

std::string shape_text(Shape const& shape) {
  return fmt::format("{}", fmt::join(shape, " x "));
}

/// One element of the H5MD format: a dataset (fixed in time), or a group with value, step and perhaps time.
class Element {
 public:
  Element(Store const& store, std::string path) : store_(store), path_(std::move(path)) {
    fixed_ = !store.is_group(path_);
    value_ = fixed_ ? path_ : path_ + "/value";
    shape_ = store.shape(value_);
    if (fixed_)
      return;
    if (shape_.empty())
      refuse("is a single number: must have one row a frame");
    if (shape_[0] > 0) // refuses more rows than the file can hold, before there is a step for each
      store.read_row(value_, 0, {.bounds = {.finite = false}});
    read_steps();
    for (std::size_t row = 0; row < steps_.size(); ++row)
      rows_.emplace(steps_[row], row); // of rows with the same step the first
    read_times();
  }

  bool fixed() const { return fixed_; }
  std::string const& path() const { return path_; }
  std::string const& value() const { return value_; }
  std::vector<std::int64_t> const& steps() const { return steps_; }
  bool has(std::int64_t step) const { return fixed_ || rows_.contains(step); }
  std::optional<double> time(std::size_t row) const {
    return times_.empty() ? std::nullopt : std::optional(times_[row]);
  }
  /// The shape of one frame.
  Shape frame_shape() const { return fixed_ ? shape_ : Shape(shape_.begin() + 1, shape_.end()); }

  std::vector<double> numbers(std::int64_t step, Bounds const& bounds = {}) const {
    return fixed_ ? store_.read_doubles(value_, {.bounds = bounds})
                  : store_.read_row(value_, rows_.at(step), {.bounds = bounds});
  }
  std::vector<std::int64_t> integers(std::int64_t step, Bounds const& bounds) const {
    return fixed_ ? store_.read_integers(value_, {.bounds = bounds})
                  : store_.read_integer_row(value_, rows_.at(step), {.bounds = bounds});
  }
  std::optional<std::string> unit() const {
    return store_.has_attribute(value_, "unit") ? std::optional(store_.read_text_attribute(value_, "unit"))
                                                : std::nullopt;
  }
  std::optional<std::string> time_unit() const {
    auto const place = path_ + "/time";
    return !times_.empty() && store_.has_attribute(place, "unit")
               ? std::optional(store_.read_text_attribute(place, "unit"))
               : std::nullopt;
  }
  [[noreturn]] void refuse(std::string const& what) const {
    throw InputError(fmt::format("'{}': the element {} {}", store_.file().string(), path_, what));
  }

 private:
  /// One a row; or, as the format allows, the number of steps between rows, and the first one as `offset`.
  void read_steps() {
    auto const place = path_ + "/step";
    if (!store_.contains(place))
      refuse("has no step");
    if (store_.shape(place).empty()) {
      auto const every = store_.read_integers(place, {.bounds = {.least = 1}}).at(0);
      auto const first = store_.has_attribute(place, "offset")
                             ? store_.read_integer_attribute(place, "offset", {.least = 0, .most = 1e15})
                             : 0;
      if (double(every) * double(shape_[0]) > 1e15)
        refuse(fmt::format("has a row every {} steps: these are too many", every));
      for (std::size_t row = 0; row < shape_[0]; ++row)
        steps_.push_back(first + std::int64_t(row) * every);
      return;
    }
    refuse_other_rows(place);
    steps_ = store_.read_integers(place, {.rows = shape_[0], .row_shape = Shape{}, .bounds = {.least = 0}});
  }

  void read_times() {
    auto const place = path_ + "/time";
    if (!store_.contains(place))
      return;
    if (store_.shape(place).empty()) {
      double const every = store_.read_doubles(place, {.bounds = {.above = 0}}).at(0);
      double const first =
          store_.has_attribute(place, "offset") ? store_.read_double_attribute(place, "offset") : 0;
      for (std::size_t row = 0; row < shape_[0]; ++row)
        times_.push_back(first + double(row) * every);
      return;
    }
    refuse_other_rows(place);
    times_ = store_.read_doubles(place, {.rows = shape_[0], .row_shape = Shape{}});
  }

  void refuse_other_rows(std::string const& place) const {
    if (auto const rows = store_.shape(place); rows != Shape{shape_[0]})
      refuse(fmt::format("has a value of {}, but {} is {}: must have one row for each", shape_text(shape_),
                         place, shape_text(rows)));
  }

  Store const& store_;
  std::string path_, value_;
  bool fixed_ = false;
  Shape shape_;
  std::vector<std::int64_t> steps_;
  std::map<std::int64_t, std::size_t> rows_;
  std::vector<double> times_;
};

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
    if (position_.fixed())
      position_.refuse("has no steps: a trajectory is needed");
    check_shapes();
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
      std::vector<Element const*> others{&velocity_, &edges_};
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
  Element element(std::string const& name) const {
    auto const path = group_ + "/" + name;
    if (!store_.contains(path))
      throw InputError(
          fmt::format("'{}' has no {}: positions, velocities and the edges of the box are needed",
                      store_.file().string(), path));
    return Element(store_, path);
  }

  void check_shapes() const {
    auto const shape = position_.frame_shape();
    if (shape.size() != 2 || shape[1] != 3)
      position_.refuse(fmt::format("has a frame of {}: must be atoms x 3", shape_text(shape)));
    auto const atoms = shape[0], each = how_.atoms_per_molecule;
    if (position_.steps().empty())
      position_.refuse("has no frame");
    if (atoms == 0 || atoms % each != 0)
      throw InputError(
          fmt::format("'{}' has {} atoms, the mapping's molecules {} each: {} atoms are left out. "
                      "Map every atom",
                      store_.file().string(), atoms, each, atoms % each));
    if (auto const other = velocity_.frame_shape(); other != shape)
      velocity_.refuse(
          fmt::format("has frames of {}, the positions of {}", shape_text(other), shape_text(shape)));
    if (id_ && id_->frame_shape() != Shape{atoms})
      id_->refuse(fmt::format("has frames of {}: must be {}, one for each atom",
                              shape_text(id_->frame_shape()), atoms));
    if (auto const edges = edges_.frame_shape(); edges != Shape{3} && edges != Shape{3, 3})
      edges_.refuse(fmt::format("has frames of {}: must be 3 (the edges' lengths) or 3 x 3 (their vectors)",
                                shape_text(edges)));
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
  double factor(Element const& element, std::optional<std::string> const& unit, int lengths,
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

  Box box_at(std::int64_t step) const {
    auto const e = edges_.numbers(step);
    bool const vectors = e.size() == 9;
    if (vectors)
      for (std::size_t k = 0; k < 9; ++k)
        if (k % 4 != 0 && e[k] != 0)
          edges_.refuse(
              fmt::format("at step {} is a tilted box (edge vectors {}): only rectangular boxes are "
                          "read",
                          step, fmt::join(e, ", ")));
    Vec3 const edge = vectors ? Vec3{e[0], e[4], e[8]} : Vec3{e[0], e[1], e[2]};
    if (!(std::min({edge.x, edge.y, edge.z}) > 0))
      edges_.refuse(
          fmt::format("at step {} is {} x {} x {}: edges must be > 0", step, edge.x, edge.y, edge.z));
    return {edge_ * edge};
  }

  /// Places of the atoms in the order of their ids.
  std::vector<std::size_t> order_at(std::int64_t step, std::vector<std::int64_t>& ids) const {
    std::vector<std::size_t> order(position_.frame_shape()[0]);
    std::iota(order.begin(), order.end(), std::size_t{0});
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

  TrajectoryFrame frame(std::size_t row, std::int64_t step) const {
    TrajectoryFrame frame{.step = step, .box = box_at(step), .periodic = periodic_};
    if (auto const time = position_.time(row))
      frame.time = *time * time_;
    auto const order = order_at(step, frame.ids);
    auto const q = position_.numbers(step), v = velocity_.numbers(step);
    for (auto const k : order) {
      frame.q.push_back(length_ * Vec3{q[3 * k], q[3 * k + 1], q[3 * k + 2]});
      frame.v.push_back(velocity_factor_ * Vec3{v[3 * k], v[3 * k + 1], v[3 * k + 2]});
      check_distance(frame, k, step);
    }
    return frame;
  }

  void check_distance(TrajectoryFrame const& frame, std::size_t atom, std::int64_t step) const {
    constexpr double most_edges = 1e6; // farther away a position has lost the digits that tell its neighbours
    auto const& q = frame.q.back();
    auto const& edge = frame.box.edge;
    if (!(std::max({std::abs(q.x / edge.x), std::abs(q.y / edge.y), std::abs(q.z / edge.z)}) < most_edges))
      position_.refuse(
          fmt::format("has atom {} at step {} more than {:g} box edges away", atom, step, most_edges));
  }

  Store const& store_;
  TrajectoryReading const& how_;
  std::string group_;
  Element position_, velocity_, edges_;
  std::optional<Element> id_;
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
