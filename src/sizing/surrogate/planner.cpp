#include "sizing/surrogate/planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sizing/sampling/random.hpp"

namespace coilwright::sizing {
namespace {

// Attempts of a round at niches, for a front (of 16 designs).
constexpr std::size_t niche_attempts = 3;

// Nodes of a model after a failure stand this far apart: other scales in turn, up to the whole space.
double apart(int failures) {
  constexpr std::array<double, 5> distances{0.0, 0.03, 0.1, 0.01, 0.3};
  return distances[static_cast<std::size_t>(failures) % distances.size()];
}

// Normalised distance below the reference the front has so far; gaps are boxes in this frame.
double reference_of(const FrontFrame& frame, std::size_t i) {
  return frame.nadir[i] + 0.1 * (frame.nadir[i] - frame.ideal[i]);
}

// The box below an upper bound in which points are not dominated by its neighbours; nothing if it has no volume.
struct Gap {
  Objectives origin, span;
  double volume = 1;
};

Gap gap_below(const Samples& samples, const UpperBound& bound) {
  const FrontFrame& frame = samples.frame();
  Gap gap;
  for (std::size_t i = 0; i < bound.corner.size(); ++i) {
    double low = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < bound.definers.size(); ++k) {
      if (k != i && bound.definers[k] != UpperBound::none) low = std::min(low, samples[bound.definers[k]].values[i]);
    }
    low = std::max(low, frame.ideal[i]);
    if (!std::isfinite(low)) low = frame.ideal[i];
    const double high = std::min(bound.corner[i], reference_of(frame, i));
    gap.origin.push_back(low);
    gap.span.push_back(high - low);
    gap.volume *= std::max(0.0, (high - low) / (frame.nadir[i] - frame.ideal[i]));
  }
  return gap;
}

}  // namespace

Planner::Planner(const Samples& samples, std::mt19937_64& random)
    : samples_{samples}, random_{random}, anchor_failures_(samples.objective_count(), 0), niches_{samples} {}

void Planner::count_anchor(std::size_t objective, double gain) {
  if (objective >= anchor_failures_.size()) return;  // feasibility
  int& failures = anchor_failures_[objective];
  failures = gain > 1e-6 ? 0 : failures + 1;
}

std::vector<std::size_t> Planner::best_apart(const Goal& goal, std::size_t count,
                                             std::optional<std::uint64_t> combination) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    if (!sample.evaluated || (combination && sample.combination != *combination)) continue;
    const double price = goal.kind == Goal::Kind::feasibility || sample.violation == 0 ? 0 : 1 + 10 * sample.violation;
    order.emplace_back(goal.scalar(sample) + price, i);
  }
  std::ranges::sort(order);
  std::vector<std::size_t> kept;
  for (const auto& entry : order) {
    if (kept.size() == count) break;
    const std::size_t i = entry.second;
    const bool close = std::ranges::any_of(kept, [&](std::size_t k) {
      if (samples_[k].combination != samples_[i].combination) return false;
      return largest_difference(samples_[k].unit, samples_[i].unit) < 0.1;
    });
    if (!close) kept.push_back(i);
  }
  return kept;
}

// First between the gap's own neighbours; after a failure also elsewhere: other levels, other basins.
Region Planner::gap_region(const Goal& goal, const UpperBound& bound) {
  std::vector<std::size_t> definers;
  for (const std::size_t definer : bound.definers) {
    if (definer != UpperBound::none) definers.push_back(definer);
  }
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random_() % count); };
  if (bound.failures > 0 && uniform(random_) < 0.5) {
    const std::uint64_t combinations = samples_.space().combinations();
    const bool any = combinations == 1 || uniform(random_) < 0.5;
    const std::uint64_t drawn = random_() % combinations;
    const std::vector<std::size_t> others = best_apart(goal, 3, any ? std::nullopt : std::optional{drawn});
    if (!others.empty()) {
      const std::size_t chosen = others[pick(others.size())];
      return {.from = chosen, .to = chosen, .margin = 1.0, .apart = apart(bound.failures), .seed = random_()};
    }
  }
  const std::size_t from = definers[pick(definers.size())];
  std::size_t to = definers[pick(definers.size())];
  for (const std::size_t other : definers) {
    if (other != from && samples_[other].combination == samples_[from].combination) to = other;
  }
  if (samples_[to].combination != samples_[from].combination) to = from;
  if (bound.failures == 0) return {.from = from, .to = to};
  return {.from = from, .to = to, .margin = 1.0, .apart = apart(bound.failures), .seed = random_()};
}

void Planner::add_gaps(std::vector<Attempt>& list, std::size_t wanted) {
  if (samples_.objective_count() < 2) return;
  const std::vector<UpperBound>& bounds = samples_.bounds().all();
  std::vector<std::pair<double, std::size_t>> order;
  std::vector<Gap> gaps;
  for (std::size_t b = 0; b < bounds.size(); ++b) {
    gaps.push_back(gap_below(samples_, bounds[b]));
    const double priority = gaps[b].volume * std::pow(0.4, bounds[b].failures);
    if (priority > 0) order.emplace_back(-priority, b);
  }
  const std::size_t kept = std::min(order.size(), wanted);
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(kept));
  for (std::size_t i = 0; i < kept; ++i) {
    const std::size_t b = order[i].second;
    Attempt attempt{.goal = {.kind = Goal::Kind::gap, .origin = gaps[b].origin, .span = gaps[b].span, .to_beat = 0.999},
                    .way = Way::gap,
                    .which = b};
    attempt.region = gap_region(attempt.goal, bounds[b]);
    list.push_back(std::move(attempt));
  }
}

