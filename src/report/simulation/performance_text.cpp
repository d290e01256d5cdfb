#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/units/angle.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/report/simulation/coil_currents_text.hpp"
#include "coilwright/report/simulation/correction_text.hpp"
#include "coilwright/report/simulation/part_limits_text.hpp"
#include "coilwright/report/simulation/shut_joints_text.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/pressed_joints.hpp"

namespace coilwright::report {
namespace {

using simulation::FreeMotion;
using simulation::Grasp;
using simulation::MotionSummary;
using simulation::QuantityTable;
using simulation::ResultQuantity;

using enum TextTable::Align;

// What rounding leaves of nothing is nothing to a reader.
std::vector<std::string> row_of(const ResultQuantity& quantity, std::optional<double> value) {
  constexpr double rounding = 1e-12;
  if (value && std::abs(*value) < rounding * quantity.scale) value = 0.0;
  return {quantity.name, value ? short_number(*value) : "none", quantity.meaning};
}

// Quantities, and then what is listed by joints.
Section section_of(std::vector<std::vector<std::string>> quantities, const mechanics::JointVector& rest,
                   const FreeMotion* motion, const Grasp* grasp) {
  Table joints{.header = {"of each joint, from the base", "value"}};
  const auto add = [&](const char* name, const mechanics::JointVector* angles) {
    std::vector<std::string> values;
    for (const double angle : angles == nullptr ? mechanics::JointVector() : *angles)
      values.push_back(fmt::format("{:.2f}", angle * units::degrees_per_radian));
    joints.rows.push_back({name, angles == nullptr ? "none" : fmt::format("{}", fmt::join(values, " "))});
  };
  add("joint_angles_deg", motion == nullptr ? nullptr : &motion->steady_angles);
  add("rest_joint_angles_deg", &rest);
  add("grasp_joint_angles_deg", grasp == nullptr ? nullptr : &grasp->grasp_angles);
  if (motion != nullptr) {
    std::vector<std::string> modes;
    for (const simulation::Mode& mode : motion->modes)
      modes.push_back(fmt::format("{:.2f} {:.3f}", mode.natural_frequency, mode.damping_ratio));
    joints.rows.push_back({"modes (Hz, damping ratio)", fmt::format("{}", fmt::join(modes, "; "))});
  }
  return {.id = "quantities",
          .title = "All quantities",
          .blocks = {
              TableBlock{.caption = "Quantities",
                         .table = {.header = {"quantity", "value", "meaning"}, .rows = std::move(quantities)},
                         .align = {left, right, left},
                         .headed = false},
              TableBlock{
                  .caption = "Angles and modes", .table = std::move(joints), .align = {left, left}, .headed = false}}};
}

std::string verdict_of(const simulation::DesignView& design, bool all_kept) {
  std::vector<std::string> figures;
  for (const std::string_view name : simulation::main_figures) {
    const std::optional<double> value = simulation::standard_quantities().at(name).value(design);
    figures.push_back(fmt::format("{} {}", name, value ? short_number(*value) : "none"));
  }
  return fmt::format("With {} and a duty of {}: {}.{}{}", coil_currents_text(design.design, design.point.current),
                     short_number(design.point.duty), fmt::join(figures, ", "),
                     has_one_current(design.design) ? "" : " Each coil needs a driver of its own.",
                     all_kept ? " No part is beyond a limit of its own." : "");
}

// The names of the limits that are broken; the section of limits says more of each.
std::vector<std::string> cautions_of(const std::vector<simulation::PartLimit>& limits) {
  std::vector<std::string> out;
  for (const bool conditional : {false, true}) {
    std::vector<std::string_view> names;
    for (const simulation::PartLimit& each : limits)
      if (each.is_broken() && each.conditional == conditional) names.push_back(each.quantity);
    if (!names.empty())
      out.push_back(fmt::format(
          "{}: {} (see below).\n",
          conditional ? "MIND what this design needs, or gives up" : "BEWARE: this design breaks limits of its parts",
          fmt::join(names, ", ")));
  }
  return out;
}

}  // namespace

Section quantities_section(const simulation::DesignView& design, const QuantityTable& quantities) {
  std::vector<std::vector<std::string>> rows;
  for (const ResultQuantity& each : quantities) rows.push_back(row_of(each, each.value(design)));
  const simulation::Performance& found = design.performance;
  return section_of(std::move(rows), found.cold.rest_angles, found.free.motion ? &*found.free.motion : nullptr,
                    found.gripping.grasp ? &*found.gripping.grasp : nullptr);
}

Section quantities_section(const MotionSummary& motion, double current, const QuantityTable& quantities) {
  std::vector<std::vector<std::string>> rows;
  for (const ResultQuantity& each : quantities)
    if (each.value_of_lumped) rows.push_back(row_of(each, each.value_of_lumped(motion, current)));
  return section_of(std::move(rows), motion.rest_angles, &motion, &motion);
}

Document document_of(const simulation::DesignView& design, std::span<const simulation::ChoiceEffect> effects) {
  const std::vector<simulation::PartLimit> limits = simulation::told_part_limits(design);
  Document out{.cautions = cautions_of(limits)};
  out.verdict = verdict_of(design, out.cautions.empty());
  for (std::string& doubt : doubts_of(design.design)) out.cautions.push_back(std::move(doubt));
  out.sections = {limits_section(limits), opening_section(design), quantities_section(design)};
  if (!effects.empty()) out.sections.push_back(assumptions_section(design, effects));
  out.sections.push_back(correction_section(
      simulation::correction_reach(design.assembly.model, design.performance.cold, design.point.current)));
  return out;
}

Document document_of(const actuator::Model& model, const MotionSummary& motion, double current) {
  Document out;
  if (const std::string text = simulation::pressed_joints_text(simulation::pressed_joints(model, motion.rest_angles),
                                                               simulation::pressed_joints(model, motion.steady_angles));
      !text.empty())
    out.cautions.push_back(fmt::format("MIND: {}.\n", text));
  out.sections = {quantities_section(motion, current),
                  correction_section(simulation::correction_reach(model, motion, current))};
  return out;
}

}  // namespace coilwright::report
