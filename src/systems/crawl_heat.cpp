#include "coilwright/systems/crawl_heat.hpp"

#include <cmath>

#include "coilwright/actuator/heat.hpp"
#include "coilwright/thermal/transient.hpp"

namespace coilwright::systems {
namespace {

Bearing bearing_of(const thermal::Network& network, double current) {
  Bearing out{.for_good = thermal::current_limits(network).for_good()};
  if (current <= out.for_good) return out;
  const auto reached = thermal::time_to_limit(network, {.holding_current = 0.0, .overload_current = current});
  if (reached) out.until = reached->time;
  return out;
}

}  // namespace

double rms_current(const Crawler& crawler, const Crawl& crawl) {
  return std::sqrt(crawl.powers.copper / (crawler.model().coils() * crawler.coil_resistance()));
}

thermal::CurrentLimits lying_limits(const actuator::Design& design, const actuator::Assembly& assembly) {
  return thermal::current_limits(actuator::heat_network(design, assembly, 0.0));
}

CrawlHeat heat_of_crawl(const actuator::Design& design, const actuator::Assembly& assembly, const Crawler& crawler,
                        const Crawl& crawl) {
  const mechanics::JointVector straight = mechanics::JointVector::Zero(assembly.model.joints());
  CrawlHeat out{.rms_current = rms_current(crawler, crawl)};
  out.taken = bearing_of(actuator::heat_network(design, assembly, straight), out.rms_current);
  out.still_air = bearing_of(actuator::still_air_network(design, assembly, straight), out.rms_current);
  return out;
}

}  // namespace coilwright::systems
