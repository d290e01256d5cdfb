#pragma once

#include <optional>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "measurement/fit/hypothesis.hpp"

namespace coilwright::measurement {

/// Whether a channel is of a bending or a joint angle.
[[nodiscard]] bool is_angle(const data::Channel& channel);

/// Whether a run is a motion from rest that has an angle.
[[nodiscard]] bool is_motion_of_angles(const data::Run& run);

/// An angle in the first window of a motion from rest, as it was read and as the declared model shows it, in rad.
struct DeclaredAngle {
  const data::Channel* channel{};  ///< of the run that was asked about
  std::vector<double> measured{};
  std::vector<double> declared{};  ///< one value for each reading
};

/// Every angle of `run`; nothing where the model cannot follow the input. `as_declared` has no effect beside those that
/// the model declares. Throws std::invalid_argument where the run does not fit the model.
[[nodiscard]] std::optional<std::vector<DeclaredAngle>> declared_angles(const data::Run& run,
                                                                        const replay::DeclaredModel& declared,
                                                                        const fit::Hypothesis& as_declared);

}  // namespace coilwright::measurement
