#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"
#include "measurement/fit/fit.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement {

/// Of three runs or more, the one in which nine tenths and more of the fall of the sum of squares are, from the model
/// `without` effects to that `with` them, both fitted to `runs`: a run whose input was written wrongly makes an effect
/// like that. Nothing where two runs speak for the effects.
[[nodiscard]] std::optional<data::Warning> support_in_one_run(std::span<const replay::PreparedRun> runs,
                                                              const fit::Fit& without, const fit::Fit& with);

/// What a reader of a finished diagnosis should know in addition, because its verdict rests on the fit runs and on
/// whiteness alone.
[[nodiscard]] std::vector<data::Warning> warnings_of(const Diagnosis& diagnosis,
                                                     std::span<const replay::PreparedRun> runs,
                                                     const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement
