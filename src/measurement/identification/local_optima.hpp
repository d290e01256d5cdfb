#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/identification/estimate.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// What a search along one number of an effect has found.
struct LocalOptima {
  /// A better optimum than that of the fit, to be fitted on from; nothing if there is none.
  std::optional<FittedHypothesis> better{};
  /// The ends that the interval has if all local optima count that chance cannot tell from the best; nothing if there
  /// is one local optimum. An infinity where they reach a physical bound, or as far as was looked.
  struct Ends {
    double lower{};
    double upper{};
  };
  std::optional<Ends> ends{};
};

/// Whether the interval has an end that is so near that it may be that of one local optimum among many.
[[nodiscard]] bool is_suspiciously_narrow(const Estimate& estimate, double absent);

/// The cost of a number that decides when bodies meet (the gap of a loose magnet, which bounces) has many narrow
/// local optima, and a profile likelihood sees the one that it begins in. Here fits start at values from two thirds to
/// one and a half of the estimate, counted from `absent` (0 for a shape), all numbers free. In one local optimum they
/// come back to the estimate, and nothing is found. Where they stay, two local optima at the same distance from the
/// truth differ by the scatter of the cost from one to the next, so that the interval reaches the first start on each
/// side whose local optimum is worse than the best by 3.84 c and twice that scatter (of a difference). It is then as
/// coarse as the starts are, 4 %, and approximate. Refers to `fitted`, whose derivatives serve all of them. Nothing of
/// a model that is far from the noise.
[[nodiscard]] LocalOptima local_optima_along(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                                             Eigen::Index parameter, double absent, double overdispersion);

/// What was found along the numbers of effects whose intervals are those of one local optimum among many, kept from one
/// optimum to the next: such a number has no profile, and its interval is what was found.
class OptimaAlongNumbers {
 public:
  /// Looks along each such number of `fitted`, whose estimates these are, as often as SearchEffort::optima_searches
  /// says; after that it does nothing. The best optimum that is better than that of the fit; nothing if there is none.
  std::optional<FittedHypothesis> look_for(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                                           const std::vector<Estimate>& estimates, double overdispersion);

  /// Whether the number has many, as far as was looked.
  [[nodiscard]] bool are_along(Eigen::Index parameter) const { return ends_.contains(parameter); }

  /// Gives those numbers the intervals that were found.
  void set_intervals(std::vector<Estimate>& estimates) const;

 private:
  int searches_ = 0;
  std::map<Eigen::Index, LocalOptima::Ends> ends_{};
};

}  // namespace coilwright::measurement::identification
