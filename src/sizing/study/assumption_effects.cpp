#include "coilwright/sizing/study/assumption_effects.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "sizing/problem/workers.hpp"

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
  problem.starts = {best.point};
  SearchResult found = search(problem, search_options);
  evaluations += found.search_evaluations;
  if (!found.feasible) return std::nullopt;
  return std::move(found.best);
}

// The answer's own design with a number at another value is no point of the study, which may vary that number: what is
// left of the study to vary is the current and the numbers beside the design.
DesignResult evaluated_as(const DesignProblem& problem, std::span<const double> point, const actuator::Design& design) {
  Study study = problem.study();
  study.base = design;
  study.variables.clear();
  std::vector<double> kept;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const StudyVariable& variable = problem.study().variables[i];
    if (std::holds_alternative<ParameterVariable>(variable) || std::holds_alternative<LayoutVariable>(variable))
      continue;
    study.variables.push_back(variable);
    kept.push_back(point[i]);
  }
  return DesignProblem(std::move(study)).evaluate(kept);
}

std::vector<actuator::OtherChoice> numbers_of(const DesignProblem& problem, const Record& best) {
  std::vector<actuator::OtherChoice> out = actuator::other_numbers(problem.design_at(best.point));
  if (const std::optional<Spread>& spread = problem.study().spread)
    std::erase_if(out, [&](const actuator::OtherChoice& each) {
      return std::ranges::find(spread->scatters, each.number, &Scatter::name) != spread->scatters.end();
    });
  return out;
}

std::vector<AssumptionEffect> effects_of_numbers(const DesignProblem& problem, const Record& best,
                                                 const AssumptionOptions& options) {
  // As of builds: figures move by up to 5e-6 of themselves, at less than half the cost.
  constexpr double curve_tolerance = 1e-4;
  std::vector<actuator::OtherChoice> numbers = numbers_of(problem, best);
  std::vector<AssumptionEffect> out(numbers.size());
  Workers(options.search.threads).run(numbers.size(), [&](std::size_t i) {
    if (options.search.stop.stop_requested()) return;
    actuator::Design design = numbers[i].design;
    design.curve_tolerance = curve_tolerance;
    AssumptionEffect& effect = out[i];
    effect.evaluation = problem.assess(evaluated_as(problem, best.point, design));
    effect.is_built =
        effect.evaluation.failure.empty() || std::holds_alternative<actuator::Assembly>(actuator::assemble(design));
    effect.worst = worst_margin(problem.study(), effect.evaluation);
    effect.evaluations = 1;
    effect.choice = std::move(numbers[i]);
  });
  std::erase_if(out, [](const AssumptionEffect& each) { return each.evaluations == 0; });
  return out;
}

// Broken limits first, then by how far the objective is from what was promised once the design has followed; where no
// other design was looked for, by how far the worst limit is broken.
using Weight = std::pair<double, double>;

Weight weight_of(const StudyObjective& objective, double promised, const AssumptionEffect& effect) {
  if (!effect.is_built) return {0.0, 0.0};
  const bool kept = is_feasible(effect.evaluation);
  const bool searched = effect.evaluations > 1;
  if (!kept && !effect.other_best) return {1.0, searched || !effect.worst ? 1.0 : -effect.worst->margin};
  const Evaluation& reached =
      effect.other_best && effect.changes_design ? effect.other_best->evaluation : effect.evaluation;
  const double change =
      reached.objectives.empty() ? 1.0 : std::abs(gain(objective, reached.objectives.front(), promised));
  return {kept ? 0.0 : 1.0, change};
}

// How far it takes the answer as it is: of its value, or of a limit that it breaks.
double magnitude_of(const AssumptionEffect& effect) {
  if (!effect.is_built) return 0.0;
  if (!effect.evaluation.failure.empty()) return 1.0;
  return std::max(std::abs(effect.gain), effect.worst ? -effect.worst->margin : 0.0);
}

void sort_by_magnitude(std::vector<AssumptionEffect>& effects) {
  std::map<std::string_view, double> largest;
  for (const AssumptionEffect& each : effects)
    largest[each.choice.subject] = std::max(largest[each.choice.subject], magnitude_of(each));
  std::ranges::stable_sort(effects, std::greater(),
                           [&](const AssumptionEffect& each) { return largest.at(each.choice.subject); });
}

}  // namespace

bool AssumptionEffect::matters() const {
  return !is_feasible(evaluation) || changes_design || std::abs(gain) >= simulation::change_that_matters;
}

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

std::size_t assumption_count(const DesignProblem& problem, const Record& best) {
  return actuator::other_choices(problem.study().base).size() + numbers_of(problem, best).size();
}

std::vector<AssumptionEffect> assumption_effects(const DesignProblem& problem, const Record& best,
                                                 const AssumptionOptions& options) {
  const Study& study = problem.study();
  const StudyObjective& objective = study.objectives.front();
  std::vector<actuator::OtherChoice> choices = actuator::other_choices(study.base);
  // First what takes a moment, so that an interruption leaves the most.
  std::vector<AssumptionEffect> out = effects_of_numbers(problem, best, options);
  const std::size_t all = out.size() + choices.size();
  for (actuator::OtherChoice& choice : choices) {
    if (options.progress) options.progress(out.size(), all);
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
  const double promised = best.evaluation.objectives.front();
  for (AssumptionEffect& effect : out)
    if (!effect.evaluation.objectives.empty())
      effect.gain = gain(objective, effect.evaluation.objectives.front(), promised);
  sort_by_magnitude(out);
  return out;
}

const AssumptionEffect* decisive(const Study& study, const Record& best, const std::vector<AssumptionEffect>& effects) {
  if (effects.empty()) return nullptr;  // as where the best design has failed and has no objectives
  const double promised = best.evaluation.objectives.front();
  const auto weight = [&](const AssumptionEffect& effect) {
    return effect.choice.decided ? Weight(0.0, 0.0) : weight_of(study.objectives.front(), promised, effect);
  };
  const auto most = std::ranges::max_element(effects, {}, weight);
  const auto [broken, change] = weight(*most);
  return broken > 0.0 || change > gain_of_another_design ? &*most : nullptr;
}

}  // namespace coilwright::sizing
