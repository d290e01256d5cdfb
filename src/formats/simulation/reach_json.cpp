#include "coilwright/formats/simulation/reach_json.hpp"

#include <utility>

namespace coilwright::formats {
namespace {

using text::Json;

Json arrival_of(const control::Arrival& arrival) {
  return Json::object({{"settling_time_s", arrival.settling_time},
                       {"overshoot_percent", 100.0 * arrival.overshoot},
                       Json::quantity("peak_speed_deg_s", arrival.peak_speed),
                       Json::quantity("end_deg", arrival.end)});
}

}  // namespace

Json to_json(const control::Reach& reach) {
  Json profiles = Json::list(reach.profiles, [](const control::ProfileQuality& each) {
    return Json::object({{"name", each.name},
                         {"time_s", Json::numbers(each.profile.times)},
                         {"current_A", Json::numbers(each.profile.levels)},
                         {"nominal", arrival_of(each.nominal)},
                         {"worst", arrival_of(each.worst)}});
  });
  return Json::object({{"format", "reach/1"},
                       Json::quantity("start_deg", reach.profiles.front().nominal.start),
                       Json::quantity("end_deg", reach.profiles.front().nominal.end),
                       {"start_current_A", reach.profiles.front().profile.before},
                       {"holding_current_A", reach.current},
                       {"natural_frequency_Hz", reach.mode.natural_frequency},
                       {"damping_ratio", reach.mode.damping_ratio},
                       Json::quantity("least_end_deg", reach.least_end),
                       Json::quantity("greatest_end_deg", reach.greatest_end),
                       {"profiles", std::move(profiles)}});
}

}  // namespace coilwright::formats
