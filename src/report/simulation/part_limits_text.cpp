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
    return {.text = fmt::format("{} {:.4g}", name, *value), .is_noticeable = value != reference};
  const double change = (*value - *reference) / std::abs(*reference);
  return {.text = fmt::format("{} {:.4g} ({})", name, *value, percent_change(change)),
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
  return fmt::format("{}{} {:.4g}, {} {:.4g}", worst->is_broken() ? "BROKEN: " : "least margin: ", worst->quantity,
                     *worst->value, worst->at_most ? "at most" : "at least", worst->limit);
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
  return limit.value ? fmt::format("{:.5g}", *limit.value) : "none (thermal runaway)";
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
    return fmt::format(R"({{"quantity": "{}", "{}": {:.5g}}})", quantity, at_most ? "at_most" : "at_least", limit);
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
    text += fmt::format("  {:<34} {:>10}  {} {:.5g}: {}\n", limit.quantity, value_text(limit),
                        limit.at_most ? "at most" : "at least", limit.limit, limit.consequence);
    const Constraint constraint = constraint_of(limit, in_builds);
    const std::optional<double> in_study = limit_in_study(constraint.quantity, constraint.at_most);
    std::vector<std::string>& list = !in_study ? missing : constraint.is_kept_by(*in_study) ? there : loose;
    if (std::string each = constraint.text(); std::ranges::find(list, each) == list.end())
      list.push_back(std::move(each));
  }
  return fmt::format("\n{}\n{}", title, text) +
         sentence_of(fmt::format("{} to the study's \"constraints\" and size anew", add), missing) +
         sentence_of("Tighten in the study's \"constraints\" and size anew", loose) +
         sentence_of("In the study already, and kept by as many builds as it asks for", there,
                     "; the design itself, used as its file says, does not keep it");
}

}  // namespace

std::string to_text(std::span<const PartLimit> limits) {
  std::string text = "Limits of the parts at this operating point\n";
  for (const PartLimit& limit : limits) {
    text += fmt::format("  {:<34} {:>10}  {} {:.5g}  {}\n", limit.quantity, value_text(limit),
                        limit.at_most ? "at most" : "at least", limit.limit, state_of(limit));
  }
  return text;
}

std::string warning_of_parts(std::span<const PartLimit> broken, bool in_builds, const LimitInStudy& limit_in_study) {
  const auto those = [&](bool conditional) {
    std::vector<PartLimit> out(broken.begin(), broken.end());
    std::erase_if(out, [conditional](const PartLimit& limit) { return limit.conditional != conditional; });
    return out;
  };
  std::string text;
  if (const std::vector<PartLimit> fatal = those(false); !fatal.empty())
    text += lines_of("BEWARE: this design breaks limits of its parts", fatal, in_builds, limit_in_study, "Add");
  if (const std::vector<PartLimit> conditional = those(true); !conditional.empty())
    text += lines_of("MIND what this design needs, or gives up", conditional, in_builds, limit_in_study,
                     "Where that will not do, add");
  return text;
}

std::string doubts_text(const actuator::Design& design) {
  std::string text;
  for (const actuator::CalibrationDoubt& each : actuator::calibration_doubts(design))
    text += fmt::format(
        "\nMIND: the {} that was measured is {:.3g} times what the dimensions give: was it measured on this "
        "actuator?\n",
        each.quantity, each.factor);
  return text;
}

std::string subject_text(const actuator::OtherChoice& choice) {
  return fmt::format("  {}, taken as: {}\n    known by: {}; settled by: {}\n", choice.subject, choice.taken,
                     choice.source, choice.settled_by);
}

std::string to_text(const DesignView& taken, std::span<const ChoiceEffect> effects) {
  std::string text =
      "\nWhat these figures rest on: choices and numbers that no measurement of this design has settled, the largest "
      "first\n";
  if (!effects.empty()) text += unchanged_text(taken);
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
  return text;
}

}  // namespace coilwright::report
