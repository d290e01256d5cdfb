#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "sizing/sampling/explorer.hpp"
#include "sizing/sampling/samples.hpp"
#include "sizing/search/proposal_batch.hpp"

namespace coilwright::sizing {

/// Fills rounds with designs that no model proposes, until every design of a grid is known.
class Exploration {
 public:
  /// `samples` and `random` must outlive it; `seed` is that of the explorer.
  Exploration(const Samples& samples, std::uint64_t seed, std::mt19937_64& random);

  /// The batch with unknown designs added up to `size`: differential evolution of good designs with probability
  /// `evolution_share`, otherwise Sobol points. Where both find only what is known, the next designs of the grid.
  [[nodiscard]] ProposalBatch filled(ProposalBatch batch, std::size_t size, double evolution_share);

  /// Takes in what became of a proposal of `filled`.
  void learn(const Proposal& proposal, const Sample& sample);

  /// At most `count` unknown designs in the order of the grid; none is left if it is empty.
  [[nodiscard]] ProposalBatch next_of_grid(std::size_t count);

  /// Whether `filled` found no further unknown design.
  [[nodiscard]] bool exhausted() const { return exhausted_; }

 private:
  const Samples& samples_;
  std::mt19937_64& random_;
  Explorer explorer_;
  bool exhausted_ = false;
};

}  // namespace coilwright::sizing
