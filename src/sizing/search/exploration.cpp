#include "sizing/search/exploration.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "sizing/sampling/random.hpp"

namespace coilwright::sizing {
namespace {

// Of the designs bred on wide spaces, those that differ from their parent in one coordinate.
constexpr double probe_share = 0.5;
// A probe is promising if its objectives lie at most this part of the front's range behind the front.
constexpr double promising_excess = 0.1;

// The samples that differential evolution recombines: the front or, while it is small, the best samples by violation
// and then by the sum of the normalised objectives.
std::vector<std::size_t> parents_of(const Samples& samples) {
  if (samples.front().size() >= 8) return samples.front();
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < samples.size(); ++i) order.push_back(i);
  const auto rank = [&](std::size_t i) {
    const Sample& sample = samples[i];
    double sum = 0;
    if (sample.feasible()) {
      for (std::size_t k = 0; k < sample.values.size(); ++k) {
        sum += (sample.values[k] - samples.frame().ideal[k]) / (samples.frame().nadir[k] - samples.frame().ideal[k]);
      }
    }
    return std::tuple{!sample.evaluated, sample.violation, sum, i};
  };
  const std::size_t kept = std::min<std::size_t>(order.size(), 12);
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(kept), {}, rank);
  order.resize(kept);
  return order;
}

}  // namespace

void Exploration::learn(const Proposal& proposal, const Sample& sample) {
  if (proposal.source != ProposalSource::evolution || proposal.index == 0) return;
  explorer_.count_probe(proposal.index - 1, sample.feasible() && samples_.excess(sample.values) < promising_excess);
}

Exploration::Exploration(const Samples& samples, std::uint64_t seed, std::mt19937_64& random)
    : samples_{samples}, random_{random}, explorer_{samples.space(), seed} {}

ProposalBatch Exploration::filled(ProposalBatch batch, std::size_t size, double evolution_share) {
  const DesignSpace& space = samples_.space();
  const std::vector<std::size_t> parents = parents_of(samples_);
  // In many tries some fail where limits exclude most designs.
  const auto most_misses = std::max<std::size_t>(32, size / 2);
  std::size_t misses = 0;
  while (batch.size() < size && !exhausted_) {
    const bool evolve = uniform(random_) < evolution_share && parents.size() >= 3;
    auto source = evolve ? ProposalSource::evolution : ProposalSource::sobol;
    std::optional<UnitPoint> point;
    std::size_t index = 0;
    if (space.dimension() > 0 && misses < most_misses) {
      if (evolve && space.is_wide() && uniform(random_) < probe_share) {
        if (std::optional<Explorer::Probe> made = explorer_.probe(samples_, parents)) {
          point = std::move(made->point);
          index = made->axis + 1;
        }
      } else {
        point = evolve ? explorer_.evolved_point(samples_, parents) : explorer_.sobol_point(samples_);
      }
    } else {
      source = ProposalSource::sobol;
      if (space.design_count() > 0) point = explorer_.next_of_grid(samples_);
      if (!point) exhausted_ = true;
    }
    if (!point || !batch.add({.point = std::move(*point), .source = source, .index = index})) ++misses;
  }
  return batch;
}

ProposalBatch Exploration::next_of_grid(std::size_t count) {
  ProposalBatch batch{samples_.space()};
  while (batch.size() < count) {
    std::optional<UnitPoint> point = explorer_.next_of_grid(samples_);
    if (!point) break;
    batch.add({.point = std::move(*point), .source = ProposalSource::sobol, .index = 0});
  }
  return batch;
}

}  // namespace coilwright::sizing
