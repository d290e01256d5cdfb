#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "measurement/replay/prepared_run.hpp"

// Records in which something on the rig seems to have been off. A fit would explain them by effects that are not there.
namespace coilwright::measurement::records {

/// Says of the first run that starts at rest far from where the declared model rests (by more than half of what
/// angle_offset may move an angle) that its angle may be counted from another zero: asked before anything is fitted, as
/// effects that bend the rest pose would take its place. Nothing where none does, where the pose differs by less than a
/// quarter of the bend that a current should hold (a stiffness may be off), and where another run begins as straight as
/// it should by the same channel: all have one zero.
[[nodiscard]] std::optional<data::Warning> initial_pose_mismatch(std::span<const replay::PreparedRun> runs,
                                                                 const replay::DeclaredModel& declared);

/// Says of a motion in which the camera or the tracker stops: its longest stretch of at least ten samples of one
/// channel that are exactly alike, where the noise of its other samples, of at least three times its resolution, would
/// show. Such a stretch looks like a finger that sticks. Nothing where there is none, and at the extremes of a channel:
/// there a sensor saturates, of which data::data_quality_warnings says more.
[[nodiscard]] std::optional<data::Warning> stalled_frames(const data::Run& run);

/// The motions from rest in which an angle hardly moves (a twentieth of what the declared model, as it is, moves it by,
/// both between the tenth and the ninetieth of a hundred readings in order) although the model moves it by a degree or
/// more: as of a coil without current. And those in which an angle has moved and then stays at its pose without current
/// (within a tenth of the largest bend) while the model is bent by half of that in a tenth of the samples or more. A
/// warning each, for the first angle of a run of which that is so. Long records are judged by their first window.
[[nodiscard]] std::vector<data::Warning> unanswered_runs(std::span<const data::Run> runs,
                                                         const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement::records
