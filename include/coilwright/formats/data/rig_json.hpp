#pragma once

#include <vector>

#include "coilwright/systems/rig/camera.hpp"
#include "coilwright/systems/rig/grasp_bench.hpp"
#include "coilwright/systems/rig/stiffness_gauge.hpp"
#include "coilwright/systems/rig/torque_bench.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A rig's settings and readings, by both fidelities, as `rig --json` prints them. Keys end in their unit.
[[nodiscard]] text::Json to_json(const std::vector<systems::rig::TorqueBenchPoint>& points,
                                 const systems::rig::TorqueBench& bench);
[[nodiscard]] text::Json to_json(const systems::rig::StiffnessReadings& readings);
[[nodiscard]] text::Json to_json(const std::vector<systems::rig::GraspBenchPoint>& points,
                                 const systems::rig::GraspBench& bench);
/// The camera's frames are left out; they are in the data set.
[[nodiscard]] text::Json to_json(const std::vector<systems::rig::CameraRecord>& records,
                                 const systems::rig::Camera& camera);

}  // namespace coilwright::formats
