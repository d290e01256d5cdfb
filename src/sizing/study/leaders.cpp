#include "coilwright/sizing/study/leaders.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::sizing {
namespace {

// Evaluated before failed, then by how far from feasible.
std::pair<bool, double> distance_from_feasible(const SweptDesign& design) {
  return {!design.evaluation.failure.empty(), violation(design.evaluation)};
}

}  // namespace

Leaders::Leaders(const DesignProblem& problem) : problem_(problem) {}

std::size_t Leaders::configuration_of(const SweptDesign& design) const {
  const std::vector<StudyVariable>& variables = problem_.study().variables;
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (std::holds_alternative<LayoutVariable>(variables[i]))
      return static_cast<std::size_t>(std::lround(design.point[i]));
  return 0;
}

bool Leaders::leads(const SweptDesign& design, const SweptDesign& leader, std::size_t objective) const {
  const bool feasible = is_feasible(design.evaluation);
  if (feasible != is_feasible(leader.evaluation)) return feasible;
  if (!feasible) return distance_from_feasible(design) < distance_from_feasible(leader);
  const double value = design.evaluation.objectives[objective];
  const double best = leader.evaluation.objectives[objective];
  return problem_.study().objectives[objective].sense == Sense::maximise ? value > best : value < best;
}

void Leaders::consider(const SweptDesign& design) {
  const std::size_t configuration = configuration_of(design);
  for (std::size_t i = 0; i < problem_.study().objectives.size(); ++i) {
    const auto [place, is_first] = leaders_.try_emplace({configuration, i}, design);
    if (!is_first && leads(design, place->second, i)) place->second = design;
  }
}

std::vector<Leader> Leaders::all() const {
  const std::vector<StudyVariable>& variables = problem_.study().variables;
  const auto varied =
      std::ranges::find_if(variables, [](const StudyVariable& v) { return std::holds_alternative<LayoutVariable>(v); });
  std::vector<Leader> out;
  for (const auto& [key, design] : leaders_) {
    const auto& [configuration, objective] = key;
    if (objective > 0 && !is_feasible(design.evaluation)) continue;  // the first objective's entry says the same
    std::string_view letter;
    if (varied != variables.end())
      letter = std::get<std::string_view>(value_at(*varied, static_cast<double>(configuration)));
    out.push_back({.configuration = letter, .objective = objective, .design = design});
  }
  return out;
}

bool Leaders::any_feasible() const {
  return std::ranges::any_of(leaders_, [](const auto& entry) { return is_feasible(entry.second.evaluation); });
}

std::vector<SweptDesign> feasible_designs(std::span<const Leader> leaders) {
  std::vector<SweptDesign> out;
  for (const Leader& leader : leaders)
    if (is_feasible(leader.design.evaluation) &&
        std::ranges::find(out, leader.design.index, &SweptDesign::index) == out.end())
      out.push_back(leader.design);
  return out;
}

}  // namespace coilwright::sizing
