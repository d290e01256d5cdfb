#pragma once

#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// A factor, measured over derived, that says that the measured value may be of another actuator than the dimensions.
struct CalibrationDoubt {
  std::string_view quantity;  ///< "joint stiffness"
  double factor{};
};

/// Factors beyond a ratio of 1.25 either way; that of the heat transfer, which nothing derives, is not among them. The
/// prototype's lie between 1.0 and 1.05; slits cut by hand and silicones may differ by more, and it is worth a look.
/// That of the damping is of all of it, the silicone's and the rest. The design is one that can be built.
[[nodiscard]] std::vector<CalibrationDoubt> calibration_doubts(const Design& design);

}  // namespace coilwright::actuator
