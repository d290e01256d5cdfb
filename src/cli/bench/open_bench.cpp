#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <new>
#include <utility>
#include <variant>

#include "cli/actuator_input.hpp"
#include "cli/bench/bench.hpp"
#include "cli/bench/diagnosis.hpp"
#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/results/page/page_file.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/number.hpp"

namespace coilwright::cli {
namespace {

using sizing::Study;
using text::Json;

constexpr double current_step = 0.05;  // A

// A bench shows single designs by figures that evaluate has, so what a study asks of builds or of a system is left out.
bool has_figure(const std::string& quantity) {
  return simulation::standard_quantities().find(quantity) != nullptr;
}

Json range_json(const sizing::StudyVariable& variable) {
  Json out = Json::object();
  const auto of = [&](const auto& each) {
    if constexpr (requires { each.range; }) {
      if (const auto* interval = std::get_if<sizing::Interval>(&each.range)) {
        out.set("lower", interval->lower).set("upper", interval->upper);
        if (interval->step > 0.0) out.set("step", interval->step);
        return;
      }
    }
    const std::size_t count = sizing::value_count(variable).value_or(0);
    Json values = Json::array();
    for (std::size_t i = 0; i < count; ++i)
      std::visit([&](const auto& value) { values.add(Json(value)); },
                 sizing::value_at(variable, static_cast<double>(i)));
    out.set("values", std::move(values));
  };
  std::visit(of, variable);
  return out;
}

Json study_json(const Study& study) {
  Json variables = Json::object();
  for (const sizing::StudyVariable& each : study.variables)
    if (!std::holds_alternative<sizing::SettingVariable>(each)) variables.set(sizing::name_of(each), range_json(each));
  Json objectives = Json::array();
  for (const sizing::StudyObjective& each : study.objectives)
    if (const std::string name = sizing::of_one_build(each).name; has_figure(name))
      objectives.add(Json::object({{each.sense == sizing::Sense::maximise ? "maximise" : "minimise", name}}));
  Json limits = Json::array();
  for (const sizing::Limit& each : study.limits)
    if (const std::string name = sizing::of_one_build(each).name; has_figure(name))
      limits.add(Json::object(
          {{"quantity", name}, {each.side == sizing::Limit::Side::at_most ? "at_most" : "at_least", each.value}}));
  return Json::object({{"name", study.name},
                       {"variables", std::move(variables)},
                       {"objectives", std::move(objectives)},
                       {"constraints", std::move(limits)}});
}

bool has(const std::filesystem::path& folder, const char* name) {
  std::error_code none;
  return std::filesystem::is_regular_file(folder / name, none);
}

// What the parts bear for good, to a current that a person would choose.
actuator::OperatingPoint safe_point(const Bench& bench) {
  const auto& design = std::get<actuator::Design>(bench.file.content);
  actuator::OperatingPoint point{.current = current_step};
  const simulation::Performance found = evaluated(bench, {.design = design, .point = point}).performance;
  const double most = std::min({found.free.heat.current_for_good(), found.gripping.heat.current_for_good(),
                                actuator::operating_current_limit(design)});
  point.current = std::max(current_step, std::floor(most / current_step) * current_step);
  return point;
}

// The design that a study starts from, where a folder has no design of its own.
void start_from(Bench& bench, const Study& study) {
  bench.file = {.name = study.name, .content = study.base, .operating_point = study.operating};
  const sizing::DesignResult base = sizing::DesignProblem(study).evaluate_base();
  if (const auto* evaluated = std::get_if<sizing::EvaluatedDesign>(&base))
    bench.file.operating_point = evaluated->point;
}

void open_folder(Bench& bench, const std::filesystem::path& folder) {
  const std::array<const char*, 2> tables{"front.csv", "best.csv"};
  const auto table = std::ranges::find_if(tables, [&](const char* name) { return has(folder, name); });
  if (table == tables.end() && !has(folder, actuator_name))
    throw text::InputError({.file = folder.string(),
                            .rule = "must be an actuator's file, or a folder that size, pareto, sweep or diagnose "
                                    "has written"});
  results::require_as_written(folder, {});
  const results::StudyBehind study = has(folder, results::provenance_name) && !has_diagnosis(folder)
                                         ? results::study_behind(folder)
                                         : results::StudyBehind{};
  if (study.study) bench.further.set("study", study_json(*study.study));
  if (table == tables.end()) {
    bench.file = read_actuator({.file = (folder / actuator_name).string(), .assignments = {}});
    return;
  }
  if (!study.study)
    throw text::InputError(
        {.file = folder.string(),
         .rule = fmt::format("cannot be opened: {}",
                             study.why.empty() ? "it has no provenance.json, which names its study" : study.why)});
  start_from(bench, *study.study);
  const text::CsvTexts rows = text::read_csv_texts(folder / *table, [](std::string_view) { return true; });
  Json designs = Json::object();
  for (const std::string& name : rows.names())
    designs.set(name, Json::list(rows.column(name), [](const std::string& field) -> Json {
                  if (field.empty()) return {};
                  const std::optional<double> number = text::number_in(field);
                  return number ? Json(*number) : Json(field);
                }));
  bench.further.set("designs", std::move(designs));
}

}  // namespace

Bench open_bench(const std::string& named, std::optional<double> current) {
  Bench bench{.shown = named};
  std::error_code none;
  if (std::filesystem::is_directory(named, none))
    open_folder(bench, named);
  else
    bench.file = read_actuator({.file = named, .assignments = {}});
  (void)formats::design_of(bench.file, named, "the bench turns the numbers of a design (actuator/1)");
  if (!bench.file.operating_point && !current) bench.file.operating_point = safe_point(bench);
  bench.file.operating_point =
      formats::operating_point_of(bench.file, {.current = current}, named, "give a current with --current-A");
  (void)evaluated(bench, turned(bench, {}));
  if (has_diagnosis(named)) {
    bench.diagnosis = open_diagnosis(named, std::get<actuator::Design>(bench.file.content));
    bench.further.set("diagnosis", diagnosis_json(named, *bench.diagnosis));
  }
  if (!std::filesystem::is_directory(named, none)) return bench;
  if (const std::string why = results::why_unchecked(named); !why.empty())
    std::cerr << fmt::format("coilwright: {}\n", why);
  return bench;
}

simulation::EvaluatedDesign evaluated(const Bench& bench, const Turned& turned) {
  try {
    return simulation::evaluate(turned.design, turned.point);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& reason) {
    throw text::InputError({.file = bench.shown, .rule = reason.what()});
  }
}

}  // namespace coilwright::cli
