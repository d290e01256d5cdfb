#include "coilwright/formats/study/sweep_json.hpp"

#include <utility>

#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/formats/study/result_json.hpp"

namespace coilwright::formats {

using text::Json;

Json to_json(const SweepReport& report) {
  Json best = Json::list(report.leaders, [&](const sizing::Leader& leader) {
    const sizing::Evaluation& evaluation = leader.design.evaluation;
    Json entry = Json::object({{"best_for", report.study.objectives[leader.objective].quantity.name},
                               {"status", status_of(evaluation)},
                               {"variables", variables_json(report.study, leader.design.point)},
                               {"objectives", objectives_json(report.study, evaluation)},
                               {"constraints", constraints_json(report.study, evaluation)}});
    if (!evaluation.failure.empty()) entry.set("reason", evaluation.failure);
    return entry;
  });
  Json out = Json::object({{"command", "sweep"},
                           {"study", report.study.name},
                           {"objectives", objectives_asked(report.study)},
                           {"designs", report.designs},
                           {"evaluated", report.evaluated},
                           {"ok", report.ok},
                           {"best", std::move(best)},
                           {"broken_part_limits", to_json(report.broken)}});
  if (const auto& sample = report.sample)
    out.set("sample",
            Json::object(
                {{"sampling", sizing::name_of(sample->sampling)}, {"drawn", sample->drawn}, {"seed", sample->seed}}));
  return out;
}

}  // namespace coilwright::formats
