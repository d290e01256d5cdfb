#include "coilwright/control/input_shaping.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace coilwright::control {

std::string_view name_of(Shaper shaper) {
  switch (shaper) {
    case Shaper::step:
      return "step";
    case Shaper::zero_vibration:
      return "zero_vibration";
    case Shaper::zero_vibration_derivative:
      return "zero_vibration_derivative";
  }
  return "";
}

CurrentProfile shaped_step(double from, double to, const simulation::Mode& mode, Shaper shaper) {
  if (!std::isfinite(from) || !std::isfinite(to))
    throw std::invalid_argument(fmt::format("currents must be finite; got {} and {} A", from, to));
  if (!(mode.natural_frequency > 0.0) || !(mode.damping_ratio > 0.0))
    throw std::invalid_argument(fmt::format("mode must have a frequency and a damping ratio > 0; got {} Hz and {}",
                                            mode.natural_frequency, mode.damping_ratio));
  if (shaper == Shaper::step || mode.damping_ratio >= 1.0) return {.before = from, .times = {0.0}, .levels = {to}};
  const double root = std::sqrt(1.0 - mode.damping_ratio * mode.damping_ratio);
  const double half_period = 0.5 / (mode.natural_frequency * root);
  const double rest = std::exp(-std::numbers::pi * mode.damping_ratio / root);  // of a vibration, half a period later
  const double change = to - from;
  if (shaper == Shaper::zero_vibration)
    return {.before = from, .times = {0.0, half_period}, .levels = {from + change / (1.0 + rest), to}};
  const double whole = (1.0 + rest) * (1.0 + rest);
  return {.before = from,
          .times = {0.0, half_period, 2.0 * half_period},
          .levels = {from + change / whole, from + change * (1.0 + 2.0 * rest) / whole, to}};
}

}  // namespace coilwright::control
