#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/recorded_motion.hpp"

namespace coilwright::report {

/// A simulated motion and its inputs.
struct SimulatedMotion {
  const actuator::Model& model;
  const simulation::ModelInput& input;
  const simulation::RecordedMotion& motion;
  std::string table{};  ///< table whose samples show the motion, for people; empty: none
  std::string cure{};   ///< the option or argument that shows the motion between them
  /// The largest current in every coil that the actuator's own supply drives, with coils at 20 degC, A; absent if it is
  /// not known.
  std::optional<double> supply_drives{};
};

/// Remarks on a motion that its table does not show, a sentence each: samples that are far apart, a current that the
/// supply does not drive, faces that are pressed, a nameless correction used beyond its range. Empty if there are none.
[[nodiscard]] std::vector<std::string> motion_remarks(const SimulatedMotion& motion);

}  // namespace coilwright::report
