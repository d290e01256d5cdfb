#include "coilwright/sizing/problem/archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

#include "sizing/problem/design_space.hpp"
#include "sizing/problem/point_hash.hpp"

namespace coilwright::sizing {
namespace {

// One design. Its own lock lets others be evaluated at the same time, and makes a second request for the same design
// wait.
struct Slot {
  std::mutex evaluating;
  std::optional<Evaluation> evaluation;
  std::size_t number = 0;
  std::string_view proposed_by{};
};

// A caller's point may be rounded: a difference of 1e-6 of a grid step, or of the range, is accepted.
constexpr double snap_tolerance = 1e-6;

std::vector<double> legal_point(const std::vector<Variable>& variables, std::span<const double> point) {
  if (point.size() != variables.size()) {
    throw std::invalid_argument(fmt::format("point: must have {} values; got {}", variables.size(), point.size()));
  }
  std::vector<double> legal(point.size());
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Variable& variable = variables[i];
    const double step = grid_step(variable);
    legal[i] = nearest_legal(variable, point[i]);
    if (!(std::abs(legal[i] - point[i]) <= snap_tolerance * (step > 0 ? step : variable.upper - variable.lower))) {
      throw std::invalid_argument(fmt::format("point: variable '{}' must lie in [{}, {}]{}; got {}", variable.name,
                                              variable.lower, variable.upper,
                                              step > 0 ? fmt::format(" on the grid of step {}", step) : "", point[i]));
    }
  }
  return legal;
}

}  // namespace

struct Archive::Storage {
  Problem problem;
  mutable std::mutex guard;
  std::unordered_map<std::vector<double>, std::unique_ptr<Slot>, PointHash> slots;
  std::size_t evaluated = 0, numbered = 0;
  std::unordered_map<std::vector<double>, bool, PointHash> excluded;  // by the problem, or not
  std::size_t excluded_count = 0;
};

Archive::Archive(Problem problem) : storage_{std::make_unique<Storage>()} {
  validate_problem(problem);
  storage_->problem = std::move(problem);
}
Archive::Archive(Archive&&) noexcept = default;
Archive& Archive::operator=(Archive&&) noexcept = default;
Archive::~Archive() = default;

const Problem& Archive::problem() const noexcept {
  return storage_->problem;
}

Evaluation Archive::evaluate(std::span<const double> point) {
  const std::vector<double> key = legal_point(storage_->problem.variables, point);
  Slot* slot = nullptr;
  {
    const std::scoped_lock lock{storage_->guard};
    std::unique_ptr<Slot>& entry = storage_->slots[key];
    if (!entry) entry = std::make_unique<Slot>();
    slot = entry.get();
  }
  const std::scoped_lock evaluating{slot->evaluating};
  {
    const std::scoped_lock lock{storage_->guard};
    if (slot->evaluation) return *slot->evaluation;
  }
  Evaluation evaluation = evaluate_checked(storage_->problem, key);
  const std::scoped_lock lock{storage_->guard};
  slot->evaluation = std::move(evaluation);
  ++storage_->evaluated;
  return *slot->evaluation;
}

void Archive::evaluate_together(std::span<const std::vector<double>> points) {
  const Problem& problem = storage_->problem;
  std::vector<std::vector<double>> fresh;
  for (const std::vector<double>& point : points)
    if (!find(point)) fresh.push_back(legal_point(problem.variables, point));
  std::ranges::sort(fresh);
  // Not of std::ranges: Clang 14 does not take it from this standard library.
  fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
  if (fresh.empty()) return;
  std::vector<Evaluation> evaluations = problem.evaluate_together(fresh);
  if (evaluations.size() != fresh.size())
    throw std::logic_error(
        fmt::format("evaluate_together: must return {} evaluations; got {}", fresh.size(), evaluations.size()));
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    Evaluation evaluation = checked(problem, std::move(evaluations[i]));
    const std::scoped_lock lock{storage_->guard};
    std::unique_ptr<Slot>& slot = storage_->slots[fresh[i]];
    if (!slot) slot = std::make_unique<Slot>();
    if (slot->evaluation) continue;
    slot->evaluation = std::move(evaluation);
    ++storage_->evaluated;
  }
}

