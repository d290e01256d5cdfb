#include "report/diagnosis/diagnosis_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "coilwright/formats/data/diagnosis_formatting.hpp"

namespace coilwright::report {
namespace {

using actuator::CorrectionAxis;
using measurement::correction::CorrectionPlace;
using measurement::correction::NamelessCorrection;

// A product of two functions if the best one has this share of the sum of squares.
constexpr double nearly_all = 0.95;

std::string axis_value_text(const CorrectionAxis& axis, double value) {
  return in_unit_text(value, formats::variable_unit(name_of(axis.variable)));
}

std::string variables_text(const NamelessCorrection& found) {
  std::vector<std::string> names;
  for (const CorrectionAxis& axis : found.torque.axes) names.emplace_back(name_of(axis.variable));
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string place_text(const NamelessCorrection& found, const CorrectionPlace& place) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < place.at.size(); ++i)
    parts.push_back(fmt::format("{} {}", name_of(found.torque.axes[i].variable),
                                axis_value_text(found.torque.axes[i], place.at[i])));
  return fmt::format("{} at {}",
                     in_unit_text(place.torque, formats::error_unit(measurement::data::ChannelKind::torque)),
                     fmt::join(parts, ", "));
}

std::string ranges_text(const NamelessCorrection& found) {
  std::vector<std::string> parts;
  for (const CorrectionAxis& axis : found.torque.axes)
    parts.push_back(fmt::format("{} from {} to {}", name_of(axis.variable), axis_value_text(axis, axis.nodes.front()),
                                axis_value_text(axis, axis.nodes.back())));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string shape_text(const NamelessCorrection& found) {
  if (found.products.empty()) return {};
  if (found.products.front() >= nearly_all)
    return fmt::format("  It is a function of {} times a function of {} (to {:.0f} %).\n",
                       name_of(found.torque.axes[0].variable), name_of(found.torque.axes[1].variable),
                       100.0 * found.products.front());
  return fmt::format("  It is no product of a function of {} and one of {}: the best has {:.0f} % of it.\n",
                     name_of(found.torque.axes[0].variable), name_of(found.torque.axes[1].variable),
                     100.0 * found.products.front());
}

// Effects that the correction explains better than they do.
std::string replaced_text(const formats::DiagnosisReport& report, const NamelessCorrection& found) {
  if (found.effects.size() == report.diagnosis.effects.size()) return {};
  return "  It does better without the effects above, and its file leaves them out.\n";
}

// What cross-validation promised, the runs that no fit has seen may refute.
std::string use_text(const formats::DiagnosisReport& report) {
  std::string text;
  for (const measurement::ErrorComparison* errors : formats::main_first(report.diagnosis.validate_errors)) {
    if (!errors->corrected) continue;
    const auto is_worse_than = [&](const measurement::Errors& without) {
      return has_risen(without, *errors->corrected, errors->noise_floor_rmse);
    };
    const bool is_worse = is_worse_than(errors->after);
    if (!is_worse && !is_worse_than(errors->declared)) continue;
    const units::Unit unit = formats::error_unit(errors->kind);
    text += fmt::format(
        "  But on the runs that no fit has seen the error of the {} rises with it from {}{} to {} (rmse).\n",
        formats::name_of(errors->kind),
        number_text(units::from_si((is_worse ? errors->after : errors->declared).rmse, unit)),
        is_worse ? "" : " as declared", in_unit_text(errors->corrected->rmse, unit));
  }
  if (!text.empty())
    return text + fmt::format("  Do not use {}, which has it, before a run of that kind is among those fitted.\n",
                              report.corrected_actuator);
  if (!report.refused.empty()) return fmt::format("  {} has it.\n", report.corrected_actuator);
  return fmt::format("  {} has it: evaluate and simulate take it, and size where the geometry stays.\n",
                     report.corrected_actuator);
}

}  // namespace

Section correction_section(const formats::DiagnosisReport& report) {
  const auto& correction = report.diagnosis.correction;
  Section section{.id = "correction", .title = "A torque without a name"};
  if (!correction.found) {
    section.say(correction.reason.empty() ? "" : fmt::format("  None is offered. {}\n", correction.reason));
    return section;
  }
  const NamelessCorrection& found = *correction.found;
  section.say(
      fmt::format(
          "  A smooth joint torque over {} takes away {:.0f} % of the squared error above the noise on runs that "
          "were left out in turn. Nobody knows what it is: it serves until somebody can name it.\n"
          "  It holds for {}, and fades beyond.\n"
          "  It is largest, {}, and smallest, {}.\n",
          variables_text(found), 100.0 * found.cross_validated_gain, ranges_text(found),
          place_text(found, found.largest), place_text(found, found.smallest)) +
      shape_text(found) + replaced_text(report, found) + use_text(report));
  return section;
}

}  // namespace coilwright::report
