#include "coilwright/formats/study/search_json.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "coilwright/sizing/problem/late_gain.hpp"

namespace coilwright::formats {

using namespace text;

namespace {

struct Reason {
  std::string words{};  // of the first design
  std::size_t designs{};
};

// "gap: must be > 0" of "gap: must be > 0; got -0.1": designs that break one rule by another value have one reason.
std::string without_value(const std::string& failure) {
  return failure.substr(0, failure.find("; got "));
}

std::string usual_failure(const sizing::Archive& archive) {
  std::map<std::string, Reason> reasons;
  for (const sizing::Record& record : archive.records()) {
    if (record.evaluation.failure.empty()) continue;
    Reason& reason = reasons[without_value(record.evaluation.failure)];
    if (reason.designs++ == 0) reason.words = record.evaluation.failure;
  }
  const auto usual = std::ranges::max_element(reasons, {}, [](const auto& each) { return each.second.designs; });
  return usual == reasons.end() ? std::string() : usual->second.words;
}

}  // namespace

ArchiveCounts counts_of(const sizing::Archive& archive) {
  ArchiveCounts counts{.usual_failure = usual_failure(archive)};
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

Json late_gain_json(const sizing::Archive& archive, std::size_t evaluations) {
  return sizing::late_gain(archive, evaluations);
}

Json to_json(std::span<const sizing::BrokenPartLimit> broken) {
  return Json::list(broken, [](const sizing::BrokenPartLimit& each) {
    return Json::object({{"quantity", each.quantity},
                         {"designs", each.designs},
                         {"conditional", each.conditional},
                         {"consequence", each.consequence}});
  });
}

Json objectives_asked(const sizing::Study& study) {
  return Json::list(study.objectives, [](const sizing::StudyObjective& each) {
    return Json::object({{each.sense == sizing::Sense::maximise ? "maximise" : "minimise", each.quantity.name}});
  });
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
