#pragma once

#include <string>
#include <vector>

#include "coilwright/systems/rig/camera.hpp"
#include "coilwright/systems/rig/grasp_bench.hpp"
#include "coilwright/systems/rig/stiffness_gauge.hpp"
#include "coilwright/systems/rig/torque_bench.hpp"

namespace coilwright::report {

/// A rig's readings by both fidelities as a table, with remarks for a comparison with measured ones.
[[nodiscard]] std::string to_text(const std::vector<systems::rig::TorqueBenchPoint>& points,
                                  const systems::rig::TorqueBench& bench);
[[nodiscard]] std::string to_text(const systems::rig::StiffnessReadings& readings);
[[nodiscard]] std::string to_text(const std::vector<systems::rig::GraspBenchPoint>& points,
                                  const systems::rig::GraspBench& bench);
[[nodiscard]] std::string to_text(const std::vector<systems::rig::CameraRecord>& records,
                                  const systems::rig::Camera& camera);

}  // namespace coilwright::report
