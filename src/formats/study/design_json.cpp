#include "coilwright/formats/study/design_json.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "coilwright/formats/study/design_columns.hpp"

namespace coilwright::formats {

using namespace text;
using sizing::Evaluation;
using sizing::Limit;
using sizing::Study;

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

}  // namespace coilwright::formats
