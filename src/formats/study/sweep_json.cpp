#include "coilwright/formats/study/sweep_json.hpp"

#include <utility>

#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/formats/study/result_json.hpp"

namespace coilwright::formats {

using text::Json;

namespace {

Json total_json(const sizing::QuantityTotal& total) {
  const auto of_any = [&](double value) { return total.designs == 0 ? Json(nullptr) : text::number_or_null(value); };
  return Json::object({{"designs", total.designs},
                       {"mean", of_any(total.sum.value() / static_cast<double>(total.designs))},
                       {"least", of_any(total.least)},
                       {"greatest", of_any(total.greatest)}});
}

Json totals_json(const SweepReport& report) {
  Json out = Json::object();
  for (std::size_t i = 0; i < report.totals.size(); ++i)
    out.set(report.study.quantities[i].name, total_json(report.totals[i]));
  return out;
}

}  // namespace

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
  if (report.keep != sizing::Keep::all) {
    out.set("kept", sizing::name_of(report.keep));
    out.set("quantities", totals_json(report));
  }
  return out;
}

}  // namespace coilwright::formats
