#pragma once

#include <functional>
#include <vector>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/systems/crawl.hpp"

namespace coilwright::systems {

/// The parts of a crawling robot beside its actuator, and the timing of its motion.
struct CrawlTask {
  CrawlerParts parts{};
  CrawlTiming timing{.step = 1e-4};
};

/// The quantities of a crawling robot of the design, for studies: objectives, limits, expressions and columns. `task`
/// gives the task of one design, whose settings may vary; it must be pure. The robot is simulated only if one of these
/// is requested, and once for all of them. Its cell drives the current; that of the operating point is not used.
///
/// A design whose pulses need more current than the cell delivers does not crawl, and the reason says by how much.
[[nodiscard]] std::vector<simulation::ResultQuantity> crawl_quantities(
    const std::function<CrawlTask(const simulation::Settings&)>& task);

}  // namespace coilwright::systems
