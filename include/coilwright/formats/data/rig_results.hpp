#pragma once

#include <vector>

#include "coilwright/measurement/data/run.hpp"
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

/// What a rig is predicted to read, as the run that its record would be: `static_torque` under torque_bench.csv,
/// `joint_stiffness`, `blocked_force`, `transient`. Without noise, and without a sigma but for a transient's. A run
/// that is written and read back is what a diagnosis of the actuator predicts, where `fidelity` is the actuator's own.
[[nodiscard]] measurement::data::Run run_of(const std::vector<systems::rig::TorqueBenchPoint>& points,
                                            const systems::rig::TorqueBench& bench, magnetics::Fidelity fidelity);

/// The torques of the hinge alone: weight and magnets, which are in the gauge's force, are no part of such a run.
/// Throws std::invalid_argument where the joint is not the first and differs from that, because the run is the first's.
[[nodiscard]] measurement::data::Run run_of(const systems::rig::StiffnessReadings& readings);

[[nodiscard]] measurement::data::Run run_of(const std::vector<systems::rig::GraspBenchPoint>& points,
                                            const systems::rig::GraspBench& bench, magnetics::Fidelity fidelity);

/// `sigma` is what the set says of the camera's noise, rad; > 0.
[[nodiscard]] measurement::data::Run run_of(const systems::rig::CameraRecord& record, magnetics::Fidelity fidelity,
                                            double sigma);

}  // namespace coilwright::formats
