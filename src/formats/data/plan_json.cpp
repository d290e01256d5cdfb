#include "coilwright/formats/data/plan_json.hpp"

#include <string_view>
#include <utility>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/data/experiment_file.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement::planning;
using actuator::Effect;

Json visible_effect_json(const VisibleEffect& effect) {
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
  Json left_out = Json::list(plan.left_out, [](const LeftOutEffect& effect) {
    return Json::object({{"id", effect.kind->id()}, {"reason", effect.reason}});
  });
  Json pairs = Json::list(plan.pairs, [&](const InseparablePair& pair) {
    return Json::object({{"effects", Json::array({plan.effects[pair.first].effect.kind->id(),
                                                  plan.effects[pair.second].effect.kind->id()})},
                         {"cosine", pair.cosine},
                         {"difference_over_limit", pair.over_limit}});
  });
  return Json::object({{"format", "experiment-plan/1"},
                       {"experiment", report.experiment},
                       {"actuator", report.actuator},
                       {"samples", plan.samples},
                       {"overdispersion", plan.overdispersion},
                       {"effects", Json::list(plan.effects, visible_effect_json)},
                       {"left_out", std::move(left_out)},
                       {"inseparable_pairs", std::move(pairs)},
                       {"added_runs", Json::list(plan.added_runs, added_run_json)},
                       {"held_exact", Json::list(plan.held_exact)},
                       {"simulated_runs", plan.simulated_runs}});
}

}  // namespace coilwright::formats
