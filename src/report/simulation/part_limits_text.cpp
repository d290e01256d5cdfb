#include "coilwright/report/simulation/part_limits_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/report/simulation/percent.hpp"

namespace coilwright::report {
namespace {

using simulation::ChoiceEffect;
using simulation::DesignView;
using simulation::EvaluatedDesign;
using simulation::NoPerformance;
using simulation::PartLimit;
using enum TextTable::Align;

std::string limit_text(const PartLimit& limit) {
  return fmt::format("{} {}", limit.at_most ? "at most" : "at least", short_number(limit.limit));
}

// Relative changes below this are not worth a reader's time.
constexpr double noticeable = 0.005;

struct FigureChange {
  std::string text;
  bool is_noticeable{};
};

FigureChange change_of(std::string_view name, const DesignView& taken, const DesignView& other) {
  const simulation::ResultQuantity& quantity = simulation::standard_quantities().at(name);
  const std::optional<double> value = quantity.value(other);
  const std::optional<double> reference = quantity.value(taken);
  if (!value) return {.text = fmt::format("{} none", name), .is_noticeable = reference.has_value()};
  if (!reference || *reference == 0.0)
    return {.text = fmt::format("{} {}", name, short_number(*value)), .is_noticeable = value != reference};
  const double change = (*value - *reference) / std::abs(*reference);
  return {.text = fmt::format("{} {} ({})", name, short_number(*value), percent_change(change)),
          .is_noticeable = std::abs(change) >= noticeable};
}

std::string changes_text(const DesignView& taken, const DesignView& other) {
  std::vector<std::string> changes;
  for (const std::string_view name : simulation::main_figures)
    if (FigureChange change = change_of(name, taken, other); change.is_noticeable)
      changes.push_back(std::move(change.text));
  return fmt::format("{}", fmt::join(changes, "; "));
}

std::vector<PartLimit> unconditional_limits(const DesignView& design) {
  std::vector<PartLimit> limits = simulation::part_limits(design);
  std::erase_if(limits, [](const PartLimit& limit) { return limit.conditional; });
  return limits;
}

std::vector<std::string_view> broken_among(const std::vector<PartLimit>& limits) {
  std::vector<std::string_view> names;
  for (const PartLimit& limit : limits)
    if (limit.is_broken()) names.push_back(limit.quantity);
  return names;
}

std::string worst_limit_text(const std::vector<PartLimit>& limits) {
  const auto worst = std::ranges::min_element(limits, {}, &PartLimit::margin);
  if (!worst->value) return fmt::format("BROKEN: {} has no steady value", worst->quantity);
  return fmt::format("{}{} {}, {}", worst->is_broken() ? "BROKEN: " : "least margin: ", worst->quantity,
                     short_number(*worst->value), limit_text(*worst));
}

std::string effect_text(const DesignView& taken, const ChoiceEffect& effect) {
  std::string text = fmt::format("    if it is: {}\n", effect.choice.otherwise);
  if (const auto* why = std::get_if<NoPerformance>(&effect.result))
    return text + fmt::format("      cannot be evaluated: {}\n", why->reason);
  const DesignView other = std::get<EvaluatedDesign>(effect.result).view();
  if (const std::string changes = changes_text(taken, other); !changes.empty())
    text += fmt::format("      {}\n", changes);
  const std::vector<PartLimit> before = unconditional_limits(taken);
  const std::vector<PartLimit> limits = unconditional_limits(other);
  const bool breaks_others = broken_among(limits) != broken_among(before);
  const bool is_kept_otherwise = broken_among(limits).empty() && worst_limit_text(limits) != worst_limit_text(before);
  if (breaks_others || is_kept_otherwise) text += fmt::format("      {}\n", worst_limit_text(limits));
  return text;
}

// What is as without the other choice is said once, above all of them.
std::string unchanged_text(const DesignView& taken) {
  const bool broken = !broken_among(unconditional_limits(taken)).empty();
  return fmt::format("  Where no figure is named, none changes by {:.1f} %{}.\n", 100.0 * noticeable,
                     broken ? "; where no limit is, the same are broken as above" : "");
}

std::string value_text(const PartLimit& limit) {
  return limit.value ? short_number(*limit.value) : "none (thermal runaway)";
}

std::string state_of(const PartLimit& limit) {
  if (!limit.is_broken()) return "kept";
  if (limit.conditional && !limit.value) return "-";
  return fmt::format("{}: {}", limit.conditional ? "MIND" : "BROKEN", limit.consequence);
}

// What a study says to keep a limit.
struct Constraint {
  std::string quantity;
  bool at_most = true;
  double limit{};

