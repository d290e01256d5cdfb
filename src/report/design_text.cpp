#include "report/design_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/text_table.hpp"

namespace coilwright::report {

using sizing::Evaluation;
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

std::vector<std::string> variable_texts(const Study& study, std::span<const double> point) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < point.size(); ++i) out.push_back(value_text(study.variables[i], point[i]));
  return out;
}

std::string objective_text(const sizing::StudyObjective& objective) {
  return fmt::format("{} {}", objective.sense == sizing::Sense::maximise ? "maximise" : "minimise",
                     objective.quantity.name);
}

std::string reasons_for_infeasibility(const Study& study, const Evaluation& evaluation) {
  if (!evaluation.failure.empty()) return evaluation.failure;
  std::vector<std::pair<double, std::size_t>> violated;
  for (std::size_t i = 0; i < evaluation.constraints.size(); ++i)
    if (evaluation.constraints[i] > 0.0) violated.emplace_back(-evaluation.constraints[i], i);
  std::ranges::sort(violated);
  std::vector<std::string> texts;
  for (const auto& [negative, i] : violated)
    texts.push_back(fmt::format("{} violated by {:.4g} {}", name_of(study.limits[i]),
                                -formats::margin_of(study.limits[i], evaluation.constraints[i]),
                                readable_unit(formats::difference_unit(study.limits[i].quantity))));
  for (std::string& text : texts) text.erase(text.find_last_not_of(' ') + 1);
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace coilwright::report
