#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace coilwright::algebra {

/// A smooth curve of several values through rows: cubics whose slope at each row is that of the polynomial through the
/// five rows around it (through all if there are fewer; two rows give a straight line). It is exact for polynomials up
/// to the third degree. Its first derivative is continuous; its second derivative jumps by about h^2 / 6 times the
/// fourth one, with h between rows.
class SmoothCurve {
 public:
  /// One value on one interval: v + d (slope + d (bend + d twist)), d from the row at which the interval begins.
  struct Cubic {
    double value{}, slope{}, bend{}, twist{};
  };

  /// Makes the curve of rows of `width` values, one row after the other in `values`. `times` ascend and are at least
  /// two.
  SmoothCurve(std::span<const double> times, std::span<const double> values, std::size_t width);

  /// Number of values of a row.
  [[nodiscard]] std::size_t width() const { return width_; }
  /// Times of the rows, ascending.
  [[nodiscard]] std::span<const double> times() const { return times_; }
  /// Index of the interval in which a time lies. Times outside belong to the first or the last interval.
  [[nodiscard]] std::size_t interval_of(double time) const;
  /// The cubic of one value on one interval, counted from 0.
  [[nodiscard]] const Cubic& cubic(std::size_t interval, std::size_t column) const {
    return cubics_[interval * width_ + column];
  }
  /// Writes the values at a time, (width). Outside the rows the nearest cubic continues.
  void at(double time, std::span<double> out) const;

 private:
  std::size_t width_ = 0;
  std::vector<double> times_;
  std::vector<Cubic> cubics_;  // of each interval in turn
};

}  // namespace coilwright::algebra
