#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/study/spread.hpp"
#include "coilwright/sizing/study/yield.hpp"

/// Where builds are made and looked at: for statistics of a search and for the yield of an answer alike.
namespace coilwright::sizing {

/// A quantity of each build.
struct AskedOfBuild {
  simulation::ResultQuantity quantity;
  bool high_is_worse = true;  ///< of one that holds in every use, which end of all uses counts

  /// Whether it is not of the drawn use alone.
  [[nodiscard]] bool in_every_use() const { return quantity.in_every_use; }
};

/// A use of any build: the share of each scatter of the spread; nothing where the build's own dice count.
using Use = std::vector<std::optional<double>>;

/// The uses, beside the one that each draws, in which builds of a design are looked at for what is asked in every use:
/// ends of the laws of uses. Where a quantity of the design rises or falls all along a law, the worse end; where it
/// does not, or does not change, both. Costs a build for the middle and two for each scatter of a use; none, and no
/// use, where nothing is asked in every use.
[[nodiscard]] std::vector<Use> worst_uses(const Spread& spread, const simulation::DesignView& design,
                                          std::span<const AskedOfBuild> asked);

/// What is asked of the build at those shares, in the use that is in them and, of what is asked in every use, in the
/// worst of that one and `uses`. Where it lacks a value in one use, it has none in every use.
[[nodiscard]] Build build_of(const Spread& spread, const simulation::DesignView& design,
                             std::span<const AskedOfBuild> asked, std::span<const Use> uses,
                             std::span<const double> shares);

}  // namespace coilwright::sizing
