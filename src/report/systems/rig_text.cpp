#include "coilwright/report/systems/rig_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "coilwright/report/simulation/text_table.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::report {
namespace {

using namespace systems::rig;
using magnetics::Fidelity;
using enum TextTable::Align;

// A value in the unit of `name` to five digits; a force or torque that only rounding keeps from 0 is 0.
std::string cell(double value, const char* name) {
  const double shown = units::from_memory(value, name);
  return fmt::format("{:.5g}", std::abs(shown) < 1e-9 ? 0.0 : shown);
}

std::string degrees(double angle) {
  return fmt::format("{:.2f}", units::from_memory(angle, "angle_deg"));
}

bool without_current_the_same(const StiffnessReadings& readings) {
  for (const StiffnessPoint& point : readings.points)
    if (std::abs(point.level.exact.force - point.level.line_of_centres.force) >
        1e-9 * std::abs(point.level.exact.force))
      return false;
  return true;
}

std::string stiffness_table(const StiffnessReadings& readings, Fidelity fidelity) {
  TextTable table;
  table.row({"", "level", "", "hanging", ""});
  table.row({"angle deg", "force N", "stiffness Nmm/rad", "force N", "stiffness Nmm/rad"});
  for (const StiffnessPoint& point : readings.points) {
    const StiffnessReading& level = point.level.of(fidelity);
    const StiffnessReading& hanging = point.hanging.of(fidelity);
    table.row({degrees(point.angle), cell(level.force, "force_N"), cell(level.stiffness, "stiffness_Nmm_rad"),
               cell(hanging.force, "force_N"), cell(hanging.stiffness, "stiffness_Nmm_rad")});
  }
  const StiffnessSpread level = spread(readings, &StiffnessPoint::level, fidelity);
  const StiffnessSpread hanging = spread(readings, &StiffnessPoint::hanging, fidelity);
  table.row({"mean", "", cell(level.mean, "stiffness_Nmm_rad"), "", cell(hanging.mean, "stiffness_Nmm_rad")});
  table.row(
      {"deviation", "", cell(level.deviation, "stiffness_Nmm_rad"), "", cell(hanging.deviation, "stiffness_Nmm_rad")});
  return table.text(2, {});
}

}  // namespace

std::string to_text(const std::vector<TorqueBenchPoint>& points, const TorqueBench& bench) {
  std::string out = fmt::format(
      "Torque bench: one joint's coil and magnet, hinge {} mm from the coil axis, {} A, gauge {} mm from the hinge\n",
      cell(bench.axis_offset, "offset_mm"), short_number(bench.current), cell(bench.gauge_distance, "distance_mm"));
  TextTable table;
  table.row({"", "exact", "", "line of centres", "", ""});
  table.row({"angle deg", "torque Nmm", "gauge N", "torque Nmm", "gauge N", "its error %"});
  for (const TorqueBenchPoint& point : points)
    table.row({degrees(point.angle), cell(point.reading.exact.torque, "torque_Nmm"),
               cell(point.reading.exact.gauge_force, "force_N"),
               cell(point.reading.line_of_centres.torque, "torque_Nmm"),
               cell(point.reading.line_of_centres.gauge_force, "force_N"),
               fmt::format("{:+.1f}", 100.0 * point.error_of_line_of_centres())});
  out += table.text(2, {});
  return out + fmt::format("The two differ by {} Nmm on average.\n", cell(mean_difference(points), "torque_Nmm")) +
         "No weight is in these readings: lay the bench flat, or balance the gauge at each angle without current.\n";
}

std::string to_text(const StiffnessReadings& readings) {
  std::string out = fmt::format(
      "Stiffness gauge: no current, joint {} held open and all others straight, gauge square on the last segment, {} "
      "mm from the joint\n",
      readings.joint + 1, cell(readings.arm, "arm_mm"));
  if (without_current_the_same(readings)) {
    out += stiffness_table(readings, Fidelity::exact);
    out += "Both force fidelities read this: there is no current, and no two magnets act on each other.\n";
  } else {
    out += "Magnets of the actuator act on each other, by the exact force\n" +
           stiffness_table(readings, Fidelity::exact) + "by the line of centres\n" +
           stiffness_table(readings, Fidelity::line_of_centres);
  }
  return out +
         "Level: the plane of bending lies level and the gauge feels no weight. Hanging: the weight beyond the joint "
         "is\n"
         "in the force, and force times arm over angle is no stiffness; take the weight off before, or lay the finger "
         "down.\n";
}

std::string to_text(const std::vector<GraspBenchPoint>& points, const GraspBench& bench) {
  const std::string where =
      bench.grasp.height ? cell(*bench.grasp.height, "height_mm") + " mm beyond the last joint" : "at the tip";
  std::string out = fmt::format("Grasp bench: wall touched at {} deg of bending, {}\n",
                                cell(bench.grasp.opening, "opening_deg"), where);
  TextTable table;
  table.row({"", "exact", "", "line of centres", ""});
  table.row({"current A", "force N", "bending deg", "force N", "bending deg"});
  for (const GraspBenchPoint& point : points)
    table.row({short_number(point.current), cell(point.force.exact, "force_N"), degrees(point.bending.exact),
               cell(point.force.line_of_centres, "force_N"), degrees(point.bending.line_of_centres)});
  return out + table.text(2, {}) +
         "The wall has no friction. The weight of the finger is in the force, as on the paper's bench.\n";
}

std::string to_text(const std::vector<CameraRecord>& records, const Camera& camera) {
  std::string out =
      fmt::format("Camera: bending angle at {} frames a second, deg and deg/s\n", short_number(camera.frame_rate));
  for (const Fidelity fidelity : {Fidelity::exact, Fidelity::line_of_centres}) {
    out += fidelity == Fidelity::exact ? "By the exact force\n" : "By the line of centres\n";
    TextTable table;
    table.row({"record", "first", "last", "largest", "fastest rise", "late mean", "late peak to peak"});
    for (const CameraRecord& record : records) {
      const ResponseFigures shown = figures(record, fidelity);
      table.row({record.name(), degrees(shown.first), degrees(shown.last), degrees(shown.largest),
                 cell(shown.fastest, "rise_deg_s"), degrees(shown.late_mean), degrees(shown.peak_to_peak)});
    }
    out += table.text(2, {left});
  }
  out += "Mean absolute difference of the two\n";
  TextTable table;
  for (const CameraRecord& record : records) table.row({record.name(), degrees(mean_difference(record))});
  return out + table.text(2, {left}) + "Late is the last period of a sine and the last tenth of a step.\n";
}

}  // namespace coilwright::report
