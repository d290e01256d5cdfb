#include "coilwright/sizing/study/after_search.hpp"

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "coilwright/actuator/modelling_choices.hpp"

namespace coilwright::sizing {
namespace {

std::vector<DesignResult> all_again(const DesignProblem& problem, const auto& designs) {
  std::vector<DesignResult> out;
  for (const auto& each : designs) {
    if (!is_feasible(each.evaluation)) throw std::logic_error("a design that breaks a limit is recommended");
    out.push_back(evaluated_again(problem, each.point, each.evaluation));
  }
  return out;
}

// The best design, each step from it and the best under each relaxed limit.
std::vector<std::vector<double>> designs_stated(const DesignProblem& problem, const SearchResult& result) {
  if (!result.best) return {};
  std::vector<std::vector<double>> out{result.best->point};
  const std::vector<Variable> variables = problem.problem().variables;
  for (const VariableStep& step : result.sensitivity.steps) {
    const auto moved = std::ranges::find(variables, step.variable, &Variable::name) - variables.begin();
    out.push_back(result.best->point);
    out.back()[static_cast<std::size_t>(moved)] = step.to;
  }
  for (const BindingConstraint& constraint : result.sensitivity.binding)
    if (constraint.relaxed_best) out.push_back(constraint.relaxed_best->point);
  return out;
}

// Of an answer, what builds make of it that the search has not seen.
std::optional<Yield> builds_of(const Study& study, const EvaluatedDesign& best, const AfterSearchOptions& options) {
  if (!study.spread) return std::nullopt;
  return yield_of(study, best,
                  {.builds = options.builds,
                   .seed = study.search.seed,
                   .threads = study.search.threads,
                   .stop = options.stop,
                   .progress = options.builds_done});
}

std::vector<AssumptionEffect> assumptions_of(const DesignProblem& problem, const Record& best,
                                             const AfterSearchOptions& options) {
  AssumptionOptions how{
      .search = problem.study().search, .evaluate = options.evaluate, .progress = options.choices_done};
  // A search that may take few evaluations is not followed by ones of many. One of builds is not searched again: that
  // would cost three times the search, and the choices may stand in the spread itself.
  how.evaluations = problem.study().spread ? 0 : std::min(how.evaluations, how.search.max_evaluations);
  how.search.stop = options.stop;
  return assumption_effects(problem, best, how);
}

}  // namespace

DesignResult evaluated_again(const DesignProblem& problem, std::span<const double> point, const Evaluation& found) {
  DesignResult result = problem.evaluate(point);
  if (problem.assess(result) != found)
    throw std::logic_error("a design that the search found gives other numbers when it is evaluated again");
  return result;
}

std::vector<DesignResult> evaluated_again(const DesignProblem& problem, std::span<const Record> designs) {
  return all_again(problem, designs);
}

std::vector<DesignResult> evaluated_again(const DesignProblem& problem, std::span<const SweptDesign> designs) {
  return all_again(problem, designs);
}

AfterSearch after_search(const DesignProblem& problem, const SearchResult& result, const AfterSearchOptions& options) {
  if (options.stated)
    for (const std::vector<double>& point : designs_stated(problem, result)) options.stated({}, point);
  AfterSearch out{.base = problem.evaluate_base()};
  out.base_seen = problem.assess(out.base);
  if (result.best) out.best = evaluated_again(problem, result.best->point, result.best->evaluation);
  // Only of an answer: what keeps no limit anyway rests on more than a choice.
  if (!result.feasible) return out;
  const Study& study = problem.study();
  out.assumptions_left = assumption_count(problem, *result.best);
  if (study.search.afterwards == Afterwards::nothing) return out;
  out.built = builds_of(study, std::get<EvaluatedDesign>(*out.best), options);
  if (options.stop.stop_requested()) return out;
  out.assumptions = assumptions_of(problem, *result.best, options);
  out.assumptions_left -= out.assumptions.size();
  if (options.stated)
    for (const AssumptionEffect& effect : out.assumptions) {
      if (!effect.choice.number.empty()) continue;  // evaluated here and now
      options.stated(name_of(effect.choice), result.best->point);
      if (effect.other_best) options.stated(name_of(effect.choice), effect.other_best->point);
    }
  return out;
}

}  // namespace coilwright::sizing
