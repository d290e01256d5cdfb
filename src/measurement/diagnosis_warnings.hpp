#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement {

/// What a reader of a finished diagnosis should know in addition, because its verdict rests on the fit runs and on
/// whiteness alone.
[[nodiscard]] std::vector<data::Warning> warnings_of(const Diagnosis& diagnosis,
                                                     std::span<const replay::PreparedRun> runs,
                                                     const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement
