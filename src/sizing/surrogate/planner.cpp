#include "sizing/surrogate/planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "sizing/sampling/random.hpp"
#include "sizing/surrogate/gap.hpp"

namespace coilwright::sizing {
namespace {

// Subproblems of a round (of 16 designs) in niches, for a front.
constexpr std::size_t niches_per_round = 3;

// Spacing of a model's nodes after so many failures of its subproblem: other scales in turn, up to the whole space.
double node_spacing_after(int failures) {
  constexpr std::array<double, 5> distances{0.0, 0.03, 0.1, 0.01, 0.3};
  return distances[static_cast<std::size_t>(failures) % distances.size()];
}

// How far from its segment a model is believed after so many failures.
double trust_after(int failures) {
  constexpr std::array<double, 4> reaches{0.3, 0.1, 0.03, 0.01};
  return reaches[static_cast<std::size_t>(failures / 2) % reaches.size()];
}

}  // namespace

Planner::Planner(const Samples& samples, std::mt19937_64& random)
    : samples_{samples}, random_{random}, anchor_failures_(samples.objective_count(), 0), niches_{samples} {}

void Planner::count_anchor(std::size_t objective, double gain) {
  if (objective >= anchor_failures_.size()) return;  // feasibility
  int& failures = anchor_failures_[objective];
  failures = gain > 1e-6 ? 0 : failures + 1;
}

std::vector<std::size_t> Planner::distinct_best(const Goal& goal, std::size_t count,
                                                std::optional<std::uint64_t> combination) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    if (!sample.evaluated || (combination && sample.combination != *combination)) continue;
    const double penalty =
        goal.kind == Goal::Kind::feasibility || sample.violation == 0 ? 0 : 1 + 10 * sample.violation;
    order.emplace_back(goal.scalar(sample) + penalty, i);
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

// First between the gap's own neighbours, after a failure also around other good designs, of any levels.
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
    const std::vector<std::size_t> others = distinct_best(goal, 3, any ? std::nullopt : std::optional{drawn});
    if (!others.empty()) {
      const std::size_t chosen = others[pick(others.size())];
      return {.from = chosen,
              .to = chosen,
              .margin = 1.0,
              .node_spacing = node_spacing_after(bound.failures),
              .seed = random_()};
    }
  }
  const std::size_t from = definers[pick(definers.size())];
  const bool wide = samples_.space().is_wide();
  if (bound.failures % 3 == 1 && wide) return {.from = from, .to = from, .interpolated = true};
  std::size_t to = definers[pick(definers.size())];
  for (const std::size_t other : definers) {
    if (other != from && samples_[other].combination == samples_[from].combination) to = other;
  }
  if (samples_[to].combination != samples_[from].combination) to = from;
  if (bound.failures == 0) return {.from = from, .to = to};
  // A model that promised too much is believed less far, in turn with one of other nodes.
  if (bound.failures % 2 == 1 && wide)
    return {.from = from, .to = to, .trust = trust_after(bound.failures), .seed = random_()};
  return {.from = from, .to = to, .margin = 1.0, .node_spacing = node_spacing_after(bound.failures), .seed = random_()};
}

std::vector<SubproblemTask> Planner::gaps(std::size_t wanted) {
  if (samples_.objective_count() < 2) return {};
  const std::vector<UpperBound>& bounds = samples_.bounds().all();
  std::vector<std::pair<double, std::size_t>> order;
  std::vector<Gap> all;
  for (std::size_t b = 0; b < bounds.size(); ++b) {
    all.push_back(gap_below(samples_, bounds[b]));
    const double priority = all[b].volume * std::pow(0.4, bounds[b].failures);
    if (priority > 0) order.emplace_back(-priority, b);
  }
  const std::size_t kept = std::min(order.size(), wanted);
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(kept));
  std::vector<SubproblemTask> tasks;
  for (std::size_t i = 0; i < kept; ++i) {
    const std::size_t b = order[i].second;
    SubproblemTask task{
        .goal = {.kind = Goal::Kind::gap, .origin = all[b].origin, .span = all[b].span, .to_beat = 0.999},
        .source = ProposalSource::gap,
        .index = b};
    task.region = gap_region(task.goal, bounds[b]);
    tasks.push_back(std::move(task));
  }
  return tasks;
}

// The scale of a single objective is the difference of the best and the median of all designs: a front of one design
// has no range.
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

// One objective as small as possible; the others only break ties.
Goal Planner::anchor_goal(std::size_t objective) const {
  const FrontFrame& frame = samples_.frame();
  Goal goal{.kind = Goal::Kind::objective, .origin = frame.ideal, .span = Objectives(frame.ideal.size())};
  for (std::size_t k = 0; k < goal.span.size(); ++k) {
    goal.span[k] = (frame.nadir[k] - frame.ideal[k]) * (k == objective ? 1.0 : 1e3);
  }
  if (goal.span.size() == 1) goal.span = {single_span()};
  return goal;
}

