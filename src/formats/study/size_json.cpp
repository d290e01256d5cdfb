#include "coilwright/formats/study/size_json.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/formats/study/result_json.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/sizing/problem/late_gain.hpp"

namespace coilwright::formats {
namespace {

using namespace sizing;
using namespace text;

Json share_json(const Share& share) {
  return Json::object({{"share", share.value}, {"low", share.low}, {"high", share.high}});
}

Json index_json(const std::optional<SobolIndex>& index) {
  if (!index) return {};
  return Json::object({{"value", index->value}, {"low", index->low}, {"high", index->high}});
}

Json built_json(const BuiltQuantity& quantity) {
  Json out = Json::object({{"quantity", quantity.name},
                           {"nominal", quantity.nominal},
                           {"p05", quantity.p05},
                           {"p50", quantity.p50},
                           {"p95", quantity.p95}});
  if (quantity.of_uses) out.set("of_uses", *quantity.of_uses);
  if (!quantity.keeps) return out;
  out.set("limit", quantity.limit);
  out.set("keeps", share_json(*quantity.keeps));
  if (quantity.asked) out.set("asked", *quantity.asked);
  return out;
}

// Its indices by quantity, in their order.
Json worth_json(const ScatterWorth& worth) {
  return Json::object({{"scatter", worth.scatter},
                       {"first", Json::list(worth.first, index_json)},
                       {"total", Json::list(worth.total, index_json)},
                       {"keeps_all_at_half", share_json(worth.keeps_all)}});
}

}  // namespace

const Limit& limit_named(const Study& study, std::string_view name) {
  return *std::ranges::find_if(study.limits, [&](const Limit& each) { return name_of(each) == name; });
}

const StudyVariable& variable_named(const Study& study, std::string_view name) {
  return *std::ranges::find_if(study.variables, [&](const StudyVariable& each) { return name_of(each) == name; });
}

Limit relaxed(const Limit& limit, const BindingConstraint& binding) {
  Limit out = limit;
  const double change = binding.relaxed_by * scale_of(limit);
  out.value += limit.side == Limit::Side::at_most ? change : -change;
  return out;
}

std::vector<RangeEnd> range_ends(const SizeReport& report) {
  std::vector<RangeEnd> ends;
  if (!report.result.best) return ends;
  for (std::size_t i = 0; i < report.study.variables.size(); ++i) {
    const Variable variable = search_variable(report.study.variables[i]);
    if (variable.kind == VariableKind::categorical || variable.lower == variable.upper) continue;
    const double value = report.result.best->point[i];
    const double step = variable.step > 0.0 ? variable.step : (variable.kind == VariableKind::integer ? 1.0 : 0.0);
    // Beyond the last value of a grid there may be less than a step.
    const double near = step > 0.0 ? 0.999 * step : 1e-9 * (variable.upper - variable.lower);
    if (value - variable.lower < near) ends.push_back({i, "lower"});
    if (variable.upper - value < near) ends.push_back({i, "upper"});
  }
  return ends;
}

namespace {

Json binding_json(const Study& study, const BindingConstraint& binding) {
  const Limit& limit = limit_named(study, binding.name);
  Json out = Json::object({{"constraint", binding.name},
                           {"margin", margin_of(limit, -binding.margin)},
                           {"at_limit", binding.at_limit},
                           {"blocks_step", binding.blocks_step},
                           {"relaxed_to", relaxed(limit, binding).value},
                           {"objective_change", binding.objective_change}});
  out.set("relaxed_best", binding.relaxed_best ? variables_json(study, binding.relaxed_best->point) : Json(nullptr));
  return out;
}

Json step_json(const Study& study, const VariableStep& step) {
  const StudyVariable& variable = variable_named(study, step.variable);
  return Json::object({{"variable", step.variable},
                       {"from", value_json(variable, step.from)},
                       {"to", value_json(variable, step.to)},
                       {"objective_change", step.objective_change},
                       {"improves", step.improves},
                       {"violates", Json::list(step.violates)}});
}

Json base_json(const SizeReport& report) {
  if (!report.base_seen.failure.empty()) return Json::object({{"reason", report.base_seen.failure}});
  return Json::object({{"current_A", std::get<EvaluatedDesign>(report.base).point.current},
                       {"objectives", objectives_json(report.study, report.base_seen)},
                       {"constraints", constraints_json(report.study, report.base_seen)}});
}

Json best_json(const SizeReport& report) {
  if (!report.result.best) return nullptr;
  const Record& best = *report.result.best;
  Json out = design_json(report.study, best.point, best.evaluation);
  if (!best.evaluation.failure.empty()) out.set("reason", best.evaluation.failure);
  return out;
}

Json range_ends_json(const SizeReport& report) {
  return Json::list(range_ends(report), [&](const RangeEnd& each) {
    return Json::object({{"variable", name_of(report.study.variables[each.variable])}, {"end", each.end}});
  });
}

Json worst_json(const std::optional<WorstMargin>& worst) {
  if (!worst) return nullptr;
  return Json::object({{"limit", worst->limit}, {"relative_margin", worst->margin}});
}

Json assumption_json(const Study& study, const AssumptionEffect& effect) {
  Json out = to_json(effect.choice);
  out.set("matters", effect.matters());
  const bool evaluated = effect.evaluation.failure.empty();
  out.set("objectives", objectives_json(study, effect.evaluation));
  if (!evaluated) out.set("reason", effect.evaluation.failure);
  out.set("feasible", is_feasible(effect.evaluation)).set("worst_margin", worst_json(effect.worst));
  out.set("changes_design", effect.changes_design);
  out.set("other_best", effect.other_best
                            ? Json::object({{"variables", variables_json(study, effect.other_best->point)},
                                            {"objectives", objectives_json(study, effect.other_best->evaluation)}})
                            : Json(nullptr));
  return out;
}

Json measure_first(const SizeReport& report) {
  // Among those that were not looked at may be a larger one.
  if (!report.result.best || report.assumptions_left > 0) return nullptr;
  const AssumptionEffect* first = decisive(report.study, *report.result.best, report.assumptions);
  return first == nullptr ? Json(nullptr) : Json(first->choice.settled_by);
}

}  // namespace

std::size_t evaluations_of_choices(const SizeReport& report) {
  std::size_t all = 0;
  for (const AssumptionEffect& effect : report.assumptions) all += effect.evaluations;
  return all;
}

Json to_json(const SizeReport& report) {
  const SearchResult& result = report.result;
  Json evaluations = to_json(counts_of(result.archive));
  evaluations.set("search", result.search_evaluations).set("surroundings", result.sensitivity_evaluations);
  evaluations.set("total", result.archive.size()).set("other_choices", evaluations_of_choices(report));
  const auto of_study = [&](auto json) {
    return [&report, json](const auto& each) { return json(report.study, each); };
  };
  const auto* evaluated = report.best ? std::get_if<EvaluatedDesign>(report.best) : nullptr;

  Json out = result_head("size", report.study, result.stop_reason);
  out.set("search_stop_reason", name_of(result.search_stop_reason));
  out.set("evaluations", std::move(evaluations)).set("feasible", result.feasible);
  out.set("late_gain", late_gain(result.archive, result.search_evaluations));
  out.set("best", best_json(report)).set("violated", Json::list(result.violated)).set("base", base_json(report));
  out.set("binding", Json::list(result.sensitivity.binding, of_study(binding_json)))
      .set("at_range_end", range_ends_json(report));
  out.set("steps", Json::list(result.sensitivity.steps, of_study(step_json)));
  out.set("assumptions", Json::list(report.assumptions, of_study(assumption_json)))
      .set("assumptions_left", report.assumptions_left);
  out.set("measure_first", measure_first(report));
  if (report.study.spread) out.set("as_built", report.built ? to_json(*report.built) : Json(nullptr));
  out.set("operating_point", evaluated ? to_json(evaluated->point) : Json(nullptr));
  std::vector<simulation::PartLimit> limits;
  if (evaluated) {
    limits = simulation::told_part_limits(evaluated->view());
    for (simulation::PartLimit& pulses : limits_of_pulses(report.study, *evaluated))
      limits.push_back(std::move(pulses));
  }
  out.set("part_limits", to_json(limits));
  out.set("performance", evaluated ? to_json(evaluated->view(), report.study.quantities) : Json(nullptr));
  return out;
}

Json to_json(const Yield& yield) {
  return Json::object(
      {{"builds", yield.builds},
       {"not_built", yield.not_built},
       {"failures", Json::list(yield.failures,
                               [](const FailureCause& each) {
                                 return Json::object({{"reason", each.reason}, {"builds", each.builds}});
                               })},
       {"keeps_all", share_json(yield.keeps_all)},
       {"quantities", Json::list(yield.quantities, built_json)},
       {"scatters", Json::list(yield.worths, worth_json)}});
}

}  // namespace coilwright::formats
