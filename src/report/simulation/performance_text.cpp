#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/units/angle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace coilwright::report {
namespace {

using simulation::FreeMotion;
using simulation::Grasp;
using simulation::MotionSummary;
using simulation::QuantityTable;
using simulation::ResultQuantity;

constexpr std::string_view modes_name = "modes (Hz, damping ratio)";

// A quantity with its value, if it has one.
struct Line {
  std::string_view name;
  std::optional<double> value;
  std::string_view meaning;
};

// What rounding leaves of nothing is nothing to a reader.
std::optional<double> shown(const ResultQuantity& quantity, const std::optional<double>& value) {
  constexpr double rounding = 1e-12;
  return value && std::abs(*value) < rounding * quantity.scale ? 0.0 : value;
}

std::size_t width_of(const std::vector<Line>& lines) {
  std::size_t width = modes_name.size();
  for (const Line& line : lines) width = std::max(width, line.name.size());
  return width;
}

std::string joint_lines(std::size_t width, const mechanics::JointVector& rest, const FreeMotion* motion,
                        const Grasp* grasp) {
  std::string text;
  const auto line = [&](std::string_view name, const mechanics::JointVector* angles) {
    text += fmt::format("{:<{}}", name, width);
    if (angles == nullptr)
      text += " none";
    else
      for (const double angle : *angles) text += fmt::format(" {:.2f}", angle * units::degrees_per_radian);
    text += '\n';
  };
  line("joint_angles_deg", motion == nullptr ? nullptr : &motion->steady_angles);
  line("rest_joint_angles_deg", &rest);
  line("grasp_joint_angles_deg", grasp == nullptr ? nullptr : &grasp->grasp_angles);
  if (motion == nullptr) return text;
  text += fmt::format("{:<{}}", modes_name, width);
  for (const simulation::Mode& mode : motion->modes)
    text += fmt::format(" {:.2f} {:.3f};", mode.natural_frequency, mode.damping_ratio);
  text.back() = '\n';
  return text;
}

std::string value_lines(std::size_t width, const std::vector<Line>& lines) {
  std::string text;
  for (const auto& [name, value, meaning] : lines) {
    const std::string number = value ? fmt::format("{:.6g}", *value) : "none";
    text += fmt::format("{:<{}} {:>12}  {}\n", name, width, number, meaning);
  }
  return text;
}

}  // namespace

std::string to_text(const simulation::DesignView& design, const QuantityTable& quantities) {
  std::vector<Line> lines;
  for (const ResultQuantity& quantity : quantities)
    lines.push_back(
        {.name = quantity.name, .value = shown(quantity, quantity.value(design)), .meaning = quantity.meaning});
  const std::size_t width = width_of(lines);
  const simulation::Performance& found = design.performance;
  return value_lines(width, lines) + joint_lines(width, found.cold.rest_angles,
                                                 found.free.motion ? &*found.free.motion : nullptr,
                                                 found.gripping.grasp ? &*found.gripping.grasp : nullptr);
}

std::string to_text(const MotionSummary& motion, double current, const QuantityTable& quantities) {
  std::vector<Line> lines;
  for (const ResultQuantity& quantity : quantities)
    if (quantity.value_of_lumped)
      lines.push_back({.name = quantity.name,
                       .value = shown(quantity, quantity.value_of_lumped(motion, current)),
                       .meaning = quantity.meaning});
  const std::size_t width = width_of(lines);
  return value_lines(width, lines) + joint_lines(width, motion.rest_angles, &motion, &motion);
}

}  // namespace coilwright::report
