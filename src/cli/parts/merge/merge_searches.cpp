#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iostream>

#include "cli/parts/merge/parts.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/search/archive/opened_archive.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/formats/study/result_json.hpp"
#include "coilwright/sizing/problem/front.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

constexpr const char* seeds_name = "seeds.json";

// A design of a search and the seed that found it.
struct FoundDesign {
  std::size_t search{};  // from 0
  sizing::Record record{};
};

std::vector<formats::SearchPart> searches_of(const Parts& parts) {
  std::vector<formats::SearchPart> out;
  for_each_part(
      parts, [&](std::size_t, const PartFolder& part) { out.push_back(results_of(part, formats::read_search_part)); });
  return out;
}

std::vector<FoundDesign> feasible_of(const std::vector<formats::SearchPart>& searches) {
  std::vector<FoundDesign> out;
  for (std::size_t i = 0; i < searches.size(); ++i)
    for (const sizing::SweptDesign& design : searches[i].found)
      if (searches[i].is_feasible())
        out.push_back({.search = i, .record = {.point = design.point, .evaluation = design.evaluation}});
  return out;
}

// As Archive::front() sorts one. Of equal designs the one of the first seed.
std::vector<FoundDesign> front_of_fronts(const sizing::Problem& problem, const std::vector<FoundDesign>& all) {
  std::vector<std::pair<sizing::Objectives, FoundDesign>> sorted;
  for (const FoundDesign& each : all) sorted.emplace_back(sizing::minimised(problem, each.record.evaluation), each);
  std::ranges::stable_sort(sorted, {}, [](const auto& each) { return std::tie(each.first, each.second.record.point); });
  std::vector<sizing::Objectives> objectives;
  for (const auto& [values, design] : sorted) objectives.push_back(values);
  std::vector<FoundDesign> out;
  for (const std::size_t i : sizing::non_dominated(objectives)) out.push_back(sorted[i].second);
  return out;
}

// The searches of all seeds and how many designs of the answer each found.
struct SeedsReport {
  const sizing::Study& study;
  const archive::Contents& whole;
  const std::vector<formats::SearchPart>& searches;
  const std::vector<FoundDesign>& answer;

  [[nodiscard]] std::uint64_t seed_of(std::size_t search) const { return whole.seed.value() + search; }
  [[nodiscard]] std::size_t in_answer(std::size_t search) const {
    return static_cast<std::size_t>(std::ranges::count(answer, search, &FoundDesign::search));
  }
};

text::Json to_json(const SeedsReport& report) {
  text::Json seeds = text::Json::array();
  for (std::size_t i = 0; i < report.searches.size(); ++i) {
    const formats::SearchPart& each = report.searches[i];
    text::Json entry = text::Json::object({{"seed", report.seed_of(i)},
                                           {"stop_reason", each.stop_reason},
                                           {"evaluations", each.evaluations},
                                           {"feasible", each.is_feasible()},
                                           {"found", each.found.size()},
                                           {"in_answer", report.in_answer(i)}});
    if (report.study.objectives.size() == 1 && !each.found.empty())
      entry.set("objectives", formats::objectives_json(report.study, each.found.front().evaluation));
    seeds.add(std::move(entry));
  }
  return text::Json::object({{"command", report.whole.command},
                             {"study", report.study.name},
                             {"objectives", formats::objectives_asked(report.study)},
                             {"designs", report.answer.size()},
                             {"seeds", std::move(seeds)}});
}

std::string to_text(const SeedsReport& report) {
  std::string out;
  for (std::size_t i = 0; i < report.searches.size(); ++i)
    out += fmt::format("seed {}: {} evaluations, {} designs found{}, {} of them in the answer\n", report.seed_of(i),
                       report.searches[i].evaluations, report.searches[i].found.size(),
                       report.searches[i].is_feasible() ? "" : " (infeasible)", report.in_answer(i));
  return out;
}

void write_seeds(const MergeOptions& options, text::OutputFolder& folder, const SeedsReport& report) {
  const text::Json seeds = to_json(report);
  folder.write(seeds_name, seeds.text());
  take_folder(folder, seeds_name, options.force);
  folder.commit(seeds_name);
  std::cout << (options.json ? seeds.text() : to_text(report));
}

// Feasible before infeasible, then the better, then the first seed.
std::size_t best_search_of(const sizing::Problem& problem, const std::vector<formats::SearchPart>& searches) {
  const auto rank = [&](const formats::SearchPart& each) {
    if (each.found.empty()) return std::tuple(2, 0.0);
    const sizing::Evaluation& evaluation = each.found.front().evaluation;
    return each.is_feasible() ? std::tuple(0, sizing::minimised(problem, evaluation).front())
                              : std::tuple(1, sizing::violation(evaluation));
  };
  return static_cast<std::size_t>(std::ranges::min_element(searches, {}, rank) - searches.begin());
}

}  // namespace

ExitCode merge_size(const MergeOptions& options, const Parts& parts) {
  const sizing::DesignProblem problem = problem_of(parts.whole);
  require_figures_of_parts(parts, this_machine(problem));
  const std::vector<formats::SearchPart> searches = searches_of(parts);
  const std::size_t best = best_search_of(problem.problem(), searches);
  text::OutputFolder folder(options.out);
  // No actuator.json of a seed that found no design.
  for (const formats::FileOfPart& file : parts.folders[best].files)
    if (file.name != formats::found_name)
      read_file_of(parts.folders[best], file.name,
                   [&out = folder.open(file.name)](std::string_view block) { out << block; });
  const std::vector<FoundDesign> answer{{.search = best}};
  write_seeds(options, folder, {problem.study(), parts.whole, searches, answer});
  return searches[best].is_feasible() ? ExitCode::done : ExitCode::infeasible;
}

ExitCode merge_pareto(const MergeOptions& options, const Parts& parts) {
  const sizing::DesignProblem problem = problem_of(parts.whole);
  require_figures_of_parts(parts, this_machine(problem));
  const std::vector<formats::SearchPart> searches = searches_of(parts);
  const std::vector<FoundDesign> answer = front_of_fronts(problem.problem(), feasible_of(searches));
  std::vector<sizing::Record> front;
  for (const FoundDesign& each : answer) front.push_back(each.record);
  text::OutputFolder folder(options.out);
  formats::write_front(folder.open("front.csv"), problem.study(), front);
  results::write_provenance(folder, provenance_of_whole(parts.whole));
  write_seeds(options, folder, {problem.study(), parts.whole, searches, answer});
  return front.empty() ? ExitCode::infeasible : ExitCode::done;
}

}  // namespace coilwright::cli
