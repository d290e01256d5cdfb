#pragma once

#include <span>
#include <vector>

namespace coilwright::measurement::signals {

/// Whittaker's smoother with third differences: minimises sum (y - z)^2 + penalty h^6 sum (z''')^2 over the samples, h
/// the mean interval. Its gain is 1 / (1 + penalty (2 sin(w h / 2))^6): half at w h = penalty^(-1/6).
/// Source: P. H. C. Eilers, Anal. Chem. 75 (2003) 3631, with divided differences for uneven samples.
[[nodiscard]] std::vector<double> smoothed(std::span<const double> times, std::span<const double> values,
                                           double penalty);

/// Number of samples over which the smoother averages: penalty^(1/6).
[[nodiscard]] double smoothing_length(double penalty);

/// Consecutive samples without a jump.
struct SampledSegment {
  std::span<const double> times;
  std::span<const double> values;
};

/// The penalty of least expected error under white noise of `sigma`, one for all segments: the minimum of Mallows' C_p
/// over a grid of half decades from 1 to 1e12. Above that the equations are ill-conditioned.
[[nodiscard]] double best_penalty(std::span<const SampledSegment> segments, double sigma);

/// First and second derivative of smoothed values by divided differences of three samples; the first and the last
/// sample take over the values of their neighbours.
struct Derivatives {
  std::vector<double> first;
  std::vector<double> second;
};
[[nodiscard]] Derivatives derivatives(std::span<const double> times, std::span<const double> values);

}  // namespace coilwright::measurement::signals
