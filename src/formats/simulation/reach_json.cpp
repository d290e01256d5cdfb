#include "coilwright/formats/simulation/reach_json.hpp"

#include <utility>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using text::Json;

Json arrival_of(const control::Arrival& arrival) {
  return Json::object({{"settling_time_s", arrival.settling_time ? Json(*arrival.settling_time) : Json(nullptr)},
                       {"overshoot_percent", 100.0 * arrival.overshoot},
                       {"peak_speed_deg_s", units::from_memory(arrival.peak_speed, "peak_speed_deg_s")},
                       {"end_deg", units::from_memory(arrival.end, "end_deg")}});
}

}  // namespace

Json to_json(const control::Reach& reach) {
  Json profiles = Json::array();
  for (const control::ProfileQuality& each : reach.profiles)
    profiles.add(Json::object({{"name", each.name},
                               {"time_s", Json::numbers(each.profile.times)},
                               {"current_A", Json::numbers(each.profile.levels)},
                               {"nominal", arrival_of(each.nominal)},
                               {"worst", arrival_of(each.worst)}}));
  return Json::object({{"format", "reach/1"},
                       {"start_deg", units::from_memory(reach.profiles.front().nominal.start, "start_deg")},
                       {"end_deg", units::from_memory(reach.profiles.front().nominal.end, "end_deg")},
                       {"start_current_A", reach.profiles.front().profile.before},
                       {"holding_current_A", reach.current},
                       {"natural_frequency_Hz", reach.mode.natural_frequency},
                       {"damping_ratio", reach.mode.damping_ratio},
                       {"least_end_deg", units::from_memory(reach.least_end, "least_end_deg")},
                       {"greatest_end_deg", units::from_memory(reach.greatest_end, "greatest_end_deg")},
                       {"profiles", std::move(profiles)}});
}

}  // namespace coilwright::formats
