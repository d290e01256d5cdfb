#include "coilwright/formats/study/front_json.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "coilwright/formats/study/result_json.hpp"
#include "coilwright/sizing/problem/late_gain.hpp"

namespace coilwright::formats {

using namespace sizing;
using namespace text;

std::size_t middle_of(const ParetoResult& result) {
  const std::vector<Objectives> points = minimised(result.archive.problem(), result.front);
  const FrontFrame frame = frame_of(points);
  std::size_t middle = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    double worst = 0.0;
    for (std::size_t k = 0; k < points[i].size(); ++k) {
      const double span = frame.nadir[k] - frame.ideal[k];
      if (span > 0.0) worst = std::max(worst, (points[i][k] - frame.ideal[k]) / span);
    }
    if (worst >= least) continue;
    least = worst;
    middle = i;
  }
  return middle;
}

std::size_t end_of(const ParetoResult& result, std::size_t objective) {
  const std::vector<Objectives> points = minimised(result.archive.problem(), result.front);
  const auto best =
      std::ranges::min_element(points, {}, [objective](const Objectives& each) { return each[objective]; });
  return static_cast<std::size_t>(best - points.begin());
}

namespace {

// Hypervolume of the front in its own frame, reference 1.1: how full it is, comparable between runs of one study only.
Json hypervolume_json(const ParetoResult& result) {
  if (result.front.empty()) return nullptr;
  const std::vector<Objectives> points = minimised(result.archive.problem(), result.front);
  return normalised_hypervolume(points, frame_of(points));
}

Json end_json(const Study& study, const Record& record) {
  return design_json(study, record.point, record.evaluation);
}

Json least_infeasible_json(const Study& study, const ParetoResult& result) {
  if (!result.least_infeasible) return nullptr;
  Json out = end_json(study, *result.least_infeasible);
  out.set("violated", Json::list(result.violated));
  return out;
}

}  // namespace

Json to_json(const Study& study, const ParetoResult& result, std::span<const BrokenPartLimit> broken) {
  const ArchiveCounts counts = counts_of(result.archive);
  Json evaluations = to_json(counts);
  evaluations.set("of_ends", counts.of_ends).set("total", result.evaluations);
  Json out = result_head("pareto", study, result.stop_reason);
  out.set("evaluations", std::move(evaluations)).set("feasible", !result.front.empty());
  out.set("front_size", result.front.size()).set("hypervolume", hypervolume_json(result));
  out.set("late_gain", late_gain(result.archive, result.evaluations));
  Json ends = Json::array();
  if (!result.front.empty())
    for (std::size_t i = 0; i < study.objectives.size(); ++i)
      ends.add(end_json(study, result.front[end_of(result, i)]));
  out.set("ends", std::move(ends));
  out.set("middle", result.front.empty() ? Json(nullptr) : end_json(study, result.front[middle_of(result)]));
  out.set("least_infeasible", least_infeasible_json(study, result));
  out.set("broken_part_limits", to_json(broken));
  return out;
}

}  // namespace coilwright::formats
