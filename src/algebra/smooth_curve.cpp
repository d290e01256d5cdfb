#include "coilwright/algebra/smooth_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace coilwright::algebra {
namespace {

constexpr std::size_t around = 5;

// Weights of the rows from `from` to one before `to` in the slope at `row`: Lagrange's formula. At most `around` rows.
std::array<double, around> slope_weights(std::span<const double> times, std::size_t row, std::size_t from,
                                         std::size_t to) {
  std::array<double, around> out{};
  for (std::size_t k = from; k < to; ++k) {
    if (k == row) continue;
    double weight = 1.0 / (times[k] - times[row]);
    for (std::size_t j = from; j < to; ++j)
      if (j != row && j != k) weight *= (times[row] - times[j]) / (times[k] - times[j]);
    out[k - from] = weight;
    out[row - from] -= weight;
  }
  return out;
}

// The same in the middle of five rows that are evenly spaced.
constexpr std::array<double, around> even_weights = {1.0 / 12.0, -8.0 / 12.0, 0.0, 8.0 / 12.0, -1.0 / 12.0};

bool is_even(std::span<const double> times, std::size_t from) {
  constexpr double even = 1e-9;  // of a step
  const double step = 0.25 * (times[from + 4] - times[from]);
  for (std::size_t k = 1; k < 4; ++k)
    if (std::abs(times[from + k] - times[from] - static_cast<double>(k) * step) > even * step) return false;
  return true;
}

}  // namespace

SmoothCurve::SmoothCurve(std::span<const double> times, std::span<const double> values, std::size_t width)
    : width_(width), times_(times.begin(), times.end()), cubics_(values.size()) {
  const std::size_t rows = times_.size();
  const std::size_t used = std::min(around, rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t from = std::min(row > around / 2 ? row - around / 2 : 0, rows - used);
    std::array<double, around> weights = even_weights;
    double scale = 1.0;
    if (used == around && row == from + around / 2 && is_even(times_, from))
      scale = 4.0 / (times_[from + 4] - times_[from]);
    else
      weights = slope_weights(times_, row, from, from + used);
    for (std::size_t c = 0; c < width_; ++c) {
      Cubic& cubic = cubics_[row * width_ + c];
      cubic.value = values[row * width_ + c];
      for (std::size_t k = 0; k < used; ++k) cubic.slope += scale * weights[k] * values[(from + k) * width_ + c];
    }
  }
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    const double step = times_[row + 1] - times_[row];
    for (std::size_t c = 0; c < width_; ++c) {
      Cubic& a = cubics_[row * width_ + c];
      const Cubic& b = cubics_[(row + 1) * width_ + c];
      const double chord = (b.value - a.value) / step;
      a.bend = (3.0 * chord - 2.0 * a.slope - b.slope) / step;
      a.twist = (a.slope + b.slope - 2.0 * chord) / (step * step);
    }
  }
}

// Rows are about evenly spaced: few steps from where a time would be if they were.
std::size_t SmoothCurve::interval_of(double time) const {
  const std::size_t intervals = times_.size() - 1;
  const double share = (time - times_.front()) / (times_.back() - times_.front());
  auto out = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(intervals));
  out = std::min(out, intervals - 1);
  while (out > 0 && time < times_[out]) --out;
  while (out + 1 < intervals && time >= times_[out + 1]) ++out;
  return out;
}

void SmoothCurve::at(double time, std::span<double> out) const {
  const std::size_t interval = interval_of(time);
  const double d = time - times_[interval];
  for (std::size_t c = 0; c < width_; ++c) {
    const Cubic& of = cubic(interval, c);
    out[c] = of.value + d * (of.slope + d * (of.bend + d * of.twist));
  }
}

}  // namespace coilwright::algebra
