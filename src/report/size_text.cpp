#include "coilwright/report/size_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/simulation/coil_currents_text.hpp"
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

std::string range_ends_text(const formats::SizeReport& report) {
  std::vector<std::string> names;
  for (const formats::RangeEnd& each : formats::range_ends(report))
    names.push_back(fmt::format("{} ({})", name_of(report.study.variables[each.variable]), each.end));
  return names.empty() ? "" : fmt::format("\nVariables at an end of their range: {}\n", fmt::join(names, ", "));
}

std::string headline(const formats::SizeReport& report) {
  const Study& study = report.study;
  std::string text = fmt::format("{}: {}\n\n", study.name, objective_text(study.objectives.front()));
  if (report.result.search_stop_reason == StopReason::interrupted)
    text += fmt::format("INTERRUPTED after {} evaluations of {}: the search may find better; --resume goes on.\n\n",
                        report.result.search_evaluations, study.search.max_evaluations);
  else if (report.result.stop_reason == StopReason::interrupted)
    text += fmt::format("{}\n\n", interrupted_after_search);
  if (!report.result.best) return text + "No design was evaluated.\n";
  if (report.result.feasible) return text + "Best design";
  return text + "No design that was found keeps every limit. The least infeasible one";
}

// Variables with their value in the actuator that the study starts from, where it has one.
std::string variables_text(const formats::SizeReport& report) {
  const Study& study = report.study;
  TextTable table;
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    table.row({name_of(study.variables[i]), value_text(study.variables[i], report.result.best->point[i])});
  return table.text(2, {left, right});
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
  std::string text;
  if (!best.failure.empty()) {
    text = fmt::format("\nThis design cannot be evaluated: {}\n", best.failure);
  } else {
    text = fmt::format("\n{} {}\n", quantity.name, short_number(best.objectives.front()));
  }
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
std::string parts_text(const formats::SizeReport& report) {
  const auto* evaluated = report.best ? std::get_if<EvaluatedDesign>(report.best) : nullptr;
  if (evaluated == nullptr) return {};
  std::vector<simulation::PartLimit> broken = told(broken_limits(report.study, *evaluated), evaluated->view());
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
  return warning_of_parts(broken, report.study.spread.has_value(), limit_in_study) + opening_text(evaluated->view()) +
         doubts_text(report.study.base);
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

std::string limits_text(const formats::SizeReport& report) {
  const Evaluation& best = report.result.best->evaluation;
  const Study& study = report.study;
  if (study.limits.empty() || !best.failure.empty()) return {};
  TextTable table;
  for (std::size_t i = 0; i < study.limits.size(); ++i) {
    const Limit& limit = study.limits[i];
    const double margin = formats::margin_of(limit, best.constraints[i]);
    std::string remark = margin < 0.0 ? "violated" : "";
    for (const BindingConstraint& binding : report.result.sensitivity.binding) {
      if (binding.name != name_of(limit)) continue;
      remark = binding.at_limit ? "at its limit" : "violated by a step that improves the objective";
    }
    table.row({name_of(limit), short_number(formats::value_behind(limit, best.constraints[i])),
               margin_text(margin, limit.quantity), remark});
  }
  return "\nLimits\n" + table.text(2, {left, right, right, left}) + every_use_text(study);
}

std::string relaxations_text(const formats::SizeReport& report) {
  const Study& study = report.study;
  const std::vector<BindingConstraint>& bindings = report.result.sensitivity.binding;
  // Without steps there is no analysis: the search was interrupted, or nothing can vary.
  if (!report.result.feasible || report.result.sensitivity.steps.empty()) return {};
  if (bindings.empty()) return "\nNo limit binds.\n";
  std::string text = "\nGain if one limit is relaxed\n";
  for (const BindingConstraint& binding : bindings) {
    const Limit& limit = formats::limit_named(study, binding.name);
    const std::string change = binding.objective_change
                                   ? in_unit(*binding.objective_change, study.objectives.front().quantity)
                                   : std::string("no better design found");
    text += fmt::format("  {} relaxed to {}: {}\n", binding.name, short_number(formats::relaxed(limit, binding).value),
                        change);
  }
  return text;
}

std::string steps_text(const formats::SizeReport& report) {
  const std::vector<VariableStep>& steps = report.result.sensitivity.steps;
  if (steps.empty()) return {};
  TextTable table;
  for (const VariableStep& step : steps) {
    const StudyVariable& variable = formats::variable_named(report.study, step.variable);
    const std::string change = step.objective_change
                                   ? in_unit(*step.objective_change, report.study.objectives.front().quantity)
                                   : std::string("-");
    const std::string violated =
        step.violates.empty() ? "" : fmt::format("violates {}", fmt::join(step.violates, ", "));
    const std::string remark = step.objective_change ? violated : fmt::format("{}", fmt::join(step.violates, ", "));
    table.row(
        {step.variable, value_text(variable, step.from) + " -> " + value_text(variable, step.to), change, remark});
  }
  return "\nChange of the objective by one step of one variable\n" + table.text(2, {left, left, right, left});
}

}  // namespace

std::string to_text(const formats::SizeReport& report) {
  const SearchResult& result = report.result;
  std::string text = headline(report);
  if (result.best) {
    text += '\n' + variables_text(report) + objective_lines(report) + parts_text(report) + limits_text(report) +
            (report.built ? '\n' + built_text(*report.built) + shortfalls_of_answer_text(*report.built) : "") +
            relaxations_text(report) + range_ends_text(report) + steps_text(report);
    if (report.best)
      if (const auto* evaluated = std::get_if<EvaluatedDesign>(report.best))
        text += "\nAll quantities of this design\n" + to_text(evaluated->view(), report.study.quantities);
    text += assumptions_text(report) + left_out_text(report);
  }
  text += fmt::format("\nThe search ended because {}. It evaluated {} designs", meaning_of(result.search_stop_reason),
                      result.search_evaluations);
  if (result.sensitivity_evaluations > 0)
    text += fmt::format(", and {} more around the best one", result.sensitivity_evaluations);
  if (const std::size_t others = formats::evaluations_of_choices(report); others > 0)
    text += fmt::format(" ({} further ones under other modelling choices are not counted)", others);
  return text +
         fmt::format(": {}.{}\n", to_text(formats::counts_of(result.archive)),
                     late_gain_text(end_of(result.search_stop_reason, result.archive, result.search_evaluations)));
}

}  // namespace coilwright::report