SubproblemTask Planner::anchor(std::size_t objective, std::size_t turn, std::size_t rank) {
  Goal goal = anchor_goal(objective);
  goal.to_beat = std::numeric_limits<double>::infinity();
  for (const std::size_t member : samples_.front()) {
    goal.to_beat = std::min(goal.to_beat, goal.scalar(samples_[member]));
  }
  goal.to_beat -= 1e-7;  // a smaller difference would be rounding
  const std::vector<std::size_t> starts = distinct_best(goal, rank + 1, std::nullopt);
  const std::size_t start = starts[std::min(rank, starts.size() - 1)];
  Region region{.from = start, .to = start};
  if (turn > 0)
    region = {.from = start,
              .to = start,
              .margin = 1.0,
              .node_spacing = node_spacing_after(static_cast<int>(turn)),
              .seed = random_()};
  return {.goal = std::move(goal), .region = region, .source = ProposalSource::anchor, .index = objective};
}

// For one objective half of the anchors start from the best design, each with another node spacing; the others start
// from further good designs. For a front the starts change with the failures.
std::vector<SubproblemTask> Planner::anchors(std::size_t wanted) {
  std::vector<SubproblemTask> tasks;
  const std::size_t objectives = samples_.objective_count();
  for (std::size_t slot = 0; slot < wanted; ++slot) {
    const std::size_t objective = anchor_turn_++ % objectives;
    const auto turn = static_cast<std::size_t>(anchor_failures_[objective]) + slot / objectives;
    const std::size_t further = slot < wanted / 2 ? 0 : slot - wanted / 2 + 1;
    tasks.push_back(anchor(objective, turn, objectives == 1 ? further : turn % 6));
  }
  return tasks;
}

std::size_t Planner::best_of(std::size_t objective) const {
  return *std::ranges::min_element(samples_.front(), {}, [&](std::size_t i) { return samples_[i].values[objective]; });
}

// One objective alone, among the designs of one level: the goal is to beat the best design of that level.
std::vector<SubproblemTask> Planner::niches(std::size_t wanted) {
  std::vector<SubproblemTask> tasks;
  niches_.learn();
  for (std::size_t slot = 0; slot < wanted; ++slot) {
    const std::size_t objective = niche_turn_++ % samples_.objective_count();
    const bool with_best = niche_turn_ / samples_.objective_count() % 2 == 0;
    const auto selection = with_best ? Niches::Selection::with_best : Niches::Selection::without_best;
    const std::optional<Niches::Place> place = niches_.take_next(selection, objective);
    if (!place) continue;
    Goal goal = anchor_goal(objective);
    goal.to_beat = std::numeric_limits<double>::infinity();
    if (place->best) {
      const Sample& best = samples_[*place->best];
      if (!best.feasible()) goal = {.kind = Goal::Kind::feasibility};
      goal.to_beat = goal.scalar(best) - 1e-7;
    }
    // Where proposals turn out to violate a limit again and again, the model needs nodes on that side of the limit too.
    const std::optional<std::size_t> first =
        place->failures % 2 == 1 && place->least_violating ? place->least_violating : place->best;
    const std::size_t start = first.value_or(best_of(objective));
    Region region{.from = start, .to = start, .level = place->level};
    if (place->failures > 0) {
      region.margin = 1.0;
      region.node_spacing = node_spacing_after(place->failures / 2);
      region.seed = random_();
    }
    tasks.push_back({.goal = std::move(goal), .region = region, .source = ProposalSource::niche, .index = objective});
  }
  return tasks;
}

std::vector<SubproblemTask> Planner::feasibility(std::size_t wanted) const {
  if (samples_.constraint_count() == 0) return {};
  std::vector<SubproblemTask> tasks;
  Goal goal{.kind = Goal::Kind::feasibility};
  const std::vector<std::size_t> starts = distinct_best(goal, wanted, std::nullopt);
  for (const std::size_t start : starts) {
    goal.to_beat = goal.scalar(samples_[start]);
    tasks.push_back({.goal = goal,
                     .region = {.from = start, .to = start, .margin = 0.5},
                     .source = ProposalSource::anchor,
                     .index = samples_.objective_count()});
  }
  return tasks;
}

std::vector<SubproblemTask> Planner::plan(std::size_t wanted, std::size_t round) {
  if (samples_.feasible_count() == 0) return feasibility(wanted / 2);
  std::vector<SubproblemTask> tasks;
  const auto append = [&tasks](std::vector<SubproblemTask> more) {
    for (SubproblemTask& task : more) tasks.push_back(std::move(task));
  };
  const std::size_t objectives = samples_.objective_count();
  if (objectives == 1) {
    append(niches(niches_.empty() ? 0 : wanted * 3 / 4));
    append(anchors(wanted - tasks.size()));
    return tasks;
  }
  const int fewest = *std::ranges::min_element(anchor_failures_);
  const std::size_t anchor_count = fewest < 4 ? objectives : (round % 4 == 0 ? 1 : 0);
  append(anchors(std::min(anchor_count, wanted)));
  if (!niches_.empty()) append(niches(std::min(niches_per_round, wanted - tasks.size())));
  append(gaps(wanted - tasks.size()));
  return tasks;
}

}  // namespace coilwright::sizing
