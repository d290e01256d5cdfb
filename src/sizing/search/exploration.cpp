#include "sizing/search/exploration.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "sizing/sampling/random.hpp"

namespace coilwright::sizing {
namespace {

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

Exploration::Exploration(const Samples& samples, std::uint64_t seed, std::mt19937_64& random)
    : samples_{samples}, random_{random}, explorer_{samples.space(), seed} {}

ProposalBatch Exploration::filled(ProposalBatch batch, std::size_t size, double evolution_share) {
  const DesignSpace& space = samples_.space();
  const std::vector<std::size_t> parents = parents_of(samples_);
  int misses = 0;
  while (batch.size() < size && !exhausted_) {
    const bool evolve = uniform(random_) < evolution_share && parents.size() >= 3;
    auto source = evolve ? ProposalSource::evolution : ProposalSource::sobol;
    std::optional<UnitPoint> point;
    if (space.dimension() > 0 && misses < 32) {
      point = evolve ? explorer_.evolved_point(samples_, parents) : explorer_.sobol_point(samples_);
    } else {
      source = ProposalSource::sobol;
      if (space.design_count() > 0) point = explorer_.next_of_grid(samples_);
      if (!point) exhausted_ = true;
    }
    if (!point || !batch.add({.point = std::move(*point), .source = source, .index = 0})) ++misses;
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
