#include "coilwright/sizing/study/assumption_effects.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/sizing/search/search.hpp"

namespace coilwright::sizing {
namespace {

// How much better `value` is than `reference`, over the reference's magnitude.
double gain(const StudyObjective& objective, double value, double reference) {
  const double change = objective.sense == Sense::maximise ? value - reference : reference - value;
  return change / std::max(std::abs(reference), 1e-12 * objective.quantity.scale);
}

// Adds to `evaluations` what it takes.
std::optional<Record> other_best(Problem problem, const Record& best, const AssumptionOptions& options,
                                 std::size_t& evaluations) {
  if (options.evaluations == 0) return std::nullopt;
  SearchOptions search_options = options.search;
  search_options.algorithm = Algorithm::automatic;
  search_options.max_evaluations = options.evaluations;
  search_options.afterwards = Afterwards::nothing;
  search_options.progress = {};
  problem.start = best.point;
  SearchResult found = search(problem, search_options);
  evaluations += found.search_evaluations;
  if (!found.feasible) return std::nullopt;
  return std::move(found.best);
}

}  // namespace

std::string name_of(const actuator::OtherChoice& choice) {
  return std::string(choice.subject) + ": " + choice.otherwise;
}

DesignProblem under(const DesignProblem& problem, const actuator::OtherChoice& choice) {
  Study study = problem.study();
  study.base = choice.design;
  return DesignProblem(std::move(study));
}

std::optional<WorstMargin> worst_margin(const Study& study, const Evaluation& evaluation) {
  if (!evaluation.failure.empty() || study.limits.empty()) return std::nullopt;
  const auto worst = std::ranges::max_element(evaluation.constraints);
  const auto index = static_cast<std::size_t>(worst - evaluation.constraints.begin());
  return WorstMargin{.limit = name_of(study.limits[index]), .margin = -*worst + 0.0};
}

std::vector<AssumptionEffect> assumption_effects(const DesignProblem& problem, const Record& best,
                                                 const AssumptionOptions& options) {
  const Study& study = problem.study();
  const StudyObjective& objective = study.objectives.front();
  std::vector<AssumptionEffect> out;
  std::vector<actuator::OtherChoice> choices = actuator::other_choices(study.base);
  for (actuator::OtherChoice& choice : choices) {
    if (options.progress) options.progress(out.size(), choices.size());
    const DesignProblem other = under(problem, choice);
    AssumptionEffect effect;
    effect.evaluations = 1;
    Problem asked = other.problem();
    if (options.evaluate)
      asked.evaluate = [&](std::span<const double> point) { return options.evaluate(other, choice, point); };
    effect.evaluation = asked.evaluate(best.point);
    effect.worst = worst_margin(study, effect.evaluation);
    effect.is_built = effect.evaluation.failure.empty() ||
                      std::holds_alternative<actuator::Assembly>(actuator::assemble(other.design_at(best.point)));
    if (effect.is_built) effect.other_best = other_best(std::move(asked), best, options, effect.evaluations);
    if (options.search.stop.stop_requested()) break;
    if (effect.other_best && effect.other_best->point != best.point) {
      const double reached = effect.other_best->evaluation.objectives.front();
      effect.changes_design = !is_feasible(effect.evaluation) ||
                              gain(objective, reached, effect.evaluation.objectives.front()) > gain_of_another_design;
    }
    choice.design = other.design_at(best.point);
    effect.choice = std::move(choice);
    out.push_back(std::move(effect));
  }
  return out;
}

const AssumptionEffect* decisive(const Study& study, const Record& best, const std::vector<AssumptionEffect>& effects) {
  if (effects.empty()) return nullptr;
  const StudyObjective& objective = study.objectives.front();
  const double promised = best.evaluation.objectives.front();
  // Broken limits first, then by how far the objective is from what was promised once the design has followed; where no
  // other design was looked for, by how far the worst limit is broken.
  const auto weight = [&](const AssumptionEffect& effect) {
    if (!effect.is_built) return std::pair(0.0, 0.0);
    const bool kept = is_feasible(effect.evaluation);
    const bool searched = effect.evaluations > 1;
    if (!kept && !effect.other_best) return std::pair(1.0, searched || !effect.worst ? 1.0 : -effect.worst->margin);
    const Evaluation& reached =
        effect.other_best && effect.changes_design ? effect.other_best->evaluation : effect.evaluation;
    const double change =
        reached.objectives.empty() ? 1.0 : std::abs(gain(objective, reached.objectives.front(), promised));
    return std::pair(kept ? 0.0 : 1.0, change);
  };
  const auto most = std::ranges::max_element(effects, {}, weight);
  const auto [broken, change] = weight(*most);
  return broken > 0.0 || change > gain_of_another_design ? &*most : nullptr;
}

}  // namespace coilwright::sizing
