#include "sizing/search/nlopt_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <unordered_map>

#include "sizing/sampling/explorer.hpp"
#include "sizing/sampling/neighbours.hpp"
#include "sizing/sampling/random.hpp"

namespace coilwright::sizing {
namespace {

// Difference step of an axis without grid, unit coordinates: near the cube root of rounding for functions that are
// themselves iterated to 1e-12 or so; the truncation error is of the same relative order.
constexpr double difference_step = 1e-6;

// End an NLopt run from inside. Not errors: run_direct catches them.
struct BudgetSpent {};
struct StopRequested {};

/// The designs one task asked for.
class Requests {
 public:
  Requests(Archive& archive, const Samples& samples, std::size_t budget, const std::stop_token& stop)
      : archive_{archive}, samples_{samples}, budget_{budget}, stop_{stop} {}

  Evaluation evaluate(const std::vector<double>& unit, std::uint64_t combination) {
    std::vector<double> point = samples_.space().point(unit, combination);
    if (samples_.knows(unit, combination)) return archive_.evaluate(point);
    if (const auto own = place_.find(point); own != place_.end()) return found_[own->second].evaluation;
    if (stop_.stop_requested()) throw StopRequested{};
    if (found_.size() >= budget_) throw BudgetSpent{};
    Evaluation evaluation = archive_.evaluate(point);
    place_.emplace(point, found_.size());
    found_.push_back({.point = std::move(point), .evaluation = evaluation});
    return evaluation;
  }

  [[nodiscard]] std::size_t count() const { return found_.size(); }
  [[nodiscard]] std::vector<Record> taken() && { return std::move(found_); }

