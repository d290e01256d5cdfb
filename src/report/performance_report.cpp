#include "coilwright/report/performance_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace coilwright::report {
namespace {

using namespace text;
using simulation::Motion;
using simulation::QuantityTable;
using simulation::ResultQuantity;

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

std::string value_line(std::string_view name, const std::optional<double>& value, std::string_view meaning) {
  const std::string number = value ? fmt::format("{:.6g}", *value) : "none";
  return fmt::format("{:<28} {:>12}  {}\n", name, number, meaning);
}

}  // namespace

Json to_json(const simulation::DesignView& design, const QuantityTable& quantities) {
  Json out = Json::object();
  for (const ResultQuantity& quantity : quantities) out.set(quantity.name, number_or_null(quantity.value(design)));
  add_joints_and_modes(out, design.performance.motion);
  return out;
}

Json to_json(const Motion& motion, double current, const QuantityTable& quantities) {
  Json out = Json::object();
  for (const ResultQuantity& quantity : quantities)
    if (quantity.value_of_lumped) out.set(quantity.name, number_or_null(quantity.value_of_lumped(motion, current)));
  add_joints_and_modes(out, motion);
  return out;
}

std::string to_text(const simulation::DesignView& design, const QuantityTable& quantities) {
  std::string text;
  for (const ResultQuantity& quantity : quantities)
    text += value_line(quantity.name, quantity.value(design), quantity.meaning);
  return text + joint_lines(design.performance.motion);
}

std::string to_text(const Motion& motion, double current, const QuantityTable& quantities) {
  std::string text;
  for (const ResultQuantity& quantity : quantities)
    if (quantity.value_of_lumped)
      text += value_line(quantity.name, quantity.value_of_lumped(motion, current), quantity.meaning);
  return text + joint_lines(motion);
}

}  // namespace coilwright::report
