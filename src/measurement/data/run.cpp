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
    case RunKind::still:
      return "still";
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

std::string_view name_of(InputHold hold) {
  switch (hold) {
    case InputHold::zero_order:
      return "zero_order";
    case InputHold::linear:
      return "linear";
    case InputHold::unknown_within_sample:
      return "unknown_within_sample";
  }
  return "";
}

std::string_view name_of(CoilWiring wiring) {
  switch (wiring) {
    case CoilWiring::driven:
      return "driven";
    case CoilWiring::open:
      return "open";
    case CoilWiring::shorted:
      return "shorted";
  }
  return "";
}

simulation::CommandedInput Run::command() const {
  const bool common = inputs.empty() || inputs.front().size() == 1;
  return {.drive = drive,
          .addressing = common ? simulation::Addressing::common : simulation::Addressing::each,
          .times = times_of_inputs(),
          .rows = inputs};
}

}  // namespace coilwright::measurement::data
