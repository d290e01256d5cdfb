#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "truth/laboratory/programmes.hpp"
#include "truth/laboratory/request.hpp"

namespace truth::laboratory {

/// The word of `input_hold` that is true of a run's recorded input.
[[nodiscard]] std::string_view hold_of(const Request& request, const PlannedRun& run);

/// The object of the key `rig`; empty where nothing was changed.
[[nodiscard]] nlohmann::ordered_json rig_of(const Rig& rig);

/// The standard deviation of the clocks' offset that somebody would state, s.
[[nodiscard]] double stated_offset(const ClockFaults& clocks);

}  // namespace truth::laboratory
