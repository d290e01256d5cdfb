#include "coilwright/measurement/planning/input_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace coilwright::measurement::planning {
namespace {

struct Level {
  double time{};
  double duration{};

  double operator()(const StepShape& step) const { return time < step.at ? step.before : step.after; }
  double operator()(const SineShape& sine) const {
    return sine.offset + sine.amplitude * std::sin(2.0 * std::numbers::pi * sine.frequency * time);
  }
  // The phase is the integral of the frequency.
  double operator()(const ChirpShape& chirp) const {
    const double mean_frequency = chirp.from + 0.5 * (chirp.to - chirp.from) * time / duration;
    return chirp.offset + chirp.amplitude * std::sin(2.0 * std::numbers::pi * mean_frequency * time);
  }
  double operator()(const HoldShape& hold) const { return time < hold.from || time >= hold.until ? 0.0 : hold.level; }
  double operator()(const PulseShape& pulse) const {
    // Sample times are rounded: 3 * 0.1 must not count as the end of the third period.
    constexpr double rounding = 1e-9;
    const double periods = time / pulse.period + rounding;
    return periods - std::floor(periods) < pulse.duty ? pulse.high : pulse.low;
  }
  double operator()(const TableShape&) const { throw std::invalid_argument("a table has rows, not a level"); }
};

}  // namespace

double level_at(const InputShape& shape, double time, double duration) {
  return std::visit(Level{.time = time, .duration = duration}, shape);
}

}  // namespace coilwright::measurement::planning
