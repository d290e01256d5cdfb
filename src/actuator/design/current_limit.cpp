#include "coilwright/actuator/design/current_limit.hpp"

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/winding/wire_gauge.hpp"

namespace coilwright::actuator {

double current_limit(const Design& design) {
  const winding::WireGauge wire = winding::gauge(design.coil.wire_gauge);
  return design.choices.ampacity == AmpacityChoice::table ? wire.chassis_ampacity : wire.smooth_ampacity;
}

double operating_current_limit(const Design& design) {
  return current_limit(design) / largest_current_share(design);
}

}  // namespace coilwright::actuator
