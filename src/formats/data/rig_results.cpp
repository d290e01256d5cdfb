#include "coilwright/formats/data/rig_results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace systems::rig;
using namespace measurement;
using text::Json;

// Adds both fidelities to an object, each as `json` of it.
template <class Callable>
void set_both(Json& out, const Callable& json) {
  out.set("line_of_centres", json(magnetics::Fidelity::line_of_centres));
  out.set("exact", json(magnetics::Fidelity::exact));
}

Json to_json(const StiffnessReading& reading) {
  return Json::object(
      {Json::quantity("gauge_force_N", reading.force), Json::quantity("stiffness_Nmm_rad", reading.stiffness)});
}

Json to_json(const StiffnessSpread& spread) {
  return Json::object({Json::quantity("mean_stiffness_Nmm_rad", spread.mean),
                       Json::quantity("stiffness_deviation_Nmm_rad", spread.deviation)});
}

Json to_json(const ResponseFigures& shown) {
  return Json::object({Json::quantity("first_angle_deg", shown.first), Json::quantity("last_angle_deg", shown.last),
                       Json::quantity("largest_angle_deg", shown.largest),
                       Json::quantity("fastest_rise_deg_s", shown.fastest),
                       Json::quantity("late_mean_angle_deg", shown.late_mean),
                       Json::quantity("late_peak_to_peak_deg", shown.peak_to_peak)});
}

}  // namespace

Json to_json(const std::vector<TorqueBenchPoint>& points, const TorqueBench& bench) {
  Json list = Json::list(points, [](const TorqueBenchPoint& point) {
    Json entry = Json::object({Json::quantity("angle_deg", point.angle)});
    set_both(entry, [&](magnetics::Fidelity fidelity) {
      const TorqueReading& reading = point.reading.of(fidelity);
      return Json::object(
          {Json::quantity("torque_Nmm", reading.torque), Json::quantity("gauge_force_N", reading.gauge_force)});
    });
    entry.set("error_of_line_of_centres_pct", 100.0 * point.error_of_line_of_centres());
    return entry;
  });
  return Json::object({{"rig", "torque-bench"},
                       Json::quantity("axis_offset_mm", bench.axis_offset),
                       Json::quantity("gauge_distance_mm", bench.gauge_distance),
                       Json::quantity("current_A", bench.current),
                       {"readings", std::move(list)},
                       Json::quantity("mean_difference_Nmm", mean_difference(points))});
}

Json to_json(const StiffnessReadings& readings) {
  Json list = Json::list(readings.points, [](const StiffnessPoint& point) {
    Json entry = Json::object(
        {Json::quantity("angle_deg", point.angle), Json::quantity("hinge_torque_Nmm", point.hinge_torque)});
    set_both(entry, [&](magnetics::Fidelity fidelity) {
      return Json::object(
          {{"level", to_json(point.level.of(fidelity))}, {"hanging", to_json(point.hanging.of(fidelity))}});
    });
    return entry;
  });
  Json out = Json::object({{"rig", "stiffness-gauge"},
                           {"joint", readings.joint + 1},
                           Json::quantity("gauge_arm_mm", readings.arm),
                           {"readings", std::move(list)}});
  set_both(out, [&](magnetics::Fidelity fidelity) {
    return Json::object({{"level", to_json(spread(readings, &StiffnessPoint::level, fidelity))},
                         {"hanging", to_json(spread(readings, &StiffnessPoint::hanging, fidelity))}});
  });
  return out;
}

Json to_json(const std::vector<GraspBenchPoint>& points, const GraspBench& bench) {
  Json list = Json::list(points, [](const GraspBenchPoint& point) {
    Json entry = Json::object({Json::quantity("current_A", point.current)});
    set_both(entry, [&](magnetics::Fidelity fidelity) {
      return Json::object({Json::quantity("force_N", point.force.of(fidelity)),
                           Json::quantity("bending_angle_deg", point.bending.of(fidelity))});
    });
    return entry;
  });
  Json out = Json::object({{"rig", "grasp-bench"}, Json::quantity("grasp_opening_deg", bench.grasp.opening)});
  if (bench.grasp.height) out.set(Json::quantity("grasp_height_mm", *bench.grasp.height));
  out.set("readings", std::move(list));
  return out;
}

Json to_json(const std::vector<CameraRecord>& records, const Camera& camera) {
  Json list = Json::list(records, [](const CameraRecord& record) {
    const bool step = record.input == CameraInput::step;
    Json entry = Json::object({{"file", record.name() + ".csv"}, {"input", step ? "step" : "sine"}});
    entry.set(step ? "current_A" : "frequency_Hz", record.level);
    set_both(entry, [&](magnetics::Fidelity fidelity) { return to_json(figures(record, fidelity)); });
    entry.set(Json::quantity("mean_difference_deg", mean_difference(record)));
    return entry;
  });
  return Json::object({{"rig", "camera"},
                       Json::quantity("frame_rate_Hz", camera.frame_rate),
                       Json::quantity("amplitude_A", camera.amplitude),
                       Json::quantity("offset_A", camera.offset),
                       {"records", std::move(list)}});
}

data::Run run_of(const std::vector<TorqueBenchPoint>& points, const TorqueBench& bench, magnetics::Fidelity fidelity) {
  data::Run run{.name = "torque_bench.csv", .kind = data::RunKind::static_torque};
  run.channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque}};
  for (const TorqueBenchPoint& point : points) {
    run.angles.push_back(point.angle);
    run.inputs.push_back({bench.current});
    run.channels[0].values.push_back(point.reading.of(fidelity).torque);
  }
  return run;
}

data::Run run_of(const StiffnessReadings& readings) {
  data::Run run{.name = "stiffness_gauge.csv", .kind = data::RunKind::joint_stiffness};
  run.channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque}};
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
  run.channels = {{.name = "force_N", .kind = data::ChannelKind::force}};
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
  run.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}};
  run.channels[0].values = record.bending.of(fidelity);
  return run;
}

}  // namespace coilwright::formats
