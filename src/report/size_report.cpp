#include "coilwright/report/size_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "coilwright/report/performance_report.hpp"
#include "report/archive_counts.hpp"
#include "report/design_columns.hpp"
#include "report/design_text.hpp"
#include "report/text_table.hpp"

namespace coilwright::report {
namespace {

using namespace text;
using namespace sizing;

template <class List, class Name>
std::size_t place_of(const List& list, const Name& name) {
  const auto found = std::ranges::find_if(list, [&](const auto& each) { return name_of(each) == name; });
  return static_cast<std::size_t>(found - list.begin());
}

// A limit as the search relaxed it.
Limit relaxed(const Limit& limit, const BindingConstraint& binding) {
  Limit out = limit;
  const double change = binding.relaxed_by * scale_of(limit);
  out.value += limit.side == Limit::Side::at_most ? change : -change;
  return out;
}

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json binding_json(const Study& study, const BindingConstraint& binding) {
  const Limit& limit = study.limits[place_of(study.limits, binding.name)];
  Json out = Json::object({{"constraint", binding.name},
                           {"margin", margin_of(limit, -binding.margin)},
                           {"at_limit", binding.at_limit},
                           {"blocks_step", binding.blocks_step},
                           {"relaxed_to", relaxed(limit, binding).value},
                           {"objective_change", number_or_null(binding.objective_change)}});
  out.set("relaxed_best", binding.relaxed_best ? variables_json(study, binding.relaxed_best->point) : Json(nullptr));
  return out;
}

Json step_json(const Study& study, const VariableStep& step) {
  const StudyVariable& variable = study.variables[place_of(study.variables, step.variable)];
  Json violates = Json::array();
  for (const std::string& name : step.violates) violates.add(name);
  return Json::object({{"variable", step.variable},
                       {"from", value_json(variable, step.from)},
                       {"to", value_json(variable, step.to)},
                       {"objective_change", number_or_null(step.objective_change)},
                       {"improves", step.improves},
                       {"violates", std::move(violates)}});
}

Json operating_json(const simulation::OperatingPoint& point) {
  return Json::object({{"current_A", point.current}, {"duty", point.duty}});
}

Json base_json(const SizeAnswer& answer) {
  if (!answer.base_seen.failure.empty()) return Json::object({{"reason", answer.base_seen.failure}});
  return Json::object({{"current_A", std::get<EvaluatedDesign>(answer.base).point.current},
                       {"objectives", objectives_json(answer.study, answer.base_seen)},
                       {"constraints", constraints_json(answer.study, answer.base_seen)}});
}

Json best_json(const SizeAnswer& answer) {
  if (!answer.result.best) return nullptr;
  const Record& best = *answer.result.best;
  Json out = Json::object({{"variables", variables_json(answer.study, best.point)},
                           {"objectives", objectives_json(answer.study, best.evaluation)},
                           {"constraints", constraints_json(answer.study, best.evaluation)}});
  if (!best.evaluation.failure.empty()) out.set("reason", best.evaluation.failure);
  return out;
}

std::string in_unit(double change, const simulation::ResultQuantity& quantity) {
  if (change == 0.0) return "no change";
  const std::string unit = readable_unit(difference_unit(quantity.name));
  return signed_number(change) + (unit.empty() ? "" : " " + unit);
}

std::string margin_text(double margin, const simulation::ResultQuantity& quantity) {
  return margin == 0.0 ? "no margin" : "margin " + in_unit(margin, quantity);
}

// Variables that could not go further whatever they would bring.
struct RangeEnd {
  std::size_t variable;
  std::string_view end;
};

std::vector<RangeEnd> range_ends(const SizeAnswer& answer) {
  std::vector<RangeEnd> ends;
  if (!answer.result.best) return ends;
  for (std::size_t i = 0; i < answer.study.variables.size(); ++i) {
    const Variable variable = search_variable(answer.study.variables[i]);
    if (variable.kind == VariableKind::categorical || variable.lower == variable.upper) continue;
    const double value = answer.result.best->point[i];
    const double step = variable.step > 0.0 ? variable.step : (variable.kind == VariableKind::integer ? 1.0 : 0.0);
    // Beyond the last value of a grid there may be less than a step.
    const double near = step > 0.0 ? 0.999 * step : 1e-9 * (variable.upper - variable.lower);
    if (value - variable.lower < near) ends.push_back({i, "lower"});
    if (variable.upper - value < near) ends.push_back({i, "upper"});
  }
  return ends;
}

Json range_ends_json(const SizeAnswer& answer) {
  Json out = Json::array();
  for (const RangeEnd& each : range_ends(answer))
    out.add(Json::object({{"variable", name_of(answer.study.variables[each.variable])}, {"end", each.end}}));
  return out;
}

std::string range_ends_text(const SizeAnswer& answer) {
  std::vector<std::string> names;
  for (const RangeEnd& each : range_ends(answer))
    names.push_back(fmt::format("{} ({})", name_of(answer.study.variables[each.variable]), each.end));
  return names.empty() ? "" : fmt::format("\nAt the end of its range: {}\n", fmt::join(names, ", "));
}

std::string headline(const SizeAnswer& answer) {
  const Study& study = answer.study;
  std::string text = fmt::format("{}: {}\n\n", study.name, objective_text(study.objectives.front()));
  if (!answer.result.best) return text + "Nothing was evaluated.\n";
  if (answer.result.feasible) return text + "Best design";
  return text + "No design found keeps every limit. The least infeasible one";
}

// Variables with their value in the actuator that the study starts from, where it has one.
std::string variables_text(const SizeAnswer& answer) {
  const Study& study = answer.study;
  TextTable table;
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    table.row({name_of(study.variables[i]), value_text(study.variables[i], answer.result.best->point[i])});
  return table.text(2, {TextTable::Align::left, TextTable::Align::right});
}

std::string objective_lines(const SizeAnswer& answer) {
  const Evaluation& best = answer.result.best->evaluation;
  const simulation::ResultQuantity& quantity = answer.study.objectives.front().quantity;
  std::string text;
  if (!best.failure.empty()) {
    text = fmt::format("\nIt cannot be evaluated: {}\n", best.failure);
  } else {
    text = fmt::format("\n{} {}\n", quantity.name, short_number(best.objectives.front()));
  }
  if (answer.best)
    if (const auto* evaluated = std::get_if<EvaluatedDesign>(answer.best))
      text += fmt::format("at {} A in every coil, duty {}\n", short_number(evaluated->point.current),
                          short_number(evaluated->point.duty));
  if (answer.base_seen.failure.empty()) {
    const std::string in_the_way = what_is_in_the_way(answer.study, answer.base_seen);
    text += fmt::format(
        "the actuator as given, at {} A: {}{}\n", short_number(std::get<EvaluatedDesign>(answer.base).point.current),
        short_number(answer.base_seen.objectives.front()), in_the_way.empty() ? "" : " (" + in_the_way + ")");
  } else {
    text += fmt::format("the actuator as given: none ({})\n", answer.base_seen.failure);
  }
  return text;
}

std::string limits_text(const SizeAnswer& answer) {
  const Evaluation& best = answer.result.best->evaluation;
  const Study& study = answer.study;
  if (study.limits.empty() || !best.failure.empty()) return {};
  TextTable table;
  for (std::size_t i = 0; i < study.limits.size(); ++i) {
    const Limit& limit = study.limits[i];
    const double margin = margin_of(limit, best.constraints[i]);
    std::string remark = margin < 0.0 ? "broken" : "";
    for (const BindingConstraint& binding : answer.result.sensitivity.binding) {
      if (binding.name != name_of(limit)) continue;
      remark = binding.at_limit ? "at its limit" : "stops a better step";
    }
    table.row({name_of(limit), short_number(value_behind(limit, best.constraints[i])),
               margin_text(margin, limit.quantity), remark});
  }
  return "\nLimits\n" + table.text(2, {TextTable::Align::left, TextTable::Align::right, TextTable::Align::right,
                                       TextTable::Align::left});
}

std::string relaxations_text(const SizeAnswer& answer) {
  const Study& study = answer.study;
  const std::vector<BindingConstraint>& bindings = answer.result.sensitivity.binding;
  // Without steps the surroundings were not looked at: interrupted, or nothing can vary.
  if (!answer.result.feasible || answer.result.sensitivity.steps.empty()) return {};
  if (bindings.empty()) return "\nNo limit binds.\n";
  std::string text = "\nWhat a limit costs\n";
  for (const BindingConstraint& binding : bindings) {
    const Limit& limit = study.limits[place_of(study.limits, binding.name)];
    const std::string change = binding.objective_change
                                   ? in_unit(*binding.objective_change, study.objectives.front().quantity)
                                   : std::string("nothing better found");
    text += fmt::format("  {} relaxed to {}: {}\n", binding.name, short_number(relaxed(limit, binding).value), change);
  }
  return text;
}

std::string steps_text(const SizeAnswer& answer) {
  const std::vector<VariableStep>& steps = answer.result.sensitivity.steps;
  if (steps.empty()) return {};
  TextTable table;
  for (const VariableStep& step : steps) {
    const StudyVariable& variable = answer.study.variables[place_of(answer.study.variables, step.variable)];
    const std::string change = step.objective_change
                                   ? in_unit(*step.objective_change, answer.study.objectives.front().quantity)
                                   : std::string("-");
    const std::string broken = step.violates.empty() ? "" : fmt::format("breaks {}", fmt::join(step.violates, ", "));
    const std::string remark = step.objective_change ? broken : fmt::format("{}", fmt::join(step.violates, ", "));
    table.row(
        {step.variable, value_text(variable, step.from) + " -> " + value_text(variable, step.to), change, remark});
  }
  return "\nWhat one step does\n" + table.text(2, {TextTable::Align::left, TextTable::Align::left,
                                                   TextTable::Align::right, TextTable::Align::left});
}

}  // namespace

Json to_json(const SizeAnswer& answer) {
  const SearchResult& result = answer.result;
  Json evaluations = to_json(counts_of(result.archive));
  evaluations.set("search", result.search_evaluations).set("surroundings", result.sensitivity_evaluations);
  evaluations.set("total", result.archive.size());
  Json violated = Json::array();
  for (const std::string& name : result.violated) violated.add(name);
  Json binding = Json::array();
  for (const BindingConstraint& each : result.sensitivity.binding) binding.add(binding_json(answer.study, each));
  Json steps = Json::array();
  for (const VariableStep& each : result.sensitivity.steps) steps.add(step_json(answer.study, each));
  const auto* evaluated = answer.best ? std::get_if<EvaluatedDesign>(answer.best) : nullptr;

  Json out = result_head("size", answer.study, result.stop_reason);
  out.set("evaluations", std::move(evaluations)).set("feasible", result.feasible);
  out.set("best", best_json(answer)).set("violated", std::move(violated)).set("base", base_json(answer));
  out.set("binding", std::move(binding)).set("at_range_end", range_ends_json(answer));
  out.set("steps", std::move(steps));
  out.set("operating_point", evaluated ? operating_json(evaluated->point) : Json(nullptr));
  out.set("performance", evaluated ? to_json(evaluated->view(), answer.study.quantities) : Json(nullptr));
  return out;
}

std::string to_text(const SizeAnswer& answer) {
  const SearchResult& result = answer.result;
  std::string text = headline(answer);
  if (result.best) {
    text += '\n' + variables_text(answer) + objective_lines(answer) + limits_text(answer) + relaxations_text(answer) +
            range_ends_text(answer) + steps_text(answer);
    if (answer.best)
      if (const auto* evaluated = std::get_if<EvaluatedDesign>(answer.best))
        text += "\nAll of it\n" + to_text(evaluated->view(), answer.study.quantities);
  }
  text +=
      fmt::format("\nStopped because {}: {} evaluations", meaning_of(result.stop_reason), result.search_evaluations);
  if (result.sensitivity_evaluations > 0)
    text += fmt::format(" and {} around the answer", result.sensitivity_evaluations);
  return text + fmt::format("; {}.\n", to_text(counts_of(result.archive)));
}

}  // namespace coilwright::report
