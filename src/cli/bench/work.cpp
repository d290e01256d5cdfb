#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "cli/bench/answers.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/study/result_files.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/formats/study/study_of_one.hpp"
#include "coilwright/report/size_text.hpp"
#include "coilwright/report/yield_text.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/search/sensitivity.hpp"
#include "coilwright/sizing/study/after_search.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/input_text.hpp"

namespace coilwright::cli {
namespace {

using sizing::Study;
using text::Json;

constexpr std::size_t evaluations_of_search = 300;
constexpr std::size_t evaluations_of_limit = 60;  // for each limit that is relaxed
constexpr std::size_t builds_of_yield = 1000;
constexpr const char* study_name = "study.json";

// One core stays free for the sliders.
unsigned threads_of_work() {
  return std::max(2U, std::thread::hardware_concurrency()) - 1;
}

Study study_of(const Bench& bench, const Question& question, std::size_t evaluations, bool spread) {
  const text::InputText actuator{.file = "actuator.json", .text = actuator_text(bench, question.design)};
  return formats::parse_study(study_text(bench, question, evaluations, spread), study_name, {.actuator = &actuator});
}

// The changes that lead to a design of a study, as of --set.
Json changes_at(const Study& study, std::span<const double> point) {
  Json out = Json::array();
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    out.add(std::visit([&](const auto& value) { return fmt::format("{}={}", name_of(study.variables[i]), value); },
                       value_at(study.variables[i], point[i])));
  return out;
}

// The question's design among those of its study: each variable at its value, or the nearest that it may have.
std::vector<double> point_of(const Study& study, const Turned& design) {
  const Json values = knob_values(design);
  std::vector<double> out;
  for (const sizing::StudyVariable& variable : study.variables) {
    const auto& all = std::get<Json::Object>(values.content());
    const auto found = std::ranges::find(all, sizing::name_of(variable), &Json::Member::first);
    if (found == all.end())
      throw text::InputError({.file = study_name,
                              .place = "/variables/" + sizing::name_of(variable),
                              .rule = "must be a number of this design"});
    const Json::Content& value = found->second.content();
    const auto* word = std::get_if<std::string>(&value);
    const auto* whole = std::get_if<std::int64_t>(&value);
    const std::optional<double> at = nearest_coordinate(variable, word != nullptr    ? sizing::VariableValue(*word)
                                                                  : whole != nullptr ? static_cast<double>(*whole)
                                                                                     : std::get<double>(value));
    out.push_back(at.value_or(0.0));
  }
  return out;
}

// The best of a search from the design or, without one, the design with what is around it.
sizing::SearchResult found_from(const sizing::DesignProblem& problem, const std::vector<double>& point,
                                const sizing::SearchOptions& how, bool searches) {
  if (searches) return sizing::search(problem.problem(), how);
  sizing::SearchResult out{.search_evaluations = 1, .archive = sizing::Archive(problem.problem())};
  const sizing::Evaluation seen = out.archive.evaluate(point);
  out.archive.number(point);
  out.best = out.archive.records().front();
  out.feasible = sizing::is_feasible(seen);
  if (out.feasible)
    out.sensitivity =
        analyse_sensitivity(out.archive, *out.best, {.relaxed_evaluations = evaluations_of_limit, .search = how});
  else
    out.violated = sizing::violated_by(problem.problem(), seen);
  out.sensitivity_evaluations = out.archive.size() - 1;
  return out;
}

LongWork::Work search_work(Study study, const Turned& design, bool searches) {
  const std::vector<double> point = point_of(study, design);
  study.starts = {point};
  study.search.afterwards = sizing::Afterwards::nothing;  // builds and other modelling choices are no part of it
  return [study = std::move(study), point, searches](const std::stop_token& stop, LongWork::Progress& progress) {
    const sizing::DesignProblem problem(study);
    sizing::SearchOptions how = study.search;
    how.threads = threads_of_work();
    how.stop = stop;
    if (searches) progress.of = how.max_evaluations;
    how.progress = [&progress](const sizing::Progress& now) { progress.done = now.evaluations; };
    const sizing::SearchResult result = found_from(problem, point, how, searches);
    const sizing::AfterSearch after = sizing::after_search(problem, result, {.stop = stop});
    report::Document said = report::document_of(formats::size_report(problem, result, after));
    std::erase_if(said.sections,
                  [](const report::Section& each) { return each.id == "quantities" || each.id == "convergence"; });
    Json out = Json::object({{"html", report::to_html(said)}, {"feasible", result.feasible}});
    if (searches && result.best) out.set("changes", changes_at(study, result.best->point));
    return out;
  };
}

LongWork::Work yield_work(const Bench& bench, const Question& question) {
  Study study =
      formats::study_of_one(study_of(bench, question, 1, true), study_name,
                            {.option = "current_A", .actuator = "actuator.json", .of_file = question.design.point});
  return [study = std::move(study)](const std::stop_token& stop, LongWork::Progress& progress) {
    const sizing::DesignResult base = sizing::DesignProblem(study).evaluate_base();
    if (const auto* none = std::get_if<sizing::NotEvaluated>(&base)) throw std::runtime_error(none->reason);
    const auto yield = sizing::yield_of(study, std::get<sizing::EvaluatedDesign>(base),
                                        {.builds = builds_of_yield,
                                         .threads = threads_of_work(),
                                         .stop = stop,
                                         .progress = [&progress](std::size_t done, std::size_t of) {
                                           progress.done = done;
                                           progress.of = of;
                                         }});
    if (!yield) throw std::runtime_error("stopped before a build was made");
    return Json::object({{"html", report::to_html(report::document_of(*yield))}});
  };
}

}  // namespace

std::string study_text(const Bench& bench, const Question& question, std::size_t evaluations, bool spread) {
  Json point = formats::to_json(question.design.point);
  Json study = question.study;
  const auto parts = std::get<Json::Object>(study.content());
  const auto variables = std::ranges::find(parts, "variables", &Json::Member::first);
  if (variables != parts.end())
    if (const auto* names = std::get_if<Json::Object>(&variables->second.content()))
      if (std::ranges::find(*names, "current_A", &Json::Member::first) != names->end())
        std::erase_if(std::get<Json::Object>(point.content()),
                      [](const auto& each) { return each.first == "current_A"; });
  Json out = Json::object({{"format", "study/1"},
                           {"name", bench.file.name.empty() ? "bench" : bench.file.name},
                           {"actuator", "actuator.json"},
                           {"operating_point", std::move(point)}});
  if (spread) out.set("spread", Json::object({{"parts", "usual"}}));
  for (const Json::Member& part : parts) out.set(part);
  out.set("search", Json::object({{"max_evaluations", evaluations}, {"seed", 1}}));
  return out.text();
}

LongWork::Work work_of(const Bench& bench, const Question& question, const std::string& kind) {
  const auto study = [&](std::size_t evaluations) {
    Study out = study_of(bench, question, evaluations, false);
    formats::require_objectives(out, formats::objectives_of_size, study_name);
    return out;
  };
  if (kind == "search") return search_work(study(evaluations_of_search), question.design, true);
  if (kind == "limits") return search_work(study(1), question.design, false);
  return yield_work(bench, question);
}

}  // namespace coilwright::cli
