#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::data {

std::string_view name_of(RunKind kind) {
  switch (kind) {
    case RunKind::transient:
      return "transient";
    case RunKind::static_torque:
      return "static_torque";
    case RunKind::joint_stiffness:
      return "joint_stiffness";
    case RunKind::blocked_force:
      return "blocked_force";
    case RunKind::temperature:
      return "temperature";
  }
  return "";
}

std::string_view name_of(Drive drive) {
  switch (drive) {
    case Drive::current:
      return "current";
    case Drive::voltage:
      return "voltage";
    case Drive::torque:
      return "torque";
  }
  return "";
}

std::string_view name_of(Start start) {
  switch (start) {
    case Start::at_rest:
      return "at_rest";
    case Start::measured:
      return "measured";
    case Start::free:
      return "free";
  }
  return "";
}

}  // namespace coilwright::measurement::data
