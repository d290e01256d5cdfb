#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sizing/search/proposal_batch.hpp"

namespace coilwright::sizing {

/// What the designs of each proposal source gained lately (`Samples::add`), as exponential averages over the rounds.
/// The sources share a round in proportion.
class SourceGains {
 public:
  /// Takes in a round: `gains` of the first proposals, in their order.
  void learn(const std::vector<Proposal>& proposals, const std::vector<double>& gains);

  /// The part of a round that models propose, 0.5 to 0.9.
  [[nodiscard]] double model_share() const;

  /// The part of the other proposals that differential evolution makes, 0.3 to 0.85.
  [[nodiscard]] double evolution_share() const;

 private:
  [[nodiscard]] double of(ProposalSource source) const { return averages_[static_cast<std::size_t>(source)]; }

  std::array<double, proposal_sources> averages_{1, 1, 0, 1, 1};  // niches count from their first gain on
};

}  // namespace coilwright::sizing
