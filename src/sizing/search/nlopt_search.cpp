#include "sizing/search/nlopt_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sizing/nlopt/problem_optimisation.hpp"
#include "sizing/sampling/explorer.hpp"
#include "sizing/sampling/neighbours.hpp"
#include "sizing/sampling/unit_point.hpp"

namespace coilwright::sizing {
namespace {

class NloptSearch {
 public:
  explicit NloptSearch(const SearchContext& context)
      : context_{context},
        samples_{context.samples},
        space_{samples_.space()},
        explorer_{space_, context.options.seed},
        known_before_{context.archive.size()} {}

  StopReason run();

 private:
  [[nodiscard]] std::size_t left() const {
    const std::size_t made = context_.archive.size() - known_before_;
    return made < context_.budget ? context_.budget - made : 0;
  }
  [[nodiscard]] bool stopped() const { return context_.options.stop.stop_requested(); }
  [[nodiscard]] double merit(const Sample& sample) const;
  [[nodiscard]] std::vector<std::pair<double, std::size_t>> best_of_combinations() const;
  void evaluate(const std::vector<UnitPoint>& designs);
  void evaluate_starts();
  void round(const std::vector<std::pair<double, std::size_t>>& starts, std::size_t budget);
  void evaluate_neighbours();

  const SearchContext& context_;
  Samples& samples_;
  const DesignSpace& space_;
  Explorer explorer_;
  std::size_t known_before_;
  std::uint64_t runs_ = 0;
  Goal goal_{.kind = Goal::Kind::objective};
};

double NloptSearch::merit(const Sample& sample) const {
  if (!sample.evaluated)
    return 1e6 * (1 + sample.violation);  // behind every evaluated design whose constraints are of order 1
  return penalised(goal_.scalar(sample), sample.violation);
}

// The best sample of each combination, best first.
std::vector<std::pair<double, std::size_t>> NloptSearch::best_of_combinations() const {
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

void NloptSearch::evaluate(const std::vector<UnitPoint>& designs) {
  std::vector<std::vector<double>> points;
  for (const UnitPoint& design : designs) points.push_back(space_.point(design.unit, design.combination));
  for (const Record& record : context_.workers.evaluate(context_.archive, points, context_.options.stop))
    samples_.add(record);
  report_progress(context_);
}

// Evaluates starts for every combination of levels; the range of their objectives is the scale of the goal.
void NloptSearch::evaluate_starts() {
  const std::uint64_t combinations = std::min<std::uint64_t>(space_.combinations(), 256);
  const std::size_t wanted = std::clamp<std::size_t>(4 * combinations, 1, std::max<std::size_t>(left() / 5, 1));
  std::vector<UnitPoint> starts;
  while (starts.size() < wanted) {
    std::optional<UnitPoint> start = explorer_.sobol_point(samples_);
    if (!start) break;
    starts.push_back(std::move(*start));
  }
  evaluate(starts);
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

void NloptSearch::round(const std::vector<std::pair<double, std::size_t>>& starts, std::size_t budget) {
  std::vector<std::vector<Record>> found(starts.size());
  const Box box = whole_box(space_);
  const std::uint64_t first_run = runs_;
  runs_ += starts.size();
  context_.workers.run(starts.size(), [&](std::size_t i) {
    const Sample& start = samples_[starts[i].second];
    found[i] = optimise_on_problem(context_.archive, samples_,
                                   {.algorithm = context_.options.algorithm,
                                    .goal = goal_,
                                    .start = {.unit = start.unit, .combination = start.combination},
                                    .box = box,
                                    .budget = budget / starts.size(),
                                    .seed = context_.options.seed * 0x9E3779B97F4A7C15ULL + first_run + i},
                                   context_.options.stop);
  });
  for (const std::vector<Record>& records : found) {
    for (const Record& record : records) {
      context_.archive.number(record.point, name_of(context_.options.algorithm));
      samples_.add(record);
    }
  }
  report_progress(context_);
}

void NloptSearch::evaluate_neighbours() {
  while (left() > 0 && !stopped() && !samples_.front().empty()) {
    const std::size_t best = samples_.front().front();
    std::vector<UnitPoint> neighbours = unknown_neighbours(samples_, best);
    if (neighbours.size() > left()) neighbours.resize(left());
    if (neighbours.empty()) return;
    evaluate(neighbours);
    if (samples_.front().front() == best) return;
  }
}

StopReason NloptSearch::run() {
  evaluate_starts();
  std::vector<std::pair<double, std::size_t>> starts = best_of_combinations();
  const bool discrete = space_.has_grid() || space_.combinations() > 1;
  const std::size_t reserve = discrete ? left() / 10 : 0;
  auto rounds = static_cast<std::size_t>(std::bit_width(starts.size()));
  while (rounds > 0 && !starts.empty() && left() > reserve && !stopped()) {
    // Each run gets at least one design: with more combinations than budget only the best starts run.
    const std::size_t budget = (left() - reserve) / rounds;
    starts.resize(std::clamp<std::size_t>(starts.size(), 1, std::max<std::size_t>(budget, 1)));
    round(starts, std::max<std::size_t>(budget, 1));
    starts = best_of_combinations();
    --rounds;
    starts.resize(std::min(starts.size(), std::size_t{1} << (rounds > 0 ? rounds - 1 : 0)));
  }
  evaluate_neighbours();
  if (stopped()) return StopReason::interrupted;
  return left() == 0 ? StopReason::evaluation_limit : StopReason::converged;
}

}  // namespace

StopReason nlopt_search(const SearchContext& context) {
  return NloptSearch{context}.run();
}

}  // namespace coilwright::sizing
