#include "coilwright/sizing/search/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sizing/nlopt/problem_optimisation.hpp"
#include "sizing/problem/design_space.hpp"
#include "sizing/search/surrogate_search.hpp"

namespace coilwright::sizing {
namespace {

void validate_options(const Archive& archive, const Record& best, const SensitivityOptions& options) {
  if (!(options.relative_step > 0 && options.relative_step <= 1)) {
    throw std::invalid_argument(fmt::format("relative_step: must be > 0 and <= 1; got {}", options.relative_step));
  }
  if (!(options.relaxation > 0 && std::isfinite(options.relaxation))) {
    throw std::invalid_argument(fmt::format("relaxation: must be finite and > 0; got {}", options.relaxation));
  }
  const std::optional<Evaluation> known = archive.find(best.point);
  if (!known) throw std::invalid_argument("best: must be in the archive; got a design that was never evaluated");
  if (!is_feasible(*known)) {
    throw std::invalid_argument(fmt::format("best: must be feasible; got a violation of {}", violation(*known)));
  }
}

// Values one step below and above, or every other level.
std::vector<double> stepped_values(const Variable& variable, double value, double relative_step) {
  std::vector<double> values;
  if (variable.kind == VariableKind::categorical) {
    for (double level = 0; level <= variable.upper; ++level) values.push_back(level);
  } else {
    const double grid = grid_step(variable);
    const double step = grid > 0 ? grid : relative_step * (variable.upper - variable.lower);
    for (const double candidate : {value - step, value + step}) values.push_back(nearest_legal(variable, candidate));
  }
  std::erase(values, value);
  return values;
}

struct Move {
  std::size_t variable;
  std::vector<double> point;
};

std::vector<Move> moves_from(const Problem& problem, const Record& best, double relative_step) {
  std::vector<Move> moves;
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    for (const double value : stepped_values(problem.variables[i], best.point[i], relative_step)) {
      Move move{.variable = i, .point = best.point};
      move.point[i] = value;
      moves.push_back(std::move(move));
    }
  }
  return moves;
}

VariableStep step_made(const Problem& problem, const Record& best, const Move& move, const Evaluation& evaluation) {
  VariableStep step{.variable = problem.variables[move.variable].name,
                    .from = best.point[move.variable],
                    .to = move.point[move.variable],
                    .objective_change = {},
                    .improves = false,
                    .violates = violated_by(problem, evaluation)};
  if (!evaluation.failure.empty()) return step;
  step.objective_change = evaluation.objectives[0] - best.evaluation.objectives[0];
  step.improves = minimised(problem, evaluation)[0] < minimised(problem, best.evaluation)[0];
  return step;
}

std::vector<BindingConstraint> binding_constraints(const Problem& problem, const Record& best,
                                                   const std::vector<VariableStep>& steps) {
  std::vector<BindingConstraint> binding;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const std::string& name = problem.constraints[i];
    const double margin = -best.evaluation.constraints[i] + 0.0;
    const bool blocks = std::ranges::any_of(steps, [&](const VariableStep& step) {
      return step.improves && std::ranges::find(step.violates, name) != step.violates.end();
    });
    if (margin >= binding_margin && !blocks) continue;
    binding.push_back({.name = name,
                       .margin = margin,
                       .at_limit = margin < binding_margin,
                       .blocks_step = blocks,
                       .relaxed_by = 0,
                       .objective_change = {},
                       .relaxed_best = {}});
  }
  return binding;
}

// Learns the designs of an SLSQP run from the best design along its variables without a grid: the nearest improvement
// that a relaxed limit allows.
void descend(Archive& archive, Samples& samples, const Record& best, std::size_t budget,
             const SensitivityOptions& options) {
  const DesignSpace& space = samples.space();
  ProblemOptimisation descent{.algorithm = Algorithm::slsqp,
                              .goal = {.kind = Goal::Kind::objective,
                                       .origin = minimised(archive.problem(), best.evaluation),
                                       .span = {std::max(1e-9, std::abs(best.evaluation.objectives[0]))}},
                              .start = {.unit = space.unit(best.point), .combination = space.combination(best.point)},
                              .box = whole_box(space),
                              .budget = budget,
                              .seed = options.search.seed};
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) {
    if (space.spacing(axis) == 0) descent.axes.push_back(static_cast<Eigen::Index>(axis));
  }
  if (descent.axes.empty()) return;
  for (const Record& record : optimise_on_problem(archive, samples, descent, options.search.stop)) {
    archive.number(record.point);
    samples.add(record);
  }
}

// Continues the search from all designs of the archive with other limits; the best design within them.
std::optional<Record> relaxed_search(Archive& archive, const Record& best, std::vector<double> limits, Workers& workers,
                                     const SensitivityOptions& options) {
  Samples samples{archive.problem(), limits};
  for (const Record& record : archive.records()) samples.add(record);
  SearchOptions quiet = options.search;
  quiet.algorithm = Algorithm::automatic;
  quiet.progress = {};
  const std::size_t descent = options.relaxed_evaluations / 4;
  descend(archive, samples, best, descent, options);
  (void)surrogate_search({.archive = archive,
                          .samples = samples,
                          .workers = workers,
                          .options = quiet,
                          .budget = options.relaxed_evaluations - descent});
  if (samples.front().empty()) return std::nullopt;
  const Sample& found = samples[samples.front().front()];
  return Record{.point = found.point, .evaluation = *archive.find(found.point)};
}

}  // namespace

Sensitivity analyse_sensitivity(Archive& archive, const Record& best, const SensitivityOptions& options) {
  validate_options(archive, best, options);
  const Problem& problem = archive.problem();
  if (problem.objectives.size() != 1) {
    throw std::invalid_argument(fmt::format("objectives: must be one; got {}", problem.objectives.size()));
  }
  Workers workers{options.search.threads};
  Sensitivity result;
  const std::vector<Move> moves = moves_from(problem, best, options.relative_step);
  std::vector<std::vector<double>> points;
  for (const Move& move : moves) points.push_back(move.point);
  const std::vector<Record> records = workers.evaluate(archive, points, options.search.stop);
  if (records.size() < points.size()) return {};  // interrupted
  for (std::size_t i = 0; i < moves.size(); ++i) {
    result.steps.push_back(step_made(problem, best, moves[i], records[i].evaluation));
  }
  result.binding = binding_constraints(problem, best, result.steps);
  for (BindingConstraint& constraint : result.binding) {
    if (options.search.stop.stop_requested()) return {};
    std::vector<double> limits(problem.constraints.size(), 0.0);
    const auto which = std::ranges::find(problem.constraints, constraint.name) - problem.constraints.begin();
    limits[static_cast<std::size_t>(which)] = constraint.relaxed_by = options.relaxation;
    constraint.relaxed_best = relaxed_search(archive, best, std::move(limits), workers, options);
    if (!constraint.relaxed_best) continue;
    constraint.objective_change = constraint.relaxed_best->evaluation.objectives[0] - best.evaluation.objectives[0];
  }
  return result;
}

}  // namespace coilwright::sizing