  [[nodiscard]] bool is_kept_by(double other) const { return at_most ? other <= limit : other >= limit; }
  [[nodiscard]] std::string text() const {
    return fmt::format(R"({{"quantity": "{}", "{}": {}}})", quantity, at_most ? "at_most" : "at_least",
                       short_number(limit));
  }
};

Constraint constraint_of(const PartLimit& limit, bool in_builds) {
  const std::string_view statistic = !in_builds ? "" : limit.at_most ? "p95_" : "p05_";
  // The limits of temperature are those of one wire and one grade of magnet, which the study may vary: the load is
  // over whichever the design has.
  if (limit.quantity.ends_with("_degC"))
    return {.quantity = fmt::format("{}thermal_load", statistic), .at_most = true, .limit = 1.0};
  return {.quantity = fmt::format("{}{}", statistic, limit.quantity), .at_most = limit.at_most, .limit = limit.limit};
}

std::string sentence_of(std::string_view beginning, const std::vector<std::string>& constraints,
                        std::string_view end = "") {
  return constraints.empty() ? "" : fmt::format("{}: {}{}\n", beginning, fmt::join(constraints, ", "), end);
}

// A line for each, and the constraints that keep them, by whether the study has them already.
std::string lines_of(std::string_view title, std::span<const PartLimit> broken, bool in_builds,
                     const LimitInStudy& limit_in_study, std::string_view add) {
  std::string text;
  std::vector<std::string> missing;
  std::vector<std::string> loose;
  std::vector<std::string> there;
  for (const PartLimit& limit : broken) {
    text += fmt::format("  {} {}, {}: {}\n", limit.quantity, value_text(limit), limit_text(limit), limit.consequence);
    const Constraint constraint = constraint_of(limit, in_builds);
    const std::optional<double> in_study = limit_in_study(constraint.quantity, constraint.at_most);
    std::vector<std::string>& list = !in_study ? missing : constraint.is_kept_by(*in_study) ? there : loose;
    if (std::string each = constraint.text(); std::ranges::find(list, each) == list.end())
      list.push_back(std::move(each));
  }
  return fmt::format("{}\n{}", title, text) +
         sentence_of(fmt::format("{} to the study's \"constraints\" and size anew", add), missing) +
         sentence_of("Tighten in the study's \"constraints\" and size anew", loose) +
         sentence_of("In the study already, and kept by as many builds as it asks for", there,
                     "; the design itself, used as its file says, does not keep it");
}

}  // namespace

Section limits_section(std::span<const PartLimit> limits) {
  BarChart chart{.id = "margins",
                 .title = "Margins of the parts",
                 .description =
                     "How far each part is from its limit, in per cent of the limit. A bar to the left is a limit that "
                     "is broken; it ends at -100 % where there is no steady value.",
                 .value_title = "margin, %",
                 .label_title = "limit"};
  TableBlock block{.caption = "Limits of the parts",
                   .table = {.header = {"quantity", "value", "limit", "state"}},
                   .align = {left, right, left, left},
                   .headed = false};
  for (const PartLimit& each : limits) {
    block.table.rows.push_back({std::string(each.quantity), value_text(each), limit_text(each), state_of(each)});
    chart.bars.push_back({.label = fmt::format("{} {}", each.quantity, limit_text(each)),
                          .value = 100.0 * each.margin(),
                          .group = !each.is_broken()  ? "kept"
                                   : each.conditional ? "on a condition"
                                                      : "broken"});
  }
  return {.id = "limits",
          .title = "Limits of the parts at this operating point",
          .blocks = {std::move(chart), std::move(block)}};
}

std::vector<std::string> cautions_of_parts(std::span<const PartLimit> broken, bool in_builds,
                                           const LimitInStudy& limit_in_study) {
  std::vector<std::string> out;
  for (const bool conditional : {false, true}) {
    std::vector<PartLimit> those(broken.begin(), broken.end());
    std::erase_if(those, [&](const PartLimit& limit) { return limit.conditional != conditional; });
    if (those.empty()) continue;
    out.push_back(lines_of(
        conditional ? "MIND what this design needs, or gives up" : "BEWARE: this design breaks limits of its parts",
        those, in_builds, limit_in_study, conditional ? "Where that will not do, add" : "Add"));
  }
  return out;
}

std::vector<std::string> doubts_of(const actuator::Design& design) {
  std::vector<std::string> out;
  for (const actuator::CalibrationDoubt& each : actuator::calibration_doubts(design))
    out.push_back(
        fmt::format("MIND: the {} that was measured is {:.3g} times what the dimensions give: was it measured on this "
                    "actuator?\n",
                    each.quantity, each.factor));
  return out;
}

std::string subject_text(const actuator::OtherChoice& choice) {
  return fmt::format("  {}, taken as: {}\n    known by: {}; settled by: {}\n", choice.subject, choice.taken,
                     choice.source, choice.settled_by);
}

Section assumptions_section(const DesignView& taken, std::span<const ChoiceEffect> effects) {
  std::string text =
      "Choices and numbers that no measurement of this design has settled, the largest first\n" + unchanged_text(taken);
  std::vector<std::string_view> small;
  for (const std::span<const ChoiceEffect> of_subject : by_subject(effects)) {
    if (std::ranges::none_of(of_subject, &ChoiceEffect::matters)) {
      small.push_back(of_subject.front().choice.subject);
      continue;
    }
    text += subject_text(of_subject.front().choice);
    for (const ChoiceEffect& effect : of_subject) text += effect_text(taken, effect);
  }
  if (!small.empty())
    text += fmt::format("  By less than {:.3g} % on each of {}, and on no limit: {}.\n",
                        100.0 * simulation::change_that_matters, fmt::join(simulation::main_figures, ", "),
                        fmt::join(small, ", "));
  return {.id = "assumptions", .title = "What these figures rest on", .blocks = {Lines{std::move(text)}}};
}

}  // namespace coilwright::report
