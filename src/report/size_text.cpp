#include "coilwright/report/size_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/simulation/coil_currents_text.hpp"
#include "coilwright/report/simulation/correction_text.hpp"
#include "coilwright/report/simulation/part_limits_text.hpp"
#include "coilwright/report/simulation/percent.hpp"
#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/report/simulation/shut_joints_text.hpp"
#include "coilwright/report/simulation/text_table.hpp"
#include "coilwright/report/yield_text.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/systems/driver_quantities.hpp"
#include "report/study_parts.hpp"

namespace coilwright::report {
namespace {

using namespace sizing;
using enum TextTable::Align;

std::string in_unit(double change, const simulation::ResultQuantity& quantity) {
  if (change == 0.0) return "no change";
  const std::string unit = readable_unit(formats::difference_unit(quantity));
  return signed_number(change) + (unit.empty() ? "" : " " + unit);
}

std::string margin_text(double margin, const simulation::ResultQuantity& quantity) {
  return margin == 0.0 ? "no margin" : "margin " + in_unit(margin, quantity);
}

// Of a feasible answer: its value, the limit that is nearest, and what to measure first.
std::string answer_sentence(const formats::SizeReport& report) {
  const Study& study = report.study;
  const Record& best = *report.result.best;
  const StudyObjective& objective = study.objectives.front();
  std::string out = fmt::format("The {} {} found is {}", objective.sense == Sense::maximise ? "largest" : "smallest",
                                objective.quantity.name, short_number(best.evaluation.objectives.front()));
  if (const std::optional<WorstMargin> worst = worst_margin(study, best.evaluation))
    out += fmt::format(", with {} kept and {} the tightest ({:.2g} % left)",
                       study.limits.size() == 1 ? "its limit" : fmt::format("all {} limits", study.limits.size()),
                       worst->limit, 100.0 * worst->margin);
  else
    out += ", without any limit";
  const auto is_choice = [](const AssumptionEffect& each) { return each.choice.number.empty(); };
  if (const auto changes = std::ranges::count_if(report.assumptions, &AssumptionEffect::changes_design); changes > 0)
    out += fmt::format("; {} of {} other modelling choices would lead to another design", changes,
                       std::ranges::count_if(report.assumptions, is_choice));
  return out + ".";
}

std::string verdict_of(const formats::SizeReport& report) {
  if (!report.result.best) return "No design was evaluated.";
  if (report.result.feasible) return answer_sentence(report);
  return fmt::format("No design that was found keeps every limit. This is the least infeasible one: {}.",
                     reasons_for_infeasibility(report.study, report.result.best->evaluation));
}

std::vector<std::string> interruption_of(const formats::SizeReport& report) {
  if (report.result.search_stop_reason == StopReason::interrupted)
    return {fmt::format("INTERRUPTED after {} evaluations of {}: the search may find better; --resume goes on.\n",
                        report.result.search_evaluations, report.study.search.max_evaluations)};
  if (report.result.stop_reason == StopReason::interrupted)
    return {"INTERRUPTED when the search was over: what is missing below was not looked at; --resume goes on.\n"};
  return {};
}

// Each with where it lies at an end of its range.
TableBlock variables_table(const formats::SizeReport& report) {
  const Study& study = report.study;
  const std::vector<formats::RangeEnd> ends = formats::range_ends(report);
  TableBlock block{.caption = "Variables of the design",
                   .table = {.header = {"variable", "value", "of its range"}},
                   .align = {left, right, left},
                   .headed = false};
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    const auto end = std::ranges::find(ends, i, &formats::RangeEnd::variable);
    block.table.rows.push_back({name_of(study.variables[i]),
                                value_text(study.variables[i], report.result.best->point[i]),
                                end == ends.end() ? "" : fmt::format("{} end of its range", end->end)});
  }
  return block;
}

// What the pulses of the study's driver add, or those of the usual one to a current that the study takes as steady.
std::string pulses_line(const Study& study, const EvaluatedDesign& best) {
  if (study.driver) {
    const auto text = [&best](const simulation::ResultQuantity& quantity) {
      const std::optional<double> value = quantity.value(best.view());
      return value ? fmt::format("{:.3g}", *value) : std::string("no");
    };
    const std::optional<double> ripple = study.driver->ripple_heat.value(best.view());
    return fmt::format(
        "by its driver, on for {} of a period: the ripple makes {} more heat, of which temperatures and thermal_load "
        "know nothing; {} with it is {}\n",
        text(study.driver->duty), ripple ? percent(0.01 * *ripple) : "no", study.driver->thermal_load.name,
        text(study.driver->thermal_load));
  }
  if (std::holds_alternative<DrivenCurrent>(study.current) || !has_one_current(best.design)) return {};
  const systems::DriverTask usual{.voltage = best.point.supply.voltage.value_or(24.0)};
  const simulation::QuantityTable of_driver(
      systems::driver_quantities([&usual](const simulation::Settings&) { return usual; }));
  const std::optional<double> heat = of_driver.at("driver_ripple_heat_pct").value(best.view());
  constexpr double worth_a_line = 5.0;  // per cent, from which `drive` warns
  if (!heat || *heat < worth_a_line) return {};
  return fmt::format(
      "taken as a steady current: pulses from {} V at {} Hz would make {} more heat (coilwright drive says which do "
      "not; the block \"driver\" of a study limits it)\n",
      short_number(usual.voltage), short_number(usual.frequency), percent(0.01 * *heat));
}

std::string objective_lines(const formats::SizeReport& report) {
  const Evaluation& best = report.result.best->evaluation;
  const simulation::ResultQuantity& quantity = report.study.objectives.front().quantity;
  std::string text = best.failure.empty() ? fmt::format("{} {}\n", quantity.name, short_number(best.objectives.front()))
                                          : fmt::format("This design cannot be evaluated: {}\n", best.failure);
  if (report.best)
    if (const auto* evaluated = std::get_if<EvaluatedDesign>(report.best))
      text += fmt::format("with {}, duty {}\n", coil_currents_text(evaluated->design, evaluated->point.current),
                          short_number(evaluated->point.duty)) +
              pulses_line(report.study, *evaluated);
  if (report.base_seen.failure.empty()) {
    const std::string reasons = reasons_for_infeasibility(report.study, report.base_seen);
    const bool varies = std::ranges::any_of(report.study.variables, [](const StudyVariable& each) {
      return std::holds_alternative<CurrentVariable>(each);
    });
    text += fmt::format("for comparison, the study's own actuator{} with {} A: {}{}\n",
                        varies ? ", at its own best current," : "",
                        short_number(std::get<EvaluatedDesign>(report.base).point.current),
                        short_number(report.base_seen.objectives.front()), reasons.empty() ? "" : " (" + reasons + ")");
  } else {
    text += fmt::format("for comparison, the study's own actuator cannot be evaluated: {}\n", report.base_seen.failure);
  }
  return text;
}

// Of a design that keeps no limit of the study anyway, what the study names is said there.
std::vector<std::string> cautions_of_design(const formats::SizeReport& report, const EvaluatedDesign& design) {
  std::vector<simulation::PartLimit> broken = told(broken_limits(report.study, design), design.view());
  std::erase_if(broken, [&](const simulation::PartLimit& each) {
    return !report.result.feasible && std::ranges::any_of(report.study.limits, [&](const Limit& limit) {
      return of_one_build(limit).name == each.quantity;
    });
  });
  const auto limit_in_study = [&](std::string_view quantity, bool at_most) -> std::optional<double> {
    const auto found = std::ranges::find_if(report.study.limits, [&](const Limit& limit) {
      return limit.quantity.name == quantity && (limit.side == Limit::Side::at_most) == at_most;
    });
    return found == report.study.limits.end() ? std::nullopt : std::optional(found->value);
  };
  std::vector<std::string> out = cautions_of_parts(broken, report.study.spread.has_value(), limit_in_study);
  std::ranges::move(doubts_of(report.study.base), std::back_inserter(out));
  return out;
}

// Which limits a build keeps in all of its uses, by the share of the builds that the study asks for.
std::string every_use_text(const Study& study) {
  if (!study.spread || !has_uses(*study.spread)) return {};
  std::map<int, std::vector<std::string>, std::greater<>> names;
  for (const Limit& limit : study.limits) {
    const std::optional<StatisticName> parts = statistic_named(limit.quantity.name);
    if (!parts || !of_one_build(limit).in_every_use) continue;
    const int percent = parts->statistic.percent;
    names[limit.side == Limit::Side::at_most ? percent : 100 - percent].push_back(limit.quantity.name);
  }
  const double share = share_of_uses(*study.spread);
  std::string text;
  for (const auto& [percent, each] : names)
    text += fmt::format("  {} % of fingers keep this {}: {}\n", percent, uses_text(share), fmt::join(each, ", "));
  return text;
}

Section limits_section(const formats::SizeReport& report) {
  const Evaluation& best = report.result.best->evaluation;
  const Study& study = report.study;
  Section section{.id = "limits", .title = "Limits"};
  if (study.limits.empty() || !best.failure.empty()) return section;
  BarChart chart{.id = "margins",
                 .title = "Margins",
                 .description =
                     "How far each limit is from being reached, in per cent of the limit (of an ordinary magnitude "
                     "where the limit is 0). A bar to the left is a limit that is broken.",
                 .value_title = "margin, %",
                 .label_title = "limit"};
  TableBlock block{.caption = "Limits",
                   .table = {.header = {"limit", "value", "margin", "in the way"}},
                   .align = {left, right, right, left},
                   .headed = false};
  for (std::size_t i = 0; i < study.limits.size(); ++i) {
    const Limit& limit = study.limits[i];
    const double margin = formats::margin_of(limit, best.constraints[i]);
    std::string remark = margin < 0.0 ? "violated" : "";
    for (const BindingConstraint& binding : report.result.sensitivity.binding)
      if (binding.name == name_of(limit))
        remark = binding.at_limit ? "at its limit" : "violated by a step that improves the objective";
    chart.bars.push_back({.label = name_of(limit),
                          .value = -100.0 * best.constraints[i],
                          .group = margin < 0.0     ? "broken"
                                   : remark.empty() ? "kept, not in the way"
                                                    : "kept, in the way"});
    block.table.rows.push_back({name_of(limit), short_number(formats::value_behind(limit, best.constraints[i])),
                                margin_text(margin, limit.quantity), std::move(remark)});
  }
  section.blocks = {std::move(chart), std::move(block)};
  if (std::string uses = every_use_text(study); !uses.empty()) section.blocks.emplace_back(Lines{std::move(uses)});
  return section;
}

Section relaxations_section(const formats::SizeReport& report) {
  const Study& study = report.study;
  Section section{.id = "relaxed", .title = "Gain if one limit is relaxed"};
  // Without steps there is no analysis: the search was interrupted, or nothing can vary.
  if (!report.result.feasible || report.result.sensitivity.steps.empty()) return section;
  std::string text;
  for (const BindingConstraint& binding : report.result.sensitivity.binding) {
    const std::string change = binding.objective_change
                                   ? in_unit(*binding.objective_change, study.objectives.front().quantity)
                                   : std::string("no better design found");
    text +=
        fmt::format("  {} relaxed to {}: {}\n", binding.name,
                    short_number(formats::relaxed(formats::limit_named(study, binding.name), binding).value), change);
    if (const std::string other =
            binding.relaxed_best ? difference(study, *report.result.best, *binding.relaxed_best) : "";
        !other.empty())
      text += fmt::format("    by another design: {}\n", other);
  }
  section.blocks.emplace_back(Lines{text.empty() ? "No limit binds.\n" : std::move(text)});
  return section;
}

Section steps_section(const formats::SizeReport& report) {
  const simulation::ResultQuantity& objective = report.study.objectives.front().quantity;
  BarChart chart{.id = "steps",
                 .title = "One step of one variable",
                 .description = "Change of the objective when one variable moves by one step and all others stay.",
                 .value_title = fmt::format("change of {}", objective.name),
                 .label_title = "step"};
  TableBlock block{.caption = "Steps of the variables",
                   .table = {.header = {"variable", "step", "change", "remark"}},
                   .align = {left, left, right, left},
                   .headed = false};
  for (const VariableStep& step : report.result.sensitivity.steps) {
    const StudyVariable& variable = formats::variable_named(report.study, step.variable);
    const std::string violated = fmt::format("{}", fmt::join(step.violates, ", "));
    const std::string from_to = value_text(variable, step.from) + " -> " + value_text(variable, step.to);
    block.table.rows.push_back({step.variable, from_to,
                                step.objective_change ? in_unit(*step.objective_change, objective) : std::string("-"),
                                step.objective_change && !violated.empty() ? "violates " + violated : violated});
    if (step.objective_change)
      chart.bars.push_back({.label = fmt::format("{} {}", step.variable, from_to),
                            .value = *step.objective_change,
                            .group = !step.improves     ? "worse"
                                     : violated.empty() ? "better"
                                                        : "better, but breaks a limit"});
  }
  Section section{.id = "sensitivity", .title = "Change of the objective by one step of one variable"};
  if (!chart.bars.empty()) section.blocks.emplace_back(std::move(chart));
  if (!block.table.rows.empty()) section.blocks.emplace_back(std::move(block));
  return section;
}

Section search_section(const formats::SizeReport& report) {
  const SearchResult& result = report.result;
  std::string text = fmt::format("The search ended because {}. It evaluated {} designs",
                                 meaning_of(result.search_stop_reason), result.search_evaluations);
  if (result.sensitivity_evaluations > 0)
    text += fmt::format(", and {} more around the best one", result.sensitivity_evaluations);
  if (const std::size_t others = formats::evaluations_of_choices(report); others > 0)
    text += fmt::format(" ({} further ones under other modelling choices are not counted)", others);
  text += fmt::format(": {}.{}\n", to_text(formats::counts_of(result.archive)),
                      late_gain_text(end_of(result.search_stop_reason, result.archive, result.search_evaluations)));
  return {.id = "convergence", .title = "The search", .blocks = {Lines{left_out_text(report) + text}}};
}

}  // namespace

