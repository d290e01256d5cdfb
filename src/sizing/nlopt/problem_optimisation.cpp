#include "sizing/nlopt/problem_optimisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <unordered_map>
#include <utility>

#include "sizing/problem/point_hash.hpp"
#include "sizing/sampling/random.hpp"

namespace coilwright::sizing {
namespace {

// Difference step of an axis without a grid, in unit coordinates: near the square root of the error of functions that
// are themselves iterated to 1e-12 or so, which balances that error and the truncation of a one-sided difference.
constexpr double difference_step = 1e-6;

// Thrown to end an NLopt run from inside; no errors: optimise_on_problem catches them.
struct BudgetSpent {};
struct StopRequested {};

/// The new designs that one optimisation asks for, and their limit.
class RequestedDesigns {
 public:
  RequestedDesigns(Archive& archive, const Samples& samples, std::size_t budget, const std::stop_token& stop)
      : archive_{archive}, samples_{samples}, budget_{budget}, stop_{stop} {}

  Evaluation evaluate(const std::vector<double>& unit, std::uint64_t combination) {
    std::vector<double> point = samples_.space().point(unit, combination);
    if (samples_.knows(unit, combination)) return archive_.evaluate(point);
    if (const auto own = index_of_.find(point); own != index_of_.end()) return found_[own->second].evaluation;
    if (stop_.stop_requested()) throw StopRequested{};
    if (found_.size() >= budget_) throw BudgetSpent{};
    Evaluation evaluation = archive_.evaluate(point);
    index_of_.emplace(point, found_.size());
    found_.push_back({.point = std::move(point), .evaluation = evaluation});
    return evaluation;
  }

  [[nodiscard]] std::size_t count() const { return found_.size(); }
  [[nodiscard]] std::vector<Record> records() && { return std::move(found_); }

 private:
  Archive& archive_;
  const Samples& samples_;
  std::size_t budget_;
  const std::stop_token& stop_;
  std::vector<Record> found_;
  std::unordered_map<std::vector<double>, std::size_t, PointHash> index_of_;
};

/// The problem as functions of unit coordinates. A failed design gets finite substitutes, worse than any value seen and
/// growing with its infeasibility, so that NLopt can leave it; they never reach the archive.
class ProblemFunctions {
 public:
  ProblemFunctions(RequestedDesigns& requests, const Samples& samples, std::uint64_t combination,
                   const std::vector<Eigen::Index>& axes)
      : requests_{requests}, samples_{samples}, combination_{combination}, axes_{axes} {
    const auto objectives = static_cast<Eigen::Index>(samples.objective_count());
    best_ = Eigen::VectorXd::Constant(objectives, std::numeric_limits<double>::infinity());
    worst_ = -best_;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].evaluated) widen(samples[i].values);
    }
    if (worst_[0] < best_[0]) best_ = worst_ = Eigen::VectorXd::Zero(objectives);  // nothing is evaluated yet
  }

  [[nodiscard]] Linearisation at(const Eigen::VectorXd& x, DesignFunctions::Wanted wanted) {
    const DesignSpace& space = samples_.space();
    const std::vector<double> unit = space.snapped({x.data(), static_cast<std::size_t>(x.size())});
    Linearisation result{.values = outputs(unit), .jacobian = {}};
    if (wanted == DesignFunctions::Wanted::values) return result;
    result.jacobian = Eigen::MatrixXd::Zero(result.values.size(), x.size());
    for (const Eigen::Index column : axes_) {
      const auto axis = static_cast<std::size_t>(column);
      const double spacing = space.spacing(axis);
      double step = spacing > 0 ? spacing : difference_step;
      if (unit[axis] + step > space.ceiling(axis)) step = -step;
      std::vector<double> moved = unit;
      moved[axis] += step;
      result.jacobian.col(column) = (outputs(space.snapped(moved)) - result.values) / step;
    }
    return result;
  }

 private:
  Eigen::VectorXd outputs(const std::vector<double>& unit) {
    const Sample sample = samples_.as_sample(
        {.point = samples_.space().point(unit, combination_), .evaluation = requests_.evaluate(unit, combination_)});
    const auto objectives = worst_.size();
    Eigen::VectorXd result(objectives + static_cast<Eigen::Index>(samples_.constraint_count()));
    if (!sample.evaluated) {
      result.head(objectives) = worst_ + (worst_ - best_).cwiseMax(1e-9) * (1 + sample.violation);
      result.tail(result.size() - objectives).setConstant(1 + sample.violation);
      return result;
    }
    widen(sample.values);
    for (Eigen::Index i = 0; i < result.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      result[i] = i < objectives ? sample.values[k] : sample.constraints[k - static_cast<std::size_t>(objectives)];
    }
    return result;
  }

  void widen(const Objectives& values) {
    for (Eigen::Index i = 0; i < worst_.size(); ++i) {
      best_[i] = std::min(best_[i], values[static_cast<std::size_t>(i)]);
      worst_[i] = std::max(worst_[i], values[static_cast<std::size_t>(i)]);
    }
  }

  RequestedDesigns& requests_;
  const Samples& samples_;
  std::uint64_t combination_;
  const std::vector<Eigen::Index>& axes_;
  Eigen::VectorXd best_, worst_;
};

std::vector<Eigen::Index> all_axes(const DesignSpace& space) {
  std::vector<Eigen::Index> axes;
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) axes.push_back(static_cast<Eigen::Index>(axis));
  return axes;
}

}  // namespace

std::vector<Record> optimise_on_problem(Archive& archive, const Samples& samples,
                                        const ProblemOptimisation& optimisation, const std::stop_token& stop) {
  RequestedDesigns requests{archive, samples, optimisation.budget, stop};
  const std::vector<Eigen::Index> axes = optimisation.axes.empty() ? all_axes(samples.space()) : optimisation.axes;
  ProblemFunctions problem{requests, samples, optimisation.start.combination, axes};
  const DesignFunctions functions{
      .at = [&](const Eigen::VectorXd& x, DesignFunctions::Wanted wanted) { return problem.at(x, wanted); },
      .objectives = static_cast<Eigen::Index>(samples.objective_count()),
      .constraints = static_cast<Eigen::Index>(samples.constraint_count()),
      .margin = takes_constraints(optimisation.algorithm) ? 1e-7 : 0.0};
  std::mt19937_64 random{optimisation.seed};
  Eigen::VectorXd start = Eigen::Map<const Eigen::VectorXd>(optimisation.start.unit.data(),
                                                            static_cast<Eigen::Index>(optimisation.start.unit.size()));
  // On a grid NLopt may ask for known designs without end: its own calls are limited too.
  const int calls = static_cast<int>(std::min<std::size_t>(10 * optimisation.budget + 100, 1'000'000));
  try {
    for (int runs_without_new = 0; runs_without_new < 5;) {
      const std::size_t before = requests.count();
      (void)minimise(functions, optimisation.goal, optimisation.box, start, axes,
                     {.algorithm = optimisation.algorithm,
                      .max_calls = calls,
                      .relative_tolerance = is_global(optimisation.algorithm) ? 0.0 : 1e-6,
                      .first_step = 0.1,
                      .seed = random()});
      runs_without_new = requests.count() == before ? runs_without_new + 1 : 0;
      for (const Eigen::Index axis : axes) {
        start[axis] = std::lerp(optimisation.box.lower[axis], optimisation.box.upper[axis], uniform(random));
      }
    }
  } catch (const BudgetSpent&) {
  } catch (const StopRequested&) {
  }
  return std::move(requests).records();
}

}  // namespace coilwright::sizing
