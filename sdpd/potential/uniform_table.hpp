#pragma once
#include "sdpd/simd/wide_lanes.hpp"
#include <algorithm>
#include <functional>
#include <vector>

namespace mesobridge::sdpd {

/// Four coefficients for each of many equal intervals of r: piecewise polynomials that lanes look up fast.
class UniformTable {
 public:
  /// Enough that a cubic's error, which falls with the fourth power, is beneath every table's own.
  static constexpr std::size_t intervals = 2048;

  /// `coefficients(r, width)` belongs to the interval that begins at r.
  UniformTable(double begin, double end, std::function<Row(double r, double width)> const& coefficients)
      : begin_(begin), end_(end), per_width_(intervals / (end - begin)), rows_(intervals) {
    double const width = (end - begin) / intervals;
    for (std::size_t k = 0; k < intervals; ++k)
      rows_[k] = coefficients(begin + static_cast<double>(k) * width, width);
  }
  /// Distances and coefficients multiplied by these.
  UniformTable scaled(double distances, double coefficients) const {
    UniformTable table(*this);
    table.begin_ *= distances, table.end_ *= distances, table.per_width_ /= distances;
    for (auto& row : table.rows_)
      row *= coefficients;
    return table;
  }

  double begin() const { return begin_; }
  double end() const { return end_; }
  double per_width() const { return per_width_; }

  /// The coefficients at r with the place in its interval, t in 0 ... 1. Beyond its ends the table gives its
  /// first coefficients at t = 0 and its last at t = 1.
  template <class X>
  struct At {
    X c_0, c_1, c_2, c_3, t;
  };
  At<double> at(double r) const {
    double const x = place(r);
    std::size_t const k = interval(x);
    Row const& c = rows_[k];
    return {c[0], c[1], c[2], c[3], x - static_cast<double>(k)};
  }
  [[gnu::always_inline]] At<Lanes> at(Lanes const& r) const {
    std::array<std::size_t, lane_count> k;
    Lanes t;
    for (std::size_t l = 0; l < lane_count; ++l) {
      double const x = place(r[l]);
      k[l] = interval(x);
      t[l] = x - static_cast<double>(k[l]);
    }
    auto const [c_0, c_1, c_2, c_3] = load_rows([&](std::size_t l) { return &rows_[k[l]]; });
    return {c_0, c_1, c_2, c_3, t};
  }
  [[gnu::always_inline]] At<WideFloats> at(WideFloats const& r) const {
    auto const low = at(to_double(low_half(r))), high = at(to_double(high_half(r)));
    auto both = [](Lanes const& a, Lanes const& b) { return join(to_float(a), to_float(b)); };
    return {both(low.c_0, high.c_0), both(low.c_1, high.c_1), both(low.c_2, high.c_2),
            both(low.c_3, high.c_3), both(low.t, high.t)};
  }

 private:
  double place(double r) const {
    return std::min(std::max((r - begin_) * per_width_, 0.0), static_cast<double>(intervals));
  }
  static std::size_t interval(double x) { return std::min(static_cast<std::size_t>(x), intervals - 1); }

  double begin_, end_, per_width_;
  std::vector<Row> rows_;
};

} // namespace mesobridge::sdpd
