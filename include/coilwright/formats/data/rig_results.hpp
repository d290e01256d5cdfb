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
/// The same for the camera, without its frames, which are in the data set.
[[nodiscard]] text::Json to_json(const std::vector<systems::rig::CameraRecord>& records,
                                 const systems::rig::Camera& camera);

/// The predicted readings of a rig as a run of a data set: `static_torque` under torque_bench.csv, `joint_stiffness`,
/// `blocked_force`, `transient`. It has no noise, and only a transient has a sigma. If `fidelity` is the actuator's
/// own, a diagnosis of the actuator predicts this run exactly.
[[nodiscard]] measurement::data::Run run_of(const std::vector<systems::rig::TorqueBenchPoint>& points,
                                            const systems::rig::TorqueBench& bench, magnetics::Fidelity fidelity);

/// The torques of the hinge alone; weight and magnets, which are in the gauge's force, are left out. Throws
/// std::invalid_argument if the joint is not the first and differs from that, because the run is the first joint's.
[[nodiscard]] measurement::data::Run run_of(const systems::rig::StiffnessReadings& readings);

[[nodiscard]] measurement::data::Run run_of(const std::vector<systems::rig::GraspBenchPoint>& points,
                                            const systems::rig::GraspBench& bench, magnetics::Fidelity fidelity);

/// The bending angles of the camera. `sigma` is the standard deviation that the set states for the camera's noise, rad;
/// > 0.
[[nodiscard]] measurement::data::Run run_of(const systems::rig::CameraRecord& record, magnetics::Fidelity fidelity,
                                            double sigma);

}  // namespace coilwright::formats