// The scale of a single objective: from the best to the median of all designs. (A front of one design has no range.)
double Planner::single_span() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (samples_[i].evaluated) values.push_back(samples_[i].values[0]);
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  const double least = std::max(1e-9, 1e-6 * std::abs(samples_.frame().ideal[0]));
  return std::max(std::abs(*middle - samples_.frame().ideal[0]), least);
}

// One objective as small as can be, the others only to break ties.
Goal Planner::anchor_goal(std::size_t objective) const {
  const FrontFrame& frame = samples_.frame();
  Goal goal{.kind = Goal::Kind::objective, .origin = frame.ideal, .span = Objectives(frame.ideal.size())};
  for (std::size_t k = 0; k < goal.span.size(); ++k) {
    goal.span[k] = (frame.nadir[k] - frame.ideal[k]) * (k == objective ? 1.0 : 1e3);
  }
  if (goal.span.size() == 1) goal.span = {single_span()};
  return goal;
}

Attempt Planner::anchor(std::size_t objective, std::size_t turn, std::size_t rank) {
  Goal goal = anchor_goal(objective);
  goal.to_beat = std::numeric_limits<double>::infinity();
  for (const std::size_t member : samples_.front()) {
    goal.to_beat = std::min(goal.to_beat, goal.scalar(samples_[member]));
  }
  goal.to_beat -= 1e-7;  // less would be rounding
  const std::vector<std::size_t> starts = best_apart(goal, rank + 1, std::nullopt);
  const std::size_t start = starts[std::min(rank, starts.size() - 1)];
  Region region{.from = start, .to = start};
  if (turn > 0)
    region = {.from = start, .to = start, .margin = 1.0, .apart = apart(static_cast<int>(turn)), .seed = random_()};
  return {.goal = std::move(goal), .region = region, .way = Way::anchor, .which = objective};
}

// Half of the attempts of one objective start from the best design, each with another reach; the others, and those
// after failures, from further basins.
void Planner::add_anchors(std::vector<Attempt>& list, std::size_t wanted) {
  const std::size_t objectives = samples_.objective_count();
  for (std::size_t slot = 0; slot < wanted; ++slot) {
    const std::size_t objective = anchor_turn_++ % objectives;
    const auto turn = static_cast<std::size_t>(anchor_failures_[objective]) + slot / objectives;
    const std::size_t further = slot < wanted / 2 ? 0 : slot - wanted / 2 + 1;
    list.push_back(anchor(objective, turn, objectives == 1 ? further : turn % 6));
  }
}

std::size_t Planner::best_of(std::size_t objective) const {
  return *std::ranges::min_element(samples_.front(), {}, [&](std::size_t i) { return samples_[i].values[objective]; });
}

// An objective alone, among the designs of one level: better than the best of that level, not of all.
void Planner::add_niches(std::vector<Attempt>& list, std::size_t wanted) {
  niches_.learn();
  for (std::size_t slot = 0; slot < wanted; ++slot) {
    const std::size_t objective = niche_turn_++ % samples_.objective_count();
    const bool here = niche_turn_ / samples_.objective_count() % 2 == 0;
    const auto which = here ? Niches::Which::of_the_best : Niches::Which::elsewhere;
    const std::optional<Niches::Place> place = niches_.next(which, objective);
    if (!place) continue;
    Goal goal = anchor_goal(objective);
    goal.to_beat = std::numeric_limits<double>::infinity();
    if (place->best) {
      const Sample& best = samples_[*place->best];
      if (!best.feasible()) goal = {.kind = Goal::Kind::feasibility};
      goal.to_beat = goal.scalar(best) - 1e-7;
    }
    // Where what the model promises turns out to violate a limit again and again, it is to be built on that side too.
    const std::optional<std::size_t> first = place->failures % 2 == 1 && place->beyond ? place->beyond : place->best;
    const std::size_t start = first.value_or(best_of(objective));
    Region region{.from = start, .to = start, .level = place->level};
    if (place->failures > 0) {
      region.margin = 1.0;
      region.apart = apart(place->failures / 2);
      region.seed = random_();
    }
    list.push_back({.goal = std::move(goal), .region = region, .way = Way::niche, .which = objective});
  }
}

void Planner::add_feasibility(std::vector<Attempt>& list, std::size_t wanted) const {
  if (samples_.constraint_count() == 0) return;
  Goal goal{.kind = Goal::Kind::feasibility};
  const std::vector<std::size_t> starts = best_apart(goal, wanted, std::nullopt);
  for (const std::size_t start : starts) {
    goal.to_beat = goal.scalar(samples_[start]);
    list.push_back({.goal = goal,
                    .region = {.from = start, .to = start, .margin = 0.5},
                    .way = Way::anchor,
                    .which = samples_.objective_count()});
  }
}

std::vector<Attempt> Planner::plan(std::size_t wanted, std::size_t round) {
  std::vector<Attempt> list;
  if (samples_.feasible_count() == 0) {
    add_feasibility(list, wanted / 2);
    return list;
  }
  const std::size_t objectives = samples_.objective_count();
  if (objectives == 1) {
    const std::size_t niches = niches_.empty() ? 0 : wanted * 3 / 4;
    add_niches(list, niches);
    add_anchors(list, wanted - list.size());
    return list;
  }
  const int fewest = *std::ranges::min_element(anchor_failures_);
  const std::size_t anchors = fewest < 4 ? objectives : (round % 4 == 0 ? 1 : 0);
  add_anchors(list, std::min(anchors, wanted));
  if (!niches_.empty()) add_niches(list, std::min(niche_attempts, wanted - list.size()));
  add_gaps(list, wanted - list.size());
  return list;
}

}  // namespace coilwright::sizing
