#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "sizing/problem/design_space.hpp"
#include "sizing/sampling/unit_point.hpp"
#include "sizing/surrogate/planner.hpp"

namespace coilwright::sizing {

/// A design to evaluate in the next round.
struct Proposal {
  UnitPoint point;
  ProposalSource source{};
  std::size_t index{};  ///< `SubproblemTask::index`; for a probe its axis + 1; otherwise 0
};

/// Proposals of one round, each design once.
class ProposalBatch {
 public:
  /// `space` must outlive it.
  explicit ProposalBatch(const DesignSpace& space) : space_{&space} {}

  /// Adds a proposal and returns true, unless its design is in the batch already.
  bool add(Proposal proposal) {
    if (!points_.insert(space_->point(proposal.point.unit, proposal.point.combination)).second) return false;
    proposals_.push_back(std::move(proposal));
    return true;
  }

  [[nodiscard]] std::size_t size() const { return proposals_.size(); }
  [[nodiscard]] const std::vector<Proposal>& proposals() const { return proposals_; }

 private:
  const DesignSpace* space_;
  std::vector<Proposal> proposals_;
  std::set<std::vector<double>> points_;
};

}  // namespace coilwright::sizing
