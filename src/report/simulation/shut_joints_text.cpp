#include "coilwright/report/simulation/shut_joints_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/pressed_joints.hpp"
#include "coilwright/simulation/shut_joints.hpp"

namespace coilwright::report {
namespace {

using simulation::EvaluatedDesign;
using simulation::OpeningChange;

// The keys of an actuator file that say the row.
std::string row_text(const actuator::Layout& layout) {
  std::vector<std::string_view> kinds;
  std::vector<int> polarity;
  for (const actuator::Component& each : layout) {
    kinds.push_back(each.kind == actuator::ComponentKind::coil ? R"("coil")" : R"("magnet")");
    polarity.push_back(each.polarity);
  }
  return fmt::format(R"("layout": [{}], "polarity": [{}])", fmt::join(kinds, ", "), fmt::join(polarity, ", "));
}

std::string change_text(const OpeningChange& change) {
  const actuator::Layout& layout = change.result.design.layout;
  switch (change.of) {
    case OpeningChange::Of::polarity:
      return fmt::format("{} turned round: {}", change.parts, row_text(layout));
    case OpeningChange::Of::row:
      return fmt::format("another row: {}", row_text(layout));
    case OpeningChange::Of::current:
      return fmt::format("{:.4g} A", change.result.point.current);
  }
  return {};
}

std::string result_text(const EvaluatedDesign& design) {
  std::vector<std::string> parts;
  for (const std::string_view name : {"rest_angle_deg", "stroke_deg", "smallest_joint_stroke_deg"})
    if (const auto value = simulation::standard_quantities().at(name).value(design.view()))
      parts.push_back(fmt::format("{} {:.3g}", name, *value));
  std::string text = fmt::format("{}", fmt::join(parts, ", "));
  if (const auto shut = simulation::pressed_joints(design.assembly.model, design.performance.cold.rest_angles);
      !shut.empty())
    text += fmt::format("; {} shut without current", simulation::joints_text(shut));
  std::vector<std::string_view> broken;
  for (const simulation::PartLimit& limit : simulation::broken_part_limits(design.view()))
    if (!limit.conditional) broken.push_back(limit.quantity);
  if (!broken.empty()) text += fmt::format("; but it breaks {}", fmt::join(broken, ", "));
  return text;
}

}  // namespace

Section opening_section(const simulation::DesignView& design) {
  Section section{.id = "opening", .title = "What opens every joint, with all else as it is"};
  const auto& motion = design.performance.free.motion;
  if (!motion || simulation::pressed_joints(design.assembly.model, motion->steady_angles).empty()) return section;
  const std::vector<OpeningChange> changes = simulation::what_opens_joints(design);
  std::string text;
  if (changes.empty()) text = "No polarity, no row near this one and no current was found that opens every joint.\n";
  for (const OpeningChange& change : changes)
    text += fmt::format("  {}\n    {}\n", change_text(change), result_text(change.result));
  section.blocks.emplace_back(
      Lines{text + "In a study, the limit of smallest_joint_stroke_deg asks for joints that open, and the variables "
                   "\"polarity\" and \"layout\" try rows.\n"});
  return section;
}

}  // namespace coilwright::report
