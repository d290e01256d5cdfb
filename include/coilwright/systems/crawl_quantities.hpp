#pragma once

#include <functional>
#include <vector>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/systems/crawl.hpp"

namespace coilwright::systems {

/// What a crawling robot has beside its actuator, and how it is followed.
struct CrawlTask {
  CrawlerParts parts{};
  CrawlTiming timing{.step = 1e-4};
};

/// What a robot of the design does on the ground, for studies: objectives, limits, expressions and columns. `task`
/// gives the task of one design, whose settings may vary; it must be pure. The robot crawls only where one of these is
/// asked for, and once for all of them. Its cell drives the current: that of the operating point is not read.
///
/// A design whose pulses ask more of the cell than it delivers does not crawl, and says by how much.
[[nodiscard]] std::vector<simulation::ResultQuantity> crawl_quantities(
    const std::function<CrawlTask(const simulation::Settings&)>& task);

}  // namespace coilwright::systems