 private:
  Archive& archive_;
  const Samples& samples_;
  std::size_t budget_;
  const std::stop_token& stop_;
  std::vector<Record> found_;
  std::unordered_map<std::vector<double>, std::size_t, PointHash> place_;
};

/// The problem as a field over unit coordinates. A failed design gets finite stand-ins, worse than any value seen and
/// growing with its infeasibility, so that NLopt can walk away from it; they never leave this class.
class ProblemField {
 public:
  ProblemField(Requests& requests, const Samples& samples, std::uint64_t combination,
               const std::vector<Eigen::Index>& axes)
      : requests_{requests}, samples_{samples}, combination_{combination}, axes_{axes} {
    const auto objectives = static_cast<Eigen::Index>(samples.objective_count());
    best_ = Eigen::VectorXd::Constant(objectives, std::numeric_limits<double>::infinity());
    worst_ = -best_;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].evaluated) widen(samples[i].values);
    }
    if (worst_[0] < best_[0]) best_ = worst_ = Eigen::VectorXd::Zero(objectives);  // nothing was evaluated yet
  }

  [[nodiscard]] Surrogate::Linearisation at(const Eigen::VectorXd& x, Field::Wanted wanted) {
    const DesignSpace& space = samples_.space();
    const std::vector<double> unit = space.snapped({x.data(), static_cast<std::size_t>(x.size())});
    Surrogate::Linearisation result{.values = outputs(unit), .jacobian = {}};
    if (wanted == Field::Wanted::values) return result;
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

  Requests& requests_;
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

std::vector<Record> run_direct(Archive& archive, const Samples& samples, const DirectTask& task,
                               const std::stop_token& stop) {
  Requests requests{archive, samples, task.budget, stop};
  const std::vector<Eigen::Index> axes = task.axes.empty() ? all_axes(samples.space()) : task.axes;
  ProblemField problem{requests, samples, task.start.combination, axes};
  const Field field{.at = [&](const Eigen::VectorXd& x, Field::Wanted wanted) { return problem.at(x, wanted); },
                    .objectives = static_cast<Eigen::Index>(samples.objective_count()),
                    .constraints = static_cast<Eigen::Index>(samples.constraint_count()),
                    .margin = takes_constraints(task.algorithm) ? 1e-7 : 0.0};
  std::mt19937_64 random{task.seed};
  Eigen::VectorXd start =
      Eigen::Map<const Eigen::VectorXd>(task.start.unit.data(), static_cast<Eigen::Index>(task.start.unit.size()));
  // On a grid NLopt may circle among known designs without end: its own calls are limited too.
  const int calls = static_cast<int>(std::min<std::size_t>(10 * task.budget + 100, 1'000'000));
  try {
    for (int fruitless = 0; fruitless < 5;) {
      const std::size_t before = requests.count();
      (void)minimise(field, task.goal, task.box, start, axes,
                     {.algorithm = task.algorithm,
                      .max_calls = calls,
                      .relative_tolerance = is_global(task.algorithm) ? 0.0 : 1e-6,
                      .first_step = 0.1,
                      .seed = random()});
      fruitless = requests.count() == before ? fruitless + 1 : 0;
      for (const Eigen::Index axis : axes) {
        start[axis] = std::lerp(task.box.lower[axis], task.box.upper[axis], uniform(random));
      }
    }
  } catch (const BudgetSpent&) {
  } catch (const StopRequested&) {
  }
  return std::move(requests).taken();
}

namespace {

/// Rounds of `search_directly`.
class DirectSearch {
 public:
  explicit DirectSearch(const EngineRun& run)
      : run_{run},
        samples_{run.samples},
        space_{samples_.space()},
        explorer_{space_, run.options.seed},
        known_before_{run.archive.size()} {}

  StopReason run();

 private:
  [[nodiscard]] std::size_t left() const {
    const std::size_t made = run_.archive.size() - known_before_;
    return made < run_.budget ? run_.budget - made : 0;
  }
  [[nodiscard]] bool stopped() const { return run_.options.stop.stop_requested(); }
  [[nodiscard]] double merit(const Sample& sample) const;
  [[nodiscard]] std::vector<std::pair<double, std::size_t>> best_of_combinations() const;
  void evaluate(const std::vector<Candidate>& candidates);
  void scatter();
  void round(const std::vector<std::pair<double, std::size_t>>& starts, std::size_t budget);
  void visit_neighbours();
  void report() const;

  const EngineRun& run_;
  Samples& samples_;
  const DesignSpace& space_;
  Explorer explorer_;
  std::size_t known_before_;
  std::uint64_t tasks_ = 0;
  Goal goal_{.kind = Goal::Kind::objective};
};

double DirectSearch::merit(const Sample& sample) const {
  if (!sample.evaluated) return 1e6 * (1 + sample.violation);  // behind every evaluated one of order-1 constraints
  return priced(goal_.scalar(sample), sample.violation);
}

// The best sample of each combination, best first.
std::vector<std::pair<double, std::size_t>> DirectSearch::best_of_combinations() const {
  std::unordered_map<std::uint64_t, std::pair<double, std::size_t>> best;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const std::pair entry{merit(samples_[i]), i};
    const auto [place, inserted] = best.try_emplace(samples_[i].combination, entry);
    if (!inserted) place->second = std::min(place->second, entry);
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (const auto& [combination, entry] : best) order.push_back(entry);
  std::ranges::sort(order);
  return order;
}

void DirectSearch::evaluate(const std::vector<Candidate>& candidates) {
  std::vector<std::vector<double>> points;
  for (const Candidate& candidate : candidates) points.push_back(space_.point(candidate.unit, candidate.combination));
  for (const Record& record : run_.workers.evaluate(run_.archive, points, run_.options.stop)) samples_.add(record);
  report();
}

void DirectSearch::report() const {
  if (!run_.options.progress) return;
  run_.options.progress({.evaluations = run_.archive.size(),
                         .max_evaluations = run_.options.max_evaluations,
                         .feasible = samples_.feasible_count(),
                         .front_size = samples_.front().size()});
}

// Starts for every combination, and the scale of the objective: its range over them.
void DirectSearch::scatter() {
  const std::uint64_t combinations = std::min<std::uint64_t>(space_.combinations(), 256);
  const std::size_t wanted = std::clamp<std::size_t>(4 * combinations, 1, std::max<std::size_t>(left() / 5, 1));
  std::vector<Candidate> candidates;
  while (candidates.size() < wanted) {
    std::optional<Candidate> candidate = explorer_.scatter(samples_);
    if (!candidate) break;
    candidates.push_back(std::move(*candidate));
  }
  evaluate(candidates);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (!samples_[i].evaluated) continue;
    low = std::min(low, samples_[i].values[0]);
    high = std::max(high, samples_[i].values[0]);
  }
  if (low > high) low = high = 0;
  goal_.origin = {low};
  goal_.span = {high > low ? high - low : std::max(1.0, std::abs(low))};
}

void DirectSearch::round(const std::vector<std::pair<double, std::size_t>>& starts, std::size_t budget) {
  std::vector<std::vector<Record>> found(starts.size());
  const auto n = static_cast<Eigen::Index>(space_.dimension());
  Box box{.lower = Eigen::VectorXd::Zero(n), .upper = Eigen::VectorXd(n)};
  for (Eigen::Index axis = 0; axis < n; ++axis) box.upper[axis] = space_.ceiling(static_cast<std::size_t>(axis));
  const std::uint64_t first_task = tasks_;
  tasks_ += starts.size();
  run_.workers.run(starts.size(), [&](std::size_t i) {
    const Sample& start = samples_[starts[i].second];
    found[i] = run_direct(run_.archive, samples_,
                          {.algorithm = run_.options.algorithm,
                           .goal = goal_,
                           .start = {.unit = start.unit, .combination = start.combination},
                           .box = box,
                           .budget = budget / starts.size(),
                           .seed = run_.options.seed * 0x9E3779B97F4A7C15ULL + first_task + i},
                          run_.options.stop);
  });
  for (const std::vector<Record>& records : found) {
    for (const Record& record : records) samples_.add(record);
  }
  report();
}

void DirectSearch::visit_neighbours() {
  while (left() > 0 && !stopped() && !samples_.front().empty()) {
    const std::size_t best = samples_.front().front();
    std::vector<Candidate> candidates = unknown_neighbours(samples_, best);
    if (candidates.size() > left()) candidates.resize(left());
    if (candidates.empty()) return;
    evaluate(candidates);
    if (samples_.front().front() == best) return;
  }
}

StopReason DirectSearch::run() {
  scatter();
  std::vector<std::pair<double, std::size_t>> starts = best_of_combinations();
  const bool discrete = space_.has_grid() || space_.combinations() > 1;
  const std::size_t reserve = discrete ? left() / 10 : 0;
  auto rounds = static_cast<std::size_t>(std::bit_width(starts.size()));
  while (rounds > 0 && !starts.empty() && left() > reserve && !stopped()) {
    // never less than one design a run: with more combinations than budget only the best starts run
    const std::size_t budget = (left() - reserve) / rounds;
    starts.resize(std::clamp<std::size_t>(starts.size(), 1, std::max<std::size_t>(budget, 1)));
    round(starts, std::max<std::size_t>(budget, 1));
    starts = best_of_combinations();
    --rounds;
    starts.resize(std::min(starts.size(), std::size_t{1} << (rounds > 0 ? rounds - 1 : 0)));
  }
  visit_neighbours();
  if (stopped()) return StopReason::interrupted;
  return left() == 0 ? StopReason::evaluation_limit : StopReason::converged;
}

}  // namespace

StopReason search_directly(const EngineRun& run) {
  return DirectSearch{run}.run();
}

}  // namespace coilwright::sizing
