#include "report/design_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "report/design_columns.hpp"
#include "report/text_table.hpp"

namespace coilwright::report {

using namespace text;
using sizing::Evaluation;
using sizing::Limit;
using sizing::Study;

namespace {

struct ValueText {
  std::string operator()(double value) const { return short_number(value); }
  std::string operator()(std::string_view word) const { return std::string(word); }
};

}  // namespace

std::string value_text(const sizing::StudyVariable& variable, double coordinate) {
  return std::visit(ValueText{}, value_at(variable, coordinate));
}

Json value_json(const sizing::StudyVariable& variable, double coordinate) {
  const sizing::VariableValue value = value_at(variable, coordinate);
  const auto* parameter = std::get_if<sizing::ParameterVariable>(&variable);
  if (parameter != nullptr && parameter->parameter->whole)
    return static_cast<std::int64_t>(std::llround(std::get<double>(value)));
  return std::visit([](const auto& each) { return Json(each); }, value);
}

std::vector<std::string> variable_texts(const Study& study, std::span<const double> point) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < point.size(); ++i) out.push_back(value_text(study.variables[i], point[i]));
  return out;
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

std::string objective_text(const sizing::StudyObjective& objective) {
  return fmt::format("{} {}", objective.sense == sizing::Sense::maximise ? "maximise" : "minimise",
                     objective.quantity.name);
}

double value_behind(const Limit& limit, double constraint) {
  const double margin = margin_of(limit, constraint);
  return limit.side == Limit::Side::at_most ? limit.value - margin : limit.value + margin;
}

std::string what_is_in_the_way(const Study& study, const Evaluation& evaluation) {
  if (!evaluation.failure.empty()) return evaluation.failure;
  std::vector<std::pair<double, std::size_t>> broken;
  for (std::size_t i = 0; i < evaluation.constraints.size(); ++i)
    if (evaluation.constraints[i] > 0.0) broken.emplace_back(-evaluation.constraints[i], i);
  std::ranges::sort(broken);
  std::vector<std::string> texts;
  for (const auto& [negative, i] : broken)
    texts.push_back(fmt::format("{} broken by {:.4g} {}", name_of(study.limits[i]),
                                -margin_of(study.limits[i], evaluation.constraints[i]),
                                readable_unit(difference_unit(study.limits[i].quantity.name))));
  for (std::string& text : texts) text.erase(text.find_last_not_of(' ') + 1);
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace coilwright::report
