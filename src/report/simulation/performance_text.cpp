#include "coilwright/report/simulation/performance_text.hpp"

#include <fmt/format.h>

#include <numbers>
#include <optional>
#include <string_view>

namespace coilwright::report {
namespace {

using simulation::FreeMotion;
using simulation::Grasp;
using simulation::MotionSummary;
using simulation::QuantityTable;
using simulation::ResultQuantity;

constexpr double degrees = 180.0 / std::numbers::pi;

std::string joint_lines(const mechanics::JointVector& rest, const FreeMotion* motion, const Grasp* grasp) {
  std::string text;
  const auto line = [&text](std::string_view name, const mechanics::JointVector* angles) {
    text += fmt::format("{:<28}", name);
    if (angles == nullptr)
      text += " none";
    else
      for (const double angle : *angles) text += fmt::format(" {:.2f}", angle * degrees);
    text += '\n';
  };
  line("joint_angles_deg", motion == nullptr ? nullptr : &motion->steady_angles);
  line("rest_joint_angles_deg", &rest);
  line("grasp_joint_angles_deg", grasp == nullptr ? nullptr : &grasp->grasp_angles);
  if (motion == nullptr) return text;
  text += fmt::format("{:<28}", "modes (Hz, damping ratio)");
  for (const simulation::Mode& mode : motion->modes)
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
  const simulation::Performance& found = design.performance;
  return text + joint_lines(found.cold.rest_angles, found.free.motion ? &*found.free.motion : nullptr,
                            found.gripping.grasp ? &*found.gripping.grasp : nullptr);
}

std::string to_text(const MotionSummary& motion, double current, const QuantityTable& quantities) {
  std::string text;
  for (const ResultQuantity& quantity : quantities)
    if (quantity.value_of_lumped)
      text += value_line(quantity.name, quantity.value_of_lumped(motion, current), quantity.meaning);
  return text + joint_lines(motion.rest_angles, &motion, &motion);
}

}  // namespace coilwright::report
