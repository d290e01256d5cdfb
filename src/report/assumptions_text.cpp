#include "report/study_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/simulation/part_limits_text.hpp"
#include "coilwright/report/simulation/percent.hpp"
#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::report {
namespace {

using namespace sizing;

std::string objective_change(double value, double promised) {
  if (promised == 0.0) return short_number(value);
  return fmt::format("{} ({})", short_number(value), percent_change((value - promised) / std::abs(promised)));
}

std::string limit_phrase(const Limit& limit, double constraint) {
  return fmt::format("{}: {}", name_of(limit), short_number(formats::value_behind(limit, constraint)));
}

// Every limit that is broken, in the order of the study; otherwise the nearest.
std::string margin_phrase(const Study& study, const AssumptionEffect& effect) {
  if (!effect.worst) return "";
  std::vector<std::string> broken;
  for (std::size_t i = 0; i < study.limits.size(); ++i)
    if (effect.evaluation.constraints[i] > 0.0)
      broken.push_back(limit_phrase(study.limits[i], effect.evaluation.constraints[i]));
  if (!broken.empty()) return fmt::format("; BREAKS {}", fmt::join(broken, ", "));
  return "; keeps every limit, nearest " +
         limit_phrase(formats::limit_named(study, effect.worst->limit), -effect.worst->margin);
}

std::string effect_text(const formats::SizeReport& report, const AssumptionEffect& effect) {
  const std::string_view objective = report.study.objectives.front().quantity.name;
  const Record& best = *report.result.best;
  std::string text = fmt::format("    if it is: {}\n", effect.choice.otherwise);
  if (!effect.evaluation.failure.empty())
    text += fmt::format("      this design cannot be evaluated: {}\n", effect.evaluation.failure);
  else
    text += fmt::format("      {} {}{}\n", objective,
                        objective_change(effect.evaluation.objectives.front(), best.evaluation.objectives.front()),
                        margin_phrase(report.study, effect));
  if (effect.changes_design)
    text += fmt::format("      the best design is then another one: {} {} with {}\n", objective,
                        short_number(effect.other_best->evaluation.objectives.front()),
                        difference(report.study, best, *effect.other_best));
  return text;
}

// The limits that it breaks by so little that a builder has that of many numbers.
std::optional<std::string> slightly_broken(const Study& study, const AssumptionEffect& effect) {
  constexpr double slight = simulation::change_that_matters;
  if (effect.changes_design || std::abs(effect.gain) >= slight || !effect.worst || effect.worst->margin < -slight)
    return std::nullopt;
  std::vector<std::string> broken;
  for (std::size_t i = 0; i < study.limits.size(); ++i)
    if (effect.evaluation.constraints[i] > 0.0) broken.push_back(name_of(study.limits[i]));
  return fmt::format("{} ({})", effect.choice.otherwise, fmt::join(broken, ", "));
}

BarChart choices_chart(const formats::SizeReport& report) {
  BarChart chart{
      .id = "choices",
      .title = "This design if something is otherwise",
      .description =
          "Value of the objective if a choice of the model or a number is otherwise, and whether the design "
          "then still keeps its limits.",
      .value_title = report.study.objectives.front().quantity.name,
      .label_title = "if it is otherwise",
      .bars = {{.label = "as taken", .value = report.result.best->evaluation.objectives.front(), .group = "as taken"}},
      .symbols = true};
  for (const AssumptionEffect& each : report.assumptions)
    if (each.matters() && each.evaluation.failure.empty())
      chart.bars.push_back({.label = fmt::format("{}: {}", each.choice.subject, each.choice.otherwise),
                            .value = each.evaluation.objectives.front(),
                            .group = is_feasible(each.evaluation) ? "keeps every limit" : "breaks a limit"});
  return chart;
}

}  // namespace

std::string difference(const Study& study, const Record& from, const Record& to) {
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < from.point.size(); ++i)
    if (from.point[i] != to.point[i])
      changes.push_back(fmt::format("{} {} instead of {}", name_of(study.variables[i]),
                                    value_text(study.variables[i], to.point[i]),
                                    value_text(study.variables[i], from.point[i])));
  return fmt::format("{}", fmt::join(changes, ", "));
}

Section assumptions_section(const formats::SizeReport& report) {
  Section section{.id = "assumptions", .title = "What this answer rests on"};
  if (report.assumptions.empty()) return section;
  std::string text = "Choices and numbers that no measurement of this design has settled, the largest first\n";
  std::vector<std::string_view> small;
  std::vector<std::string> slight;
  for (const std::span<const AssumptionEffect> of_subject : by_subject(std::span(report.assumptions))) {
    if (std::ranges::none_of(of_subject, &AssumptionEffect::matters)) {
      small.push_back(of_subject.front().choice.subject);
      continue;
    }
    if (std::ranges::all_of(of_subject, [&](const AssumptionEffect& each) {
          return !each.matters() || slightly_broken(report.study, each);
        })) {
      for (const AssumptionEffect& each : of_subject)
        if (each.matters()) slight.push_back(slightly_broken(report.study, each).value());
      continue;
    }
    text += subject_text(of_subject.front().choice);
    for (const AssumptionEffect& effect : of_subject) text += effect_text(report, effect);
    const bool peak = of_subject.size() == 2 && !of_subject.front().choice.number.empty() &&
                      std::ranges::all_of(of_subject, [](const AssumptionEffect& each) {
                        return each.gain <= -simulation::change_that_matters;
                      });
    if (peak) text += "    The answer sits on a peak: it is worse to either side.\n";
  }
  if (!slight.empty())
    text += fmt::format("  Limits broken by less than {:.3g} %: {}.\n", 100.0 * simulation::change_that_matters,
                        fmt::join(slight, "; "));
  if (!small.empty())
    text += fmt::format("  By less than {:.3g} % of the objective, and on no limit: {}.\n",
                        100.0 * simulation::change_that_matters, fmt::join(small, ", "));
  const bool searched =
      std::ranges::any_of(report.assumptions, [](const AssumptionEffect& each) { return each.evaluations > 1; });
  if (!searched) text += "Which design would be best under them is not known: with a spread none is searched for.\n";
  if (report.assumptions_left == 0) {
    if (const AssumptionEffect* first = decisive(report.study, *report.result.best, report.assumptions))
      text += fmt::format("Measure first: {}. The {} decides most about this design.\n", first->choice.settled_by,
                          first->choice.subject);
    else
      text += fmt::format(
          "Nothing that a measurement settles changes the objective by more than {:.3g} % or breaks a limit.\n",
          100.0 * gain_of_another_design);
  }
  section.blocks = {choices_chart(report), Lines{std::move(text)}};
  return section;
}

std::string left_out_text(const formats::SizeReport& report) {
  if (!report.result.feasible) return {};
  const bool answer_only = report.study.search.afterwards == Afterwards::nothing;
  std::vector<std::string> left;
  if (report.assumptions_left > 0) left.push_back(fmt::format("{} other choices and numbers", report.assumptions_left));
  // Where the run was not interrupted, there are no steps because nothing can vary.
  if (report.result.sensitivity.steps.empty() && (answer_only || report.result.stop_reason == StopReason::interrupted))
    left.emplace_back("what a step of a variable or a relaxed limit would bring");
  if (report.study.spread && !report.built)
    left.push_back(fmt::format("what {} builds by fresh dice make of this design", formats::builds_of_answer));
  if (left.empty()) return {};
  return fmt::format("Not looked at, as {}: {}.\n",
                     answer_only ? "only the answer was asked for (--answer-only)" : "the run was interrupted",
                     fmt::join(left, "; "));
}

}  // namespace coilwright::report
