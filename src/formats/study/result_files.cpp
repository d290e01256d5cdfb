#include "coilwright/formats/study/result_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <variant>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/formats/study/front_json.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::formats {
namespace {

using sizing::EvaluatedDesign;

// Effects of a program's own are read back by that program alone.
bool has_standard_effects(const actuator::Design& design) {
  return std::ranges::all_of(design.effects, [](const actuator::Effect& effect) {
    return actuator::standard_effects().find(effect.kind->id()) == effect.kind;
  });
}

// The answer is checked where it will be used: the text of actuator.json is read back, evaluated at the operating point
// found, and held against every limit.
void check_written_design(const std::string& text, const sizing::Study& study, const EvaluatedDesign& found) {
  const ActuatorFile file = parse_actuator(text, "actuator.json");
  EvaluatedDesign again = simulation::evaluate(std::get<actuator::Design>(file.content), file.operating_point.value());
  again.settings = found.settings;  // no part of an actuator's file
  for (const sizing::Limit& limit : study.limits) {
    const std::optional<double> value = limit.quantity.value(again.view());
    if (!value || !(margin(limit, *value) >= 0.0))
      throw std::logic_error(
          fmt::format("the design found does not keep {} when it is read back and evaluated again", name_of(limit)));
  }
}

}  // namespace

std::string design_text(const sizing::DesignProblem& problem, std::span<const double> point,
                        const sizing::DesignResult& result, const std::string& name) {
  std::optional<actuator::OperatingPoint> operating;
  if (const auto* evaluated = std::get_if<EvaluatedDesign>(&result)) operating = evaluated->point;
  return to_json(problem.design_at(point), name, operating).text();
}

std::string found_design_text(const sizing::DesignProblem& problem, const sizing::SearchResult& result,
                              const sizing::DesignResult& best) {
  const sizing::Study& study = problem.study();
  std::string text = design_text(problem, result.best.value().point, best,
                                 result.feasible ? study.name : study.name + " (least infeasible)");
  if (result.feasible && has_standard_effects(study.base))
    check_written_design(text, study, std::get<EvaluatedDesign>(best));
  return text;
}

SizeReport size_report(const sizing::DesignProblem& problem, const sizing::SearchResult& result,
                       const sizing::AfterSearch& after) {
  return {.study = problem.study(),
          .result = result,
          .best = after.best ? &*after.best : nullptr,
          .base = after.base,
          .base_seen = after.base_seen,
          .assumptions = after.assumptions,
          .assumptions_left = after.assumptions_left,
          .built = after.built};
}

void write_size(text::OutputFolder& folder, const sizing::DesignProblem& problem, const SizeReport& report,
                const text::Json& summary) {
  folder.write("result.json", to_json(report).set("summary", summary).text());
  write_evaluations(folder.open("evaluations.csv"), problem.study(), report.result.archive.records());
  write_convergence(folder.open("convergence.csv"), report.result.archive);
  if (report.best != nullptr)
    folder.write("actuator.json", found_design_text(problem, report.result, *report.best));
  else
    folder.remove("actuator.json");
}

void write_pareto(text::OutputFolder& folder, const sizing::Study& study, const sizing::ParetoResult& result,
                  std::span<const sizing::BrokenPartLimit> broken, const text::Json& summary) {
  write_front(folder.open("front.csv"), study, result.front);
  write_evaluations(folder.open("evaluations.csv"), study, result.archive.records());
  write_convergence(folder.open("convergence.csv"), result.archive);
  folder.write("result.json", to_json(study, result, broken).set("summary", summary).text());
}

}  // namespace coilwright::formats
