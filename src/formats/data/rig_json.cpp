#include "coilwright/formats/data/rig_json.hpp"

#include <string>
#include <utility>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace systems::rig;
using text::Json;

// An SI value under a key that ends in its unit.
Json::Member reading_member(const char* key, double value) {
  return {key, units::from_memory(value, key)};
}

// Adds both fidelities to an object, each as `json` of it.
template <class Callable>
void set_both(Json& out, const Callable& json) {
  out.set("line_of_centres", json(magnetics::Fidelity::line_of_centres));
  out.set("exact", json(magnetics::Fidelity::exact));
}

Json to_json(const StiffnessReading& reading) {
  return Json::object(
      {reading_member("gauge_force_N", reading.force), reading_member("stiffness_Nmm_rad", reading.stiffness)});
}

Json to_json(const StiffnessSpread& spread) {
  return Json::object({reading_member("mean_stiffness_Nmm_rad", spread.mean),
                       reading_member("stiffness_deviation_Nmm_rad", spread.deviation)});
}

Json to_json(const ResponseFigures& shown) {
  return Json::object({reading_member("first_angle_deg", shown.first), reading_member("last_angle_deg", shown.last),
                       reading_member("largest_angle_deg", shown.largest),
                       reading_member("fastest_rise_deg_s", shown.fastest),
                       reading_member("late_mean_angle_deg", shown.late_mean),
                       reading_member("late_peak_to_peak_deg", shown.peak_to_peak)});
}

}  // namespace

Json to_json(const std::vector<TorqueBenchPoint>& points, const TorqueBench& bench) {
  Json list = Json::array();
  for (const TorqueBenchPoint& point : points) {
    Json entry = Json::object({reading_member("angle_deg", point.angle)});
    set_both(entry, [&](magnetics::Fidelity fidelity) {
      const TorqueReading& reading = point.reading.of(fidelity);
      return Json::object(
          {reading_member("torque_Nmm", reading.torque), reading_member("gauge_force_N", reading.gauge_force)});
    });
    entry.set("error_of_line_of_centres_pct", 100.0 * point.error_of_line_of_centres());
    list.add(std::move(entry));
  }
  return Json::object({{"rig", "torque-bench"},
                       reading_member("axis_offset_mm", bench.axis_offset),
                       reading_member("gauge_distance_mm", bench.gauge_distance),
                       reading_member("current_A", bench.current),
                       {"readings", std::move(list)},
                       reading_member("mean_difference_Nmm", mean_difference(points))});
}

Json to_json(const StiffnessReadings& readings) {
  Json list = Json::array();
  for (const StiffnessPoint& point : readings.points) {
    Json entry = Json::object(
        {reading_member("angle_deg", point.angle), reading_member("hinge_torque_Nmm", point.hinge_torque)});
    set_both(entry, [&](magnetics::Fidelity fidelity) {
      return Json::object(
          {{"level", to_json(point.level.of(fidelity))}, {"hanging", to_json(point.hanging.of(fidelity))}});
    });
    list.add(std::move(entry));
  }
  Json out = Json::object({{"rig", "stiffness-gauge"},
                           {"joint", readings.joint + 1},
                           reading_member("gauge_arm_mm", readings.arm),
                           {"readings", std::move(list)}});
  set_both(out, [&](magnetics::Fidelity fidelity) {
    return Json::object({{"level", to_json(spread(readings, &StiffnessPoint::level, fidelity))},
                         {"hanging", to_json(spread(readings, &StiffnessPoint::hanging, fidelity))}});
  });
  return out;
}

Json to_json(const std::vector<GraspBenchPoint>& points, const GraspBench& bench) {
  Json list = Json::array();
  for (const GraspBenchPoint& point : points) {
    Json entry = Json::object({reading_member("current_A", point.current)});
    set_both(entry, [&](magnetics::Fidelity fidelity) {
      return Json::object({reading_member("force_N", point.force.of(fidelity)),
                           reading_member("bending_angle_deg", point.bending.of(fidelity))});
    });
    list.add(std::move(entry));
  }
  Json out = Json::object({{"rig", "grasp-bench"}, reading_member("grasp_opening_deg", bench.grasp.opening)});
  if (bench.grasp.height) out.set("grasp_height_mm", units::from_memory(*bench.grasp.height, "grasp_height_mm"));
  out.set("readings", std::move(list));
  return out;
}

Json to_json(const std::vector<CameraRecord>& records, const Camera& camera) {
  Json list = Json::array();
  for (const CameraRecord& record : records) {
    const bool step = record.input == CameraInput::step;
    Json entry = Json::object({{"file", record.name() + ".csv"}, {"input", step ? "step" : "sine"}});
    entry.set(step ? "current_A" : "frequency_Hz", record.level);
    set_both(entry, [&](magnetics::Fidelity fidelity) { return to_json(figures(record, fidelity)); });
    entry.set("mean_difference_deg", units::from_memory(mean_difference(record), "mean_difference_deg"));
    list.add(std::move(entry));
  }
  return Json::object({{"rig", "camera"},
                       reading_member("frame_rate_Hz", camera.frame_rate),
                       reading_member("amplitude_A", camera.amplitude),
                       reading_member("offset_A", camera.offset),
                       {"records", std::move(list)}});
}

}  // namespace coilwright::formats
