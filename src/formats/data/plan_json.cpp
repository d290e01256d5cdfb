#include "coilwright/formats/data/plan_json.hpp"

#include <string_view>
#include <utility>

#include "coilwright/formats/data/experiment_writer.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement::experiment;
using actuator::Effect;

Json parameters_json(const Effect& effect) {
  Json out = Json::object();
  for (std::size_t i = 0; i < effect.values.size(); ++i) {
    const std::string_view key = effect.kind->parameters()[i].key;
    out.set(std::string(key), units::from_memory(effect.values[i], key));
  }
  return out;
}

Json effect_json(const VisibleEffect& effect) {
  Json out =
      Json::object({{"id", effect.effect.kind->id()},
                    {"visible", effect.visible},
                    {"strength", effect.main ? Json(effect.effect.kind->parameters()[*effect.main].key) : Json()},
                    {effect.visible ? "smallest" : "strongest_tried", parameters_json(effect.effect)},
                    {"change_over_limit", effect.over_limit}});
  if (!effect.visible) out.set("remark", effect.remark);
  return out;
}

Json added_run_json(const AddedRun& run) {
  return Json::object({{"kind", run.kind},
                       {"input", run.input},
                       {"why", run.why},
                       {"smallest_strengths_ratio", run.lowering},
                       {"newly_visible", run.newly_visible},
                       {"separated_pairs", run.separated_pairs},
                       {"run", run_json(run.run)}});
}

}  // namespace

Json to_json(const PlanReport& report) {
  const ExperimentPlan& plan = report.plan;
  Json effects = Json::array();
  for (const VisibleEffect& effect : plan.effects) effects.add(effect_json(effect));
  Json left_out = Json::array();
  for (const LeftOutEffect& effect : plan.left_out)
    left_out.add(Json::object({{"id", effect.kind->id()}, {"reason", effect.reason}}));
  Json pairs = Json::array();
  for (const InseparablePair& pair : plan.pairs)
    pairs.add(Json::object({{"effects", Json::array({plan.effects[pair.first].effect.kind->id(),
                                                     plan.effects[pair.second].effect.kind->id()})},
                            {"cosine", pair.cosine},
                            {"difference_over_limit", pair.over_limit}}));
  Json added = Json::array();
  for (const AddedRun& run : plan.added_runs) added.add(added_run_json(run));
  Json exact = Json::array();
  for (const std::string& name : plan.held_exact) exact.add(name);
  return Json::object({{"format", "experiment-plan/1"},
                       {"experiment", report.experiment},
                       {"actuator", report.actuator},
                       {"samples", plan.samples},
                       {"overdispersion", plan.overdispersion},
                       {"effects", std::move(effects)},
                       {"left_out", std::move(left_out)},
                       {"inseparable_pairs", std::move(pairs)},
                       {"added_runs", std::move(added)},
                       {"held_exact", std::move(exact)},
                       {"simulated_runs", plan.simulated_runs}});
}

}  // namespace coilwright::formats
