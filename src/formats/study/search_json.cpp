#include "coilwright/formats/study/search_json.hpp"

namespace coilwright::formats {

using namespace text;

ArchiveCounts counts_of(const sizing::Archive& archive) {
  ArchiveCounts counts;
  for (const sizing::Record& record : archive.records()) {
    if (!record.evaluation.failure.empty())
      ++counts.failed;
    else
      ++(sizing::is_feasible(record.evaluation) ? counts.ok : counts.infeasible);
  }
  return counts;
}

Json to_json(const ArchiveCounts& counts) {
  return Json::object({{"ok", counts.ok}, {"infeasible", counts.infeasible}, {"failed", counts.failed}});
}

Json to_json(std::span<const sizing::BrokenPartLimit> broken) {
  Json out = Json::array();
  for (const sizing::BrokenPartLimit& each : broken)
    out.add(Json::object({{"quantity", each.quantity},
                          {"designs", each.designs},
                          {"conditional", each.conditional},
                          {"consequence", each.consequence}}));
  return out;
}

Json objectives_asked(const sizing::Study& study) {
  Json objectives = Json::array();
  for (const sizing::StudyObjective& objective : study.objectives)
    objectives.add(Json::object(
        {{objective.sense == sizing::Sense::maximise ? "maximise" : "minimise", objective.quantity.name}}));
  return objectives;
}

Json result_head(std::string_view command, const sizing::Study& study, sizing::StopReason reason) {
  return Json::object({{"command", command},
                       {"study", study.name},
                       {"objectives", objectives_asked(study)},
                       {"algorithm", sizing::name_of(study.search.algorithm)},
                       {"seed", static_cast<std::int64_t>(study.search.seed)},
                       {"max_evaluations", study.search.max_evaluations},
                       {"stop_reason", sizing::name_of(reason)}});
}

}  // namespace coilwright::formats
