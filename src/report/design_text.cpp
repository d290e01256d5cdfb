#include "report/study_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::report {

using sizing::Evaluation;
using sizing::Study;

namespace {

struct ValueText {
  std::string operator()(double value) const { return short_number(value); }
  std::string operator()(std::string_view word) const { return std::string(word); }
};

std::string lines_of(std::span<const sizing::BrokenPartLimit> broken, bool conditional, std::size_t designs) {
  std::string text;
  for (const sizing::BrokenPartLimit& each : broken)
    if (each.conditional == conditional)
      text += fmt::format("  {}: {} of {} designs: {}\n", each.quantity, each.designs, designs, each.consequence);
  return text;
}

// Those of which the study limits neither the design's own figure nor that of its builds.
std::vector<std::string_view> unlimited(const Study& study, std::span<const sizing::BrokenPartLimit> broken,
                                        bool conditional) {
  std::vector<std::string_view> names;
  for (const sizing::BrokenPartLimit& each : broken)
    if (each.conditional == conditional && std::ranges::none_of(study.limits, [&](const sizing::Limit& limit) {
          return of_one_build(limit).name == each.quantity;
        }))
      names.push_back(each.quantity);
  return names;
}

std::string advice_text(std::string_view beginning, const std::vector<std::string_view>& names) {
  if (names.empty()) return {};
  return fmt::format("{} in the study's \"constraints\", and run it anew: {}; evaluate says what the limits are.\n",
                     beginning, fmt::join(names, ", "));
}

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

std::vector<std::string> cautions_of_parts(const Study& study, std::span<const sizing::BrokenPartLimit> broken,
                                           std::string_view which, std::size_t designs) {
  std::vector<std::string> out;
  if (const std::string lines = lines_of(broken, false, designs); !lines.empty())
    out.push_back(fmt::format("BEWARE: {} break limits of their parts\n{}", which, lines) +
                  advice_text("Limit", unlimited(study, broken, false)));
  if (const std::string lines = lines_of(broken, true, designs); !lines.empty())
    out.push_back(fmt::format("MIND what {} need, or give up\n{}", which, lines) +
                  advice_text("Where that will not do, limit", unlimited(study, broken, true)));
  return out;
}

}  // namespace coilwright::report
