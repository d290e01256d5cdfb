#pragma once

#include <optional>

#include "coilwright/systems/crawl.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::systems {

/// The load that the robot bears with one film.
struct Bearing {
  double for_good{};              ///< A rms in every coil at which neither coil nor magnet passes its limit
  std::optional<double> until{};  ///< s from a cold start to that limit at the rms current; absent: never
};

/// Heat of the coils while the robot crawls, computed for a robot that lies straight, where coils and magnets are
/// nearest to each other.
struct CrawlHeat {
  double rms_current{};  ///< A, of a coil, cold
  Bearing taken{};       ///< by the film of the design
  Bearing still_air{};
};

/// Current of a coil with the same heat as the pulses of `crawl`, A rms.
[[nodiscard]] double rms_current(const Crawler& crawler, const Crawl& crawl);

/// The current limits of an actuator that lies straight, by the film of its design.
[[nodiscard]] thermal::CurrentLimits lying_limits(const actuator::Design& design, const actuator::Assembly& assembly);

/// The heat of the robot of `design` whose motion is `crawl`.
[[nodiscard]] CrawlHeat heat_of_crawl(const actuator::Design& design, const actuator::Assembly& assembly,
                                      const Crawler& crawler, const Crawl& crawl);

}  // namespace coilwright::systems
