#pragma once

#include <optional>
#include <span>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement {

/// Says of the first run that starts at rest far from where the declared model rests (by more than half of what
/// angle_offset may move an angle) that its angle may be counted from another zero: asked before anything is fitted, as
/// effects that bend the rest pose would take its place. Nothing where none does, where the pose differs by less than a
/// quarter of the bend that a current should hold (a stiffness may be off), and where another run begins as straight as
/// it should by the same channel: all have one zero.
[[nodiscard]] std::optional<data::Warning> far_first_pose(std::span<const replay::PreparedRun> runs,
                                                          const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement
