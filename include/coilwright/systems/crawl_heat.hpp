#pragma once

#include <optional>

#include "coilwright/systems/crawl.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::systems {

/// What a film lets the robot bear.
struct Bearing {
  double for_good{};              ///< A rms in every coil, while neither coil nor magnet passes its limit
  std::optional<double> until{};  ///< s from a cold start until one does at the rms current; nothing if none ever does
};

/// Heat of the coils while it crawls, as if it lay straight: there coils and magnets are nearest to each other.
struct CrawlHeat {
  double rms_current{};  ///< A, of a coil, cold
  Bearing taken{};       ///< by the film of the design
  Bearing still_air{};
};

/// Current of a coil whose heat is what the pulses of `crawl` make in the copper, A rms.
[[nodiscard]] double rms_current(const Crawler& crawler, const Crawl& crawl);

/// What limits the current of an actuator that lies straight, by the film of its design.
[[nodiscard]] thermal::CurrentLimits lying_limits(const actuator::Design& design, const actuator::Assembly& assembly);

/// Of the robot of `design` that crawls as `crawl` says.
[[nodiscard]] CrawlHeat heat_of_crawl(const actuator::Design& design, const actuator::Assembly& assembly,
                                      const Crawler& crawler, const Crawl& crawl);

}  // namespace coilwright::systems