void Archive::number(std::span<const double> point, std::string_view proposed_by) {
  const std::vector<double> key = legal_point(storage_->problem.variables, point);
  const std::scoped_lock lock{storage_->guard};
  const auto found = storage_->slots.find(key);
  if (found == storage_->slots.end() || !found->second->evaluation || found->second->number > 0) return;
  found->second->number = ++storage_->numbered;
  found->second->proposed_by = proposed_by;
}

std::optional<Evaluation> Archive::find(std::span<const double> point) const {
  const std::vector<double> key = legal_point(storage_->problem.variables, point);
  const std::scoped_lock lock{storage_->guard};
  const auto found = storage_->slots.find(key);
  return found == storage_->slots.end() ? std::nullopt : found->second->evaluation;
}

bool Archive::excludes(std::span<const double> point) const {
  if (!storage_->problem.excluded) return false;
  const std::vector<double> key = legal_point(storage_->problem.variables, point);
  {
    const std::scoped_lock lock{storage_->guard};
    if (const auto found = storage_->excluded.find(key); found != storage_->excluded.end()) return found->second;
  }
  const bool excluded = storage_->problem.excluded(key);
  const std::scoped_lock lock{storage_->guard};
  if (storage_->excluded.emplace(key, excluded).second && excluded) ++storage_->excluded_count;
  return excluded;
}

std::size_t Archive::excluded() const {
  const std::scoped_lock lock{storage_->guard};
  return storage_->excluded_count;
}

std::size_t Archive::size() const {
  const std::scoped_lock lock{storage_->guard};
  return storage_->evaluated;
}

std::vector<Record> Archive::records() const {
  std::vector<Record> result;
  {
    const std::scoped_lock lock{storage_->guard};
    result.reserve(storage_->evaluated);
    for (const auto& [point, slot] : storage_->slots) {
      if (slot->evaluation) {
        result.push_back({.point = point,
                          .evaluation = *slot->evaluation,
                          .number = slot->number,
                          .proposed_by = slot->proposed_by});
      }
    }
  }
  std::ranges::sort(result, {}, &Record::point);
  return result;
}

std::optional<Record> Archive::best_feasible() const {
  std::optional<Record> best;
  double best_value = 0;
  for (Record& record : records()) {
    if (!is_feasible(record.evaluation)) continue;
    const double value = minimised(problem(), record.evaluation).front();
    if (best && value >= best_value) continue;
    best_value = value;
    best = std::move(record);
  }
  return best;
}

std::optional<Record> Archive::least_infeasible() const {
  std::optional<Record> least;
  const auto rank = [](const Record& record) {
    return std::pair{!record.evaluation.failure.empty(), violation(record.evaluation)};
  };
  for (Record& record : records()) {
    if (!least || rank(record) < rank(*least)) least = std::move(record);
  }
  return least;
}

std::vector<Record> Archive::front() const {
  std::vector<Record> feasible = records();
  std::erase_if(feasible, [](const Record& record) { return !is_feasible(record.evaluation); });
  const std::vector<Objectives> values = minimised(problem(), feasible);
  std::vector<std::size_t> kept = non_dominated(values);
  std::ranges::sort(kept, {}, [&](std::size_t i) { return std::tie(values[i], feasible[i].point); });
  std::vector<Record> result;
  for (const std::size_t i : kept) result.push_back(std::move(feasible[i]));
  return result;
}

Objectives minimised(const Problem& problem, const Evaluation& evaluation) {
  Objectives values = evaluation.objectives;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (problem.objectives[i].sense == Sense::maximise) values[i] = -values[i];
  }
  return values;
}

std::vector<Objectives> minimised(const Problem& problem, const std::vector<Record>& records) {
  std::vector<Objectives> result;
  result.reserve(records.size());
  for (const Record& record : records) result.push_back(minimised(problem, record.evaluation));
  return result;
}

}  // namespace coilwright::sizing
