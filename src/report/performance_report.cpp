#include "coilwright/report/performance_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace coilwright::report {
namespace {

using simulation::Motion;

constexpr double degrees = 180.0 / std::numbers::pi;

std::vector<double> in_degrees(const mechanics::JointVector& angles) {
  std::vector<double> out;
  for (const double angle : angles) out.push_back(angle * degrees);
  return out;
}

Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

void add_joints_and_modes(Json& out, const Motion& motion) {
  out.set("joint_angles_deg", Json::numbers(in_degrees(motion.steady_angles)));
  out.set("rest_joint_angles_deg", Json::numbers(in_degrees(motion.rest_angles)));
  out.set("grasp_joint_angles_deg", Json::numbers(in_degrees(motion.grasp_angles)));
  Json modes = Json::array();
  for (const simulation::Mode& mode : motion.modes)
    modes.add(Json::object({{"natural_frequency_Hz", mode.natural_frequency}, {"damping_ratio", mode.damping_ratio}}));
  out.set("modes", std::move(modes));
}

std::string joint_lines(const Motion& motion) {
  std::string text;
  const auto line = [&text](std::string_view name, const mechanics::JointVector& angles) {
    text += fmt::format("{:<28}", name);
    for (const double angle : angles) text += fmt::format(" {:.2f}", angle * degrees);
    text += '\n';
  };
  line("joint_angles_deg", motion.steady_angles);
  line("rest_joint_angles_deg", motion.rest_angles);
  line("grasp_joint_angles_deg", motion.grasp_angles);
  text += fmt::format("{:<28}", "modes (Hz, damping ratio)");
  for (const simulation::Mode& mode : motion.modes)
    text += fmt::format(" {:.2f} {:.3f};", mode.natural_frequency, mode.damping_ratio);
  text.back() = '\n';
  return text;
}

// The quantities of a model without a design, with their names in the table of quantities.
std::vector<std::pair<std::string_view, std::optional<double>>> motion_values(const Motion& motion, double current) {
  return {{"rest_angle_deg", motion.rest_angles.sum() * degrees},
          {"steady_angle_deg", motion.steady_angles.sum() * degrees},
          {"peak_bending_speed_deg_s", motion.peak_bending_speed * degrees},
          {"peak_speed_time_s", motion.peak_speed_time},
          {"rise_time_s", motion.rise_time},
          {"overshoot_pct", motion.overshoot * 100.0},
          {"settling_time_s", motion.settling_time},
          {"damping_ratio", motion.modes.front().damping_ratio},
          {"natural_frequency_Hz", motion.modes.front().natural_frequency},
          {"grasp_force_N", motion.grasp_force},
          {"contact_force_no_current_N", motion.contact_force_no_current},
          {"current_A", current}};
}

std::string value_line(std::string_view name, const std::optional<double>& value, std::string_view meaning) {
  const std::string number = value ? fmt::format("{:.6g}", *value) : "none";
  return fmt::format("{:<28} {:>12}  {}\n", name, number, meaning);
}

}  // namespace

Json to_json(const simulation::Candidate& candidate) {
  Json out = Json::object();
  for (const simulation::Quantity& quantity : simulation::quantities())
    out.set(std::string(quantity.name), number_or_null(quantity.get(candidate)));
  add_joints_and_modes(out, candidate.performance.motion);
  return out;
}

Json to_json(const Motion& motion, double current) {
  Json out = Json::object();
  for (const auto& [name, value] : motion_values(motion, current)) out.set(std::string(name), number_or_null(value));
  add_joints_and_modes(out, motion);
  return out;
}

std::string to_text(const simulation::Candidate& candidate) {
  std::string text;
  for (const simulation::Quantity& quantity : simulation::quantities())
    text += value_line(quantity.name, quantity.get(candidate), quantity.meaning);
  return text + joint_lines(candidate.performance.motion);
}

std::string to_text(const Motion& motion, double current) {
  std::string text;
  for (const auto& [name, value] : motion_values(motion, current))
    text += value_line(name, value, simulation::find_quantity(name)->meaning);
  return text + joint_lines(motion);
}

}  // namespace coilwright::report
