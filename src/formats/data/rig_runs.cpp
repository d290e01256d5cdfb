#include "coilwright/formats/data/rig_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace measurement;
using namespace systems::rig;

data::Channel channel(const char* name, data::ChannelKind kind) {
  return {.name = name, .kind = kind};
}

}  // namespace

data::Run run_of(const std::vector<TorqueBenchPoint>& points, const TorqueBench& bench, magnetics::Fidelity fidelity) {
  data::Run run{.name = "torque_bench.csv", .kind = data::RunKind::static_torque};
  run.channels = {channel("torque_Nmm", data::ChannelKind::torque)};
  for (const TorqueBenchPoint& point : points) {
    run.angles.push_back(point.angle);
    run.inputs.push_back({bench.current});
    run.channels[0].values.push_back(point.reading.of(fidelity).torque);
  }
  return run;
}

data::Run run_of(const StiffnessReadings& readings) {
  data::Run run{.name = "stiffness_gauge.csv", .kind = data::RunKind::joint_stiffness};
  run.channels = {channel("torque_Nmm", data::ChannelKind::torque)};
  for (const StiffnessPoint& point : readings.points) {
    // A diagnosis takes such a run for the first joint's.
    if (std::abs(point.hinge_torque - point.first_hinge_torque) > 1e-9 * std::abs(point.first_hinge_torque))
      throw std::invalid_argument(fmt::format(
          "joint {} asks for {:.6g} Nmm at {:.6g} deg and joint 1 for {:.6g} Nmm; a joint_stiffness run is "
          "joint 1's: give --joint 1",
          readings.joint + 1, units::from_memory(point.hinge_torque, "torque_Nmm"),
          units::from_memory(point.angle, "angle_deg"), units::from_memory(point.first_hinge_torque, "torque_Nmm")));
    run.angles.push_back(point.angle);
    run.channels[0].values.push_back(point.hinge_torque);
  }
  return run;
}

data::Run run_of(const std::vector<GraspBenchPoint>& points, const GraspBench& bench, magnetics::Fidelity fidelity) {
  data::Run run{.name = "grasp_bench.csv", .kind = data::RunKind::blocked_force};
  run.channels = {channel("force_N", data::ChannelKind::force)};
  for (const GraspBenchPoint& point : points) {
    run.inputs.push_back({point.current});
    if (bench.grasp.opening != 0.0) run.openings.push_back(bench.grasp.opening);
    if (bench.grasp.height) run.heights.push_back(*bench.grasp.height);
    run.channels[0].values.push_back(point.force.of(fidelity));
  }
  return run;
}

data::Run run_of(const CameraRecord& record, magnetics::Fidelity fidelity, double sigma) {
  data::Run run{.name = record.name() + ".csv",
                .kind = data::RunKind::transient,
                .drive = data::Drive::current,
                .start = data::Start::at_rest,
                .sigma = sigma};
  run.times = record.times;
  for (const double current : record.currents) run.inputs.push_back({current});
  run.channels = {channel("bending_angle_deg", data::ChannelKind::bending_angle)};
  run.channels[0].values = record.bending.of(fidelity);
  return run;
}

}  // namespace coilwright::formats
