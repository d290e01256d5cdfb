#pragma once

#include <optional>
#include <string>
#include <variant>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/model.hpp"
#include "coilwright/actuator/operating_point.hpp"

namespace coilwright::exports {

/// Where an export comes from, as the exported files say it.
struct Origin {
  std::string name;     ///< of the actuator, one line of UTF-8; may be empty
  std::string made_by;  ///< one line of UTF-8: program, version, input file and what was changed of it; may be empty
};

/// An actuator whose geometry is known.
struct DesignSubject {
  Origin origin;
  actuator::Design design;
  actuator::Assembly assembly;                                ///< of `design`
  std::optional<actuator::OperatingPoint> operating_point{};  ///< for which it was sized
};

/// An actuator of which only the model is known, or wanted.
struct ModelSubject {
  Origin origin;
  actuator::Model model;
};

/// What is exported: of a design (actuator/1) or of a lumped model (lumped-model/1).
using Subject = std::variant<DesignSubject, ModelSubject>;

}  // namespace coilwright::exports
