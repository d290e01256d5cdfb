#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "measurement/compare/valleys.hpp"
#include "measurement/fit/counted.hpp"

namespace coilwright::measurement::compare {

/// What was found along the numbers of effects whose intervals are those of one valley among many, kept from one
/// optimum to the next: such a number has no profile, and its interval is what was found.
class ManyValleys {
 public:
  /// Looks along each such number of `fitted`, whose estimates these are, as often as SearchEffort::valley_searches
  /// says; after that it does nothing. The best optimum that is better than that of the fit; nothing if there is none.
  fit::Counted<std::optional<FittedHypothesis>> look_for(std::span<const replay::PreparedRun> runs,
                                                         const FittedHypothesis& fitted,
                                                         const std::vector<Estimate>& estimates, double overdispersion);

  /// Whether the number has many, as far as was looked.
  [[nodiscard]] bool are_along(Eigen::Index parameter) const { return ends_.contains(parameter); }

  /// Gives those numbers the intervals that were found.
  void set_intervals(std::vector<Estimate>& estimates) const;

 private:
  int searches_ = 0;
  std::map<Eigen::Index, Valleys::Ends> ends_{};
};

}  // namespace coilwright::measurement::compare
