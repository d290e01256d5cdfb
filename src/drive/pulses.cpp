#include "coilwright/drive/pulses.hpp"

#include <algorithm>

namespace coilwright::drive {

PhaseLengths phase_lengths(const Driver& driver, const Pulses& pulses) {
  const double period = 1.0 / pulses.frequency;
  if (pulses.duty == 1.0) return {.on = period};
  const double on = pulses.duty * period - driver.dead_time;
  if (pulses.duty == 0.0 || on <= 0.0) return {.off = period};
  const double off = std::max(0.0, (1.0 - pulses.duty) * period - driver.dead_time);
  const double dead = period - on - off;
  return {.on = on,
          .dead_before_off = std::min(dead, driver.dead_time),
          .off = off,
          .dead_before_on = dead - std::min(dead, driver.dead_time)};
}

}  // namespace coilwright::drive
