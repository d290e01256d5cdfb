#pragma once

#include <span>
#include <vector>

namespace coilwright::measurement::noise {

/// A stretch of a record over which polynomials are fitted.
struct Curve {
  std::vector<double> at;      ///< not falling; equal places are repeated measurements
  std::vector<double> values;  ///< as many
};

/// How a curve is looked at.
struct ContrastShape {
  int points{};  ///< samples in a window, > degree + 1
  int degree{};  ///< of the polynomial that it must not see, >= 0
};

/// Of every window of `shape.points` neighbours: what the least-squares polynomial leaves over at the middle sample,
/// scaled so that white noise of standard deviation s gives values of standard deviation s. With one point more than
/// coefficients this is the divided difference. Windows whose middle the polynomial meets exactly are left out.
[[nodiscard]] std::vector<double> contrasts(const Curve& curve, ContrastShape shape);

/// Sum over all lags of the squared autocorrelation of those contrasts in evenly sampled white noise: n of them tell as
/// much about its variance as n / (this) independent ones.
[[nodiscard]] double contrast_redundancy(ContrastShape shape);

}  // namespace coilwright::measurement::noise
