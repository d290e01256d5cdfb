#include "coilwright/report/simulation/correction_text.hpp"
#include "coilwright/units/angle.hpp"

#include <fmt/format.h>

namespace coilwright::report {
namespace {

using actuator::CorrectionVariable;
using simulation::CorrectionReach;

struct Shown {
  const char* name;
  const char* unit;
  double per_si;
};

Shown shown(CorrectionVariable variable) {
  switch (variable) {
    case CorrectionVariable::angle:
      return {.name = "joint angles", .unit = "deg", .per_si = units::degrees_per_radian};
    case CorrectionVariable::rate:
      return {.name = "joint rates", .unit = "deg/s", .per_si = units::degrees_per_radian};
    case CorrectionVariable::current:
      break;
  }
  return {.name = "currents", .unit = "A", .per_si = 1.0};
}

std::string range(const CorrectionReach& each, double from, double to) {
  const Shown as = shown(each.variable);
  return fmt::format("{} of {:.3g} to {:.3g} {}", as.name, from * as.per_si, to * as.per_si, as.unit);
}

}  // namespace

std::string to_text(std::span<const CorrectionReach> reach) {
  if (reach.empty()) return {};
  std::string measured;
  for (const CorrectionReach& each : reach)
    measured += (measured.empty() ? "" : " and ") + range(each, each.measured_from, each.measured_to);
  std::string text = fmt::format(
      "With a nameless correction of the torque: what records showed and no known effect explains.\n"
      "It was measured at {}.\n",
      measured);
  for (const CorrectionReach& each : reach)
    if (each.is_beyond())
      text += fmt::format("WARNING: used at {}: beyond what was measured it fades to nothing.\n",
                          range(each, each.used_from, each.used_to));
  return text;
}

Section correction_section(std::span<const CorrectionReach> reach) {
  Section section{.id = "correction", .title = "A torque without a name"};
  if (!reach.empty()) section.blocks.emplace_back(Lines{to_text(reach)});
  return section;
}

}  // namespace coilwright::report
