#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "coilwright/measurement/compare/estimate.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// What a search along one number of an effect has found.
struct Valleys {
  /// A better optimum than that of the fit, to be fitted on from; nothing if there is none.
  std::optional<FittedHypothesis> better{};
  /// The ends that the interval has if all valleys count that chance cannot tell from the best; nothing if there is one
  /// valley. An infinity where they reach a physical bound, or as far as was looked.
  struct Ends {
    double lower{};
    double upper{};
  };
  std::optional<Ends> ends{};
  long simulated_runs{};
};

/// Whether the interval has an end that is so near that it may be that of one valley among many.
[[nodiscard]] bool is_suspiciously_narrow(const Estimate& estimate, double absent);

/// The cost of a number that decides when bodies meet (the gap of a loose magnet, which bounces) has many narrow
/// valleys, and a profile likelihood sees the one that it begins in. Here fits start at values from two thirds to one
/// and a half of the estimate, counted from `absent` (0 for a shape), all numbers free. In one valley they come back to
/// the estimate, and nothing is found. Where they stay, two valleys at the same distance from the truth differ by the
/// scatter of the cost from one to the next, so that the interval reaches the first start on each side whose valley is
/// worse than the best by 3.84 c and twice that scatter (of a difference). It is then as coarse as the starts are, 4 %,
/// and approximate. Refers to `fitted`, whose derivatives serve all of them. Nothing of a model that is far from the
/// noise.
[[nodiscard]] Valleys valleys_along(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                                    Eigen::Index parameter, double absent, double overdispersion);

}  // namespace coilwright::measurement::compare
