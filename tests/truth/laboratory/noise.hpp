#pragma once

#include <vector>

#include "truth/laboratory/request.hpp"
#include "truth/random.hpp"

namespace truth::laboratory {

/// Noise of the camera in one channel, with unit variance at any time:
/// white; low-passed: a filter of the first order with 10 Hz, and nothing above; pink: a sum of eight such filters with
/// corners from 0.03 to 100 Hz, equal variances, a spectrum near 1/f in between; hum: half of the variance in a line of
/// 50 Hz, whose frequency pictures alias, half white.
class Noise {
 public:
  Noise(Colour colour, Random& random);

  /// The values at increasing times, s.
  [[nodiscard]] std::vector<double> at(const std::vector<double>& times);

 private:
  Colour colour_;
  Random& random_;
};

}  // namespace truth::laboratory
