#pragma once

#include <optional>
#include <span>

#include "coilwright/measurement/planning/next_experiment.hpp"
#include "measurement/identification/attribution.hpp"

namespace coilwright::measurement::planning {

/// Of the candidate experiments the one that is expected to leave least open which is true, the reported hypothesis or
/// one of its rivals (log_remaining_bits()), each with what the records leave open of its numbers.
/// Nothing if there are no rivals, or no candidate tells a tenth of what is open.
[[nodiscard]] std::optional<NextExperiment> informative_experiment(std::span<const replay::PreparedRun> runs,
                                                                   const identification::Attribution& attribution);

}  // namespace coilwright::measurement::planning