Document document_of(const formats::SizeReport& report) {
  Document out{.title = fmt::format("{}: {}", report.study.name, objective_text(report.study.objectives.front())),
               .verdict = verdict_of(report),
               .cautions = interruption_of(report)};
  const auto* evaluated = report.best ? std::get_if<EvaluatedDesign>(report.best) : nullptr;
  if (report.result.best) {
    if (evaluated != nullptr)
      std::ranges::move(cautions_of_design(report, *evaluated), std::back_inserter(out.cautions));
    out.sections.push_back({.id = "design",
                            .title = report.result.feasible ? "Best design" : "The least infeasible design",
                            .blocks = {variables_table(report), Lines{objective_lines(report)}}});
    out.sections.push_back(limits_section(report));
    if (evaluated != nullptr) out.sections.push_back(opening_section(evaluated->view()));
    if (report.built) {
      std::vector<Section> builds = builds_sections(*report.built);
      builds.front().blocks.emplace_back(
          Lines{"Which scatter decides, and what half of each would bring: coilwright yield STUDY.json actuator.json "
                "--worth 300\n"});
      std::ranges::move(builds, std::back_inserter(out.sections));
      if (std::vector<std::string> shortfalls = shortfalls_of(*report.built); !shortfalls.empty()) {
        shortfalls.back() +=
            "The search judged every design by too few builds for this: more of them (\"draws\" of the study's spread) "
            "are the cure.\n";
        std::ranges::move(shortfalls, std::back_inserter(out.cautions));
      }
    }
    out.sections.push_back(relaxations_section(report));
    out.sections.push_back(steps_section(report));
    if (evaluated != nullptr) out.sections.push_back(quantities_section(evaluated->view(), report.study.quantities));
    out.sections.push_back(assumptions_section(report));
    if (evaluated != nullptr) {
      const simulation::DesignView view = evaluated->view();
      out.sections.push_back(correction_section(
          simulation::correction_reach(view.assembly.model, view.performance.cold, view.point.current)));
    }
  }
  out.sections.push_back(search_section(report));
  return out;
}

}  // namespace coilwright::report
