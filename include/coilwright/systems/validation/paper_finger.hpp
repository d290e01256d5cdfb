#pragma once

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/design/design.hpp"

namespace coilwright::systems::validation {

/// The prototype soft finger of the Mag-Nets paper by its geometry alone, with nothing measured: Tables I and II, and
/// the paper's own conventions of modelling (paper_shells, line_of_centres, points on the axis, no contact in its
/// range).
[[nodiscard]] actuator::Design paper_finger_geometry();

/// The paper's measurements of it: Table II, and the continuous current of its section VI.
[[nodiscard]] actuator::Measured paper_finger_measured();

/// The prototype with its measured values as calibration: configs/actuators/paper_finger.json.
[[nodiscard]] actuator::Design paper_finger();

}  // namespace coilwright::systems::validation
