#pragma once

#include <fmt/format.h>

#include "coilwright/systems/driven_motion.hpp"
#include "systems/check.hpp"

namespace coilwright::systems {

/// Throws std::invalid_argument unless duration and interval keep their rules.
inline void require_timing(const MotionTiming& timing) {
  require(timing.duration > 0.0, "duration", "> 0", timing.duration, "s");
  require(timing.interval > 0.0 && timing.interval <= timing.duration, "interval",
          fmt::format("> 0 and at most the duration, {:.6g} s", timing.duration), timing.interval, "s");
}

/// Throws std::invalid_argument where there would be more than so many samples.
inline void require_samples(const MotionTiming& timing, double most) {
  require(timing.duration / timing.interval <= most, "interval",
          fmt::format("at least {:.6g} s, for {:.0f} samples", timing.duration / most, most), timing.interval, "s");
}

}  // namespace coilwright::systems
