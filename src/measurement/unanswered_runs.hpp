#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement {

/// The motions from rest in which an angle hardly moves (a twentieth of what the declared model, as it is, moves it by,
/// both between the tenth and the ninetieth of a hundred readings in order) although the model moves it by a degree or
/// more: as of a coil without current. A warning each, for the first angle of a run of which that is so. Long records
/// are judged by their first window.
[[nodiscard]] std::vector<data::Warning> unanswered_runs(std::span<const data::Run> runs,
                                                         const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement
