#pragma once

#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// A calibration factor (measured over derived) that is so far from 1 that the measured value may belong to another
/// actuator.
struct CalibrationDoubt {
  std::string_view quantity;  ///< "joint stiffness"
  double factor{};
};

/// Returns the factors that differ from 1 by a ratio of more than 1.25 either way, except that of the heat transfer,
/// which no formula derives. The prototype's factors lie between 1.0 and 1.05; slits cut by hand and silicones may
/// differ by more. The factor of the damping compares the whole damping, the silicone's part and the constant.
/// Precondition: the design can be built.
[[nodiscard]] std::vector<CalibrationDoubt> calibration_doubts(const Design& design);

}  // namespace coilwright::actuator
