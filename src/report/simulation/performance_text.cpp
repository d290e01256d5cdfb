#include "coilwright/report/simulation/performance_text.hpp"

#include <fmt/format.h>

#include <numbers>
#include <optional>
#include <string_view>

namespace coilwright::report {
namespace {

using simulation::MotionSummary;
using simulation::QuantityTable;
using simulation::ResultQuantity;

constexpr double degrees = 180.0 / std::numbers::pi;

std::string joint_lines(const MotionSummary& motion) {
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

std::string to_text(const simulation::DesignView& design, const QuantityTable& quantities) {
  std::string text;
  for (const ResultQuantity& quantity : quantities)
    text += value_line(quantity.name, quantity.value(design), quantity.meaning);
  return text + joint_lines(design.performance.cold);
}

std::string to_text(const MotionSummary& motion, double current, const QuantityTable& quantities) {
  std::string text;
  for (const ResultQuantity& quantity : quantities)
    if (quantity.value_of_lumped)
      text += value_line(quantity.name, quantity.value_of_lumped(motion, current), quantity.meaning);
  return text + joint_lines(motion);
}

}  // namespace coilwright::report
