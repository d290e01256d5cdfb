#include "bending_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace coilwright::simulation {
namespace {

using Sample = Stepper::Bending;

// The motion between two samples over s = 0 to 1: Hermite's quintic.
class Arc {
 public:
  Arc(const Sample& a, const Sample& b) : start_(a.time), span_(b.time - a.time) {
    const double rise = b.angle - a.angle;
    const double v0 = a.speed * span_;
    const double v1 = b.speed * span_;
    const double a0 = a.acceleration * span_ * span_;
    const double a1 = b.acceleration * span_ * span_;
    c_ = {a.angle,
          v0,
          0.5 * a0,
          10.0 * rise - 6.0 * v0 - 4.0 * v1 - 0.5 * (3.0 * a0 - a1),
          -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 0.5 * (3.0 * a0 - 2.0 * a1),
          6.0 * rise - 3.0 * (v0 + v1) - 0.5 * (a0 - a1)};
  }

  [[nodiscard]] double time(double s) const { return start_ + s * span_; }
  [[nodiscard]] double angle(double s) const { return value(0, s); }
  [[nodiscard]] double speed(double s) const { return value(1, s) / span_; }

  // Where the speed (derivative 1) or the acceleration (derivative 2) passes zero, given its values at both ends, of
  // opposite sign. Newton's steps from the straight line between them; the arc is short, four reach rounding.
  [[nodiscard]] double root(int derivative, double first, double last) const {
    double s = first / (first - last);
    for (int i = 0; i < 4; ++i) {
      const double slope = value(derivative + 1, s);
      if (slope == 0.0) break;
      s = std::clamp(s - value(derivative, s) / slope, 0.0, 1.0);
    }
    return s;
  }

  // Time at which the angle passes `level` between s = low and 1, where it lies on different sides.
  [[nodiscard]] double crossing(double level, double low = 0.0) const {
    double high = 1.0;
    const bool rising = angle(low) < level;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      const bool before = (angle(middle) < level) == rising;
      (before ? low : high) = middle;
    }
    return time(0.5 * (low + high));
  }

 private:
  // The n-th derivative with respect to s.
  [[nodiscard]] double value(int n, double s) const {
    double sum = 0.0;
    for (int k = 5; k >= n; --k) {
      double factor = c_[static_cast<std::size_t>(k)];
      for (int i = 0; i < n; ++i) factor *= k - i;
      sum = sum * s + factor;
    }
    return sum;
  }

  double start_;
  double span_;
  std::array<double, 6> c_;
};

}  // namespace

BendingRecord::BendingRecord(const Stepper::Bending& start) {
  samples_.reserve(512);
  samples_.push_back(start);
}

BendingRecord::Peak BendingRecord::fastest() const {
  Peak peak{.speed = std::abs(samples_.front().speed), .time = samples_.front().time};
  const auto consider = [&](double speed, double time) {
    if (std::abs(speed) > peak.speed) peak = {.speed = std::abs(speed), .time = time};
  };
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const Sample& a = samples_[i - 1];
    const Sample& b = samples_[i];
    consider(b.speed, b.time);
    if (a.acceleration * b.acceleration >= 0.0) continue;
    const Arc arc(a, b);
    const double s = arc.root(2, a.acceleration, b.acceleration);
    consider(arc.speed(s), arc.time(s));
  }
  return peak;
}

double BendingRecord::beyond(double end) const {
  const double direction = end > samples_.front().angle ? 1.0 : -1.0;
  double most = 0.0;
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const Sample& a = samples_[i - 1];
    const Sample& b = samples_[i];
    most = std::max(most, direction * (b.angle - end));
    if (a.speed * b.speed >= 0.0) continue;
    const Arc arc(a, b);
    most = std::max(most, direction * (arc.angle(arc.root(1, a.speed, b.speed)) - end));
  }
  return most;
}

double BendingRecord::largest() const {
  double most = samples_.front().angle;
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const Sample& a = samples_[i - 1];
    const Sample& b = samples_[i];
    most = std::max(most, b.angle);
    if (a.speed <= 0.0 || b.speed >= 0.0) continue;
    const Arc arc(a, b);
    most = std::max(most, arc.angle(arc.root(1, a.speed, b.speed)));
  }
  return most;
}

std::optional<double> BendingRecord::first_passage(double level) const {
  for (std::size_t i = 1; i < samples_.size(); ++i)
    if ((samples_[i - 1].angle - level) * (samples_[i].angle - level) <= 0.0)
      return Arc(samples_[i - 1], samples_[i]).crossing(level);
  return std::nullopt;
}

double BendingRecord::last_outside(double end, double band) const {
  const auto outside = [&](double angle) { return std::abs(angle - end) > band; };
  const auto edge = [&](double angle) { return end + std::copysign(band, angle - end); };
  for (std::size_t i = samples_.size() - 1; i > 0; --i) {
    const Sample& a = samples_[i - 1];
    const Sample& b = samples_[i];
    if (outside(b.angle)) return b.time;
    const Arc arc(a, b);
    // A turning point may lie outside the band where both ends are inside.
    if (a.speed * b.speed < 0.0) {
      const double turning = arc.root(1, a.speed, b.speed);
      if (outside(arc.angle(turning))) return arc.crossing(edge(arc.angle(turning)), turning);
    }
    if (outside(a.angle)) return arc.crossing(edge(a.angle));
  }
  return 0.0;
}

}  // namespace coilwright::simulation
