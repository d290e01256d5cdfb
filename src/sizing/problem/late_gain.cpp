#include "coilwright/sizing/problem/late_gain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace coilwright::sizing {
namespace {

constexpr double early_share = 0.8;

double least(const std::vector<Objectives>& points) {
  return std::ranges::min_element(points)->front();
}

// Of one objective.
double gain_of_best(const std::vector<Objectives>& early, const std::vector<Objectives>& all) {
  const double before = least(early);
  const double gain = before - least(all);
  return gain == 0.0 ? 0.0 : gain / std::max(std::abs(before), gain);
}

std::vector<Objectives> front_of(const std::vector<Objectives>& points) {
  std::vector<Objectives> front;
  for (const std::size_t index : non_dominated(points)) front.push_back(points[index]);
  return front;
}

double gain_of_front(const std::vector<Objectives>& early, const std::vector<Objectives>& all) {
  const FrontFrame frame = frame_of(all);
  return std::max(0.0,
                  1.0 - normalised_hypervolume(front_of(early), frame) / normalised_hypervolume(front_of(all), frame));
}

}  // namespace

std::optional<double> late_gain(const Archive& archive, std::size_t evaluations) {
  const auto early_designs = static_cast<std::size_t>(early_share * static_cast<double>(evaluations));
  std::vector<Objectives> early;
  std::vector<Objectives> all;
  for (const Record& record : archive.records()) {
    if (record.number == 0 || record.number > evaluations || !is_feasible(record.evaluation)) continue;
    all.push_back(minimised(archive.problem(), record.evaluation));
    if (record.number <= early_designs) early.push_back(all.back());
  }
  if (early.empty()) return std::nullopt;
  return archive.problem().objectives.size() == 1 ? gain_of_best(early, all) : gain_of_front(early, all);
}

}  // namespace coilwright::sizing
