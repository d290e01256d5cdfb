#include "sizing/surrogate/niches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coilwright::sizing {
namespace {

// Failures that weigh as much as one rank by the best design.
constexpr double failures_per_rank = 0.5;

}  // namespace

Niches::Niches(const Samples& samples) : samples_{samples}, turns_(2 * samples.objective_count(), 0) {
  const DesignSpace& space = samples.space();
  const std::size_t objectives = samples.objective_count();
  const auto add = [&](std::optional<Level> level, std::uint64_t combination) {
    niches_.push_back({.group = groups_,
                       .level = level,
                       .combination = combination,
                       .best = std::vector<std::optional<std::size_t>>(objectives),
                       .failures = std::vector<int>(objectives, 0)});
  };
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) {
    const double spacing = space.spacing(axis);
    if (spacing == 0) continue;
    const auto levels = static_cast<std::uint64_t>(std::llround(space.ceiling(axis) / spacing)) + 1;
    if (levels > max_levels) continue;
    for (std::uint64_t k = 0; k < levels; ++k) add(Level{.axis = axis, .value = static_cast<double>(k) * spacing}, 0);
    ++groups_;
  }
  if (space.combinations() > 1 && space.combinations() <= max_levels) {
    for (std::uint64_t c = 0; c < space.combinations(); ++c) add(std::nullopt, c);
    ++groups_;
  }
}

bool Niches::holds(const Niche& niche, const Sample& sample) const {
  if (!niche.level) return sample.combination == niche.combination;
  const Level& level = *niche.level;
  return std::abs(sample.unit[level.axis] - level.value) < 0.5 * samples_.space().spacing(level.axis);
}

bool Niches::better(const Sample& sample, const Sample& than, std::size_t objective) const {
  if (sample.violation != than.violation) return sample.violation < than.violation;
  return sample.values[objective] < than.values[objective] - 1e-9 * std::abs(than.values[objective]);
}

void Niches::learn() {
  for (; learnt_ < samples_.size(); ++learnt_) {
    const Sample& sample = samples_[learnt_];
    if (!sample.evaluated) continue;
    for (Niche& niche : niches_) {
      if (!holds(niche, sample)) continue;
      for (std::size_t k = 0; k < niche.best.size(); ++k) {
        if (niche.best[k] && !better(sample, samples_[*niche.best[k]], k)) continue;
        niche.best[k] = learnt_;
        niche.failures[k] = 0;
      }
    }
  }
}

std::optional<std::size_t> Niches::least_violating(const Niche& niche, std::size_t objective) const {
  if (!niche.best[objective] || !samples_[*niche.best[objective]].feasible()) return std::nullopt;
  const double value = samples_[*niche.best[objective]].values[objective];
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    if (!sample.evaluated || sample.feasible() || !holds(niche, sample) || sample.values[objective] >= value) continue;
    if (!least || sample.violation < samples_[*least].violation) least = i;
  }
  return least;
}

bool Niches::holds_best(const Niche& niche, std::size_t objective) const {
  if (!niche.best[objective]) return false;
  const Sample& best = samples_[*niche.best[objective]];
  return best.feasible() && best.values[objective] <= samples_.frame().ideal[objective];
}

Niches::Niche* Niches::most_promising(std::size_t group, Selection selection, std::size_t objective) {
  std::vector<Niche*> order;
  for (Niche& niche : niches_) {
    if (niche.group != group || holds_best(niche, objective) != (selection == Selection::with_best)) continue;
    if (!niche.level && !niche.best[objective]) continue;  // nowhere to start from
    order.push_back(&niche);
  }
  std::ranges::stable_sort(order, [&](const Niche* a, const Niche* b) {
    if (!a->best[objective] || !b->best[objective]) return a->best[objective] && !b->best[objective];
    return better(samples_[*a->best[objective]], samples_[*b->best[objective]], objective);
  });
  Niche* chosen = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const double score = order[rank]->failures[objective] + failures_per_rank * static_cast<double>(rank);
    if (score < least) {
      least = score;
      chosen = order[rank];
    }
  }
  return chosen;
}

std::optional<Niches::Place> Niches::take_next(Selection selection, std::size_t objective) {
  std::size_t& turn = turns_[2 * objective + (selection == Selection::with_best ? 0 : 1)];
  for (std::size_t tried = 0; tried < groups_; ++tried) {
    Niche* chosen = most_promising(turn++ % groups_, selection, objective);
    if (chosen == nullptr) continue;
    return Place{.level = chosen->level,
                 .best = chosen->best[objective],
                 .least_violating = least_violating(*chosen, objective),
                 .failures = chosen->failures[objective]++};
  }
  return std::nullopt;
}

}  // namespace coilwright::sizing
