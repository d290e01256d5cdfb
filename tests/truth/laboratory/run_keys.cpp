#include "truth/laboratory/run_keys.hpp"

#include <cmath>
#include <numbers>

namespace truth::laboratory {

using Json = nlohmann::ordered_json;

// A record of every change is what the driver holds; samples miss what is between them.
std::string_view hold_of(const Request& request, const PlannedRun& run) {
  const bool sees_all = request.clocks.log == InputLog::every_change ||
                        (request.clocks.log == InputLog::beside_pictures && request.camera.frame_rate == 500.0);
  if (sees_all) return "zero_order";
  return run.wave ? "linear" : "unknown_within_sample";
}

Json rig_of(const Rig& rig) {
  Json out = Json::object();
  if (rig.base_turn != 0.0) out["base_turn_deg"] = std::round(rig.base_turn * 180.0 / std::numbers::pi * 1e6) / 1e6;
  if (rig.tip_mass != 0.0) out["tip_mass_g"] = rig.tip_mass * 1e3;
  if (rig.coil != CoilState::driven) out["coil"] = rig.coil == CoilState::open ? "open" : "shorted";
  return out;
}

double stated_offset(const ClockFaults& clocks) {
  return 0.5 * (clocks.smallest_offset + clocks.largest_offset);
}

}  // namespace truth::laboratory
