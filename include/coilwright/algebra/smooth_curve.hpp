#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace coilwright::algebra {

/// A curve of several values through rows: cubics whose slopes at each row are those of the polynomial through the five
/// rows around it (through all where there are fewer; a straight line through two). Exact for polynomials up to the
/// third degree. Smooth once, and all but twice: the second derivative jumps by about h^2 / 6 times the fourth one, h
/// between rows.
class SmoothCurve {
 public:
  /// One value on one interval: v + d (slope + d (bend + d twist)), d from the row at which the interval begins.
  struct Cubic {
    double value{}, slope{}, bend{}, twist{};
  };

  /// Of rows of `width` values, one row after the other in `values`; `times` ascending, at least two.
  SmoothCurve(std::span<const double> times, std::span<const double> values, std::size_t width);

  /// How many values it has.
  [[nodiscard]] std::size_t width() const { return width_; }
  /// Of its rows, ascending.
  [[nodiscard]] std::span<const double> times() const { return times_; }
  /// The interval in which a time lies, from 0; times outside are in the first and the last one.
  [[nodiscard]] std::size_t interval_of(double time) const;
  /// Of one value on one interval, counted from 0.
  [[nodiscard]] const Cubic& cubic(std::size_t interval, std::size_t column) const {
    return cubics_[interval * width_ + column];
  }
  /// Writes the values at a time, (width). Beyond its ends the curve goes on as the nearest cubic.
  void at(double time, std::span<double> out) const;

 private:
  std::size_t width_ = 0;
  std::vector<double> times_;
  std::vector<Cubic> cubics_;  // of each interval in turn
};

}  // namespace coilwright::algebra
