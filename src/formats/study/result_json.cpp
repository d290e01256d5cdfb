#include "coilwright/formats/study/result_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "coilwright/formats/study/design_tables.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using sizing::Evaluation;
using sizing::Limit;
using sizing::Study;

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
  ArchiveCounts counts{.left_out = archive.excluded(), .usual_failure = usual_failure(archive)};
  const std::vector<std::string>& limits = archive.problem().constraints;
  std::vector<std::size_t> kept(limits.size());
  for (const sizing::Record& record : archive.records()) {
    const std::vector<double>& values = record.evaluation.constraints;
    for (std::size_t i = 0; i < values.size(); ++i) kept[i] += values[i] <= 0.0 ? 1 : 0;
    if (record.proposed_by == "end") ++counts.of_ends;
    if (!record.evaluation.failure.empty())
      ++counts.failed;
    else
      ++(sizing::is_feasible(record.evaluation) ? counts.ok : counts.infeasible);
  }
  if (const auto rarest = std::ranges::min_element(kept); rarest != kept.end()) {
    counts.rarest_limit = limits[static_cast<std::size_t>(rarest - kept.begin())];
    counts.keep_rarest = *rarest;
  }
  return counts;
}

Json to_json(const ArchiveCounts& counts) {
  return Json::object(
      {{"ok", counts.ok}, {"infeasible", counts.infeasible}, {"failed", counts.failed}, {"left_out", counts.left_out}});
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

Json value_json(const sizing::StudyVariable& variable, double coordinate) {
  const sizing::VariableValue value = value_at(variable, coordinate);
  const auto* parameter = std::get_if<sizing::ParameterVariable>(&variable);
  if (parameter != nullptr && parameter->parameter->whole && parameter->parameter->names().empty())
    return static_cast<std::int64_t>(std::llround(std::get<double>(value)));
  return std::visit([](const auto& each) { return Json(each); }, value);
}

Json variables_json(const Study& study, std::span<const double> point) {
  Json out = Json::object();
  for (std::size_t i = 0; i < point.size(); ++i)
    out.set(name_of(study.variables[i]), value_json(study.variables[i], point[i]));
  return out;
}

Json objectives_json(const Study& study, const Evaluation& evaluation) {
  Json out = Json::object();
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    out.set(study.objectives[i].quantity.name,
            evaluation.failure.empty() ? Json(evaluation.objectives[i]) : Json(nullptr));
  return out;
}

Json constraints_json(const Study& study, const Evaluation& evaluation) {
  Json out = Json::array();
  for (std::size_t i = 0; i < study.limits.size(); ++i) {
    const Limit& limit = study.limits[i];
    Json entry = Json::object({{"quantity", limit.quantity.name},
                               {limit.side == Limit::Side::at_most ? "at_most" : "at_least", limit.value}});
    const bool known = evaluation.failure.empty();
    entry.set("value", known ? Json(value_behind(limit, evaluation.constraints[i])) : Json(nullptr));
    entry.set("margin", known ? Json(margin_of(limit, evaluation.constraints[i])) : Json(nullptr));
    out.add(std::move(entry));
  }
  return out;
}

Json design_json(const sizing::Study& study, std::span<const double> point, const Evaluation& evaluation) {
  return Json::object({{"variables", variables_json(study, point)},
                       {"objectives", objectives_json(study, evaluation)},
                       {"constraints", constraints_json(study, evaluation)}});
}

}  // namespace coilwright::formats
