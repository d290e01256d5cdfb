#include "coilwright/actuator/design/current_limit.hpp"

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/winding/wire.hpp"

namespace coilwright::actuator {

double current_limit(const Design& design) {
  const winding::Wire wire = wire_of(design.coil);
  return design.choices.ampacity == AmpacityChoice::table ? wire.chassis_ampacity : wire.smooth_ampacity;
}

double operating_current_limit(const Design& design) {
  return current_limit(design) / largest_current_share(design);
}

}  // namespace coilwright::actuator
