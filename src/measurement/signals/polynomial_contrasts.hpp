#pragma once

#include <span>
#include <vector>

namespace coilwright::measurement::signals {

/// A section of a record to which polynomials are fitted.
struct Curve {
  std::vector<double> at;      ///< abscissae, not decreasing; equal ones are repeated measurements
  std::vector<double> values;  ///< as many as abscissae
};

/// Window and degree of the local polynomials.
struct ContrastShape {
  int points{};  ///< samples in a window, > degree + 1
  int degree{};  ///< degree of the polynomials to which the contrast is blind; >= 0
};

/// For every window of `shape.points` neighbours the residual of the least-squares polynomial at the middle sample,
/// scaled so that white noise of standard deviation s gives values of standard deviation s. With one point more than
/// coefficients this is the divided difference. Windows in which the polynomial always passes through the middle sample
/// are left out.
[[nodiscard]] std::vector<double> contrasts(const Curve& curve, ContrastShape shape);

/// Sum over all lags of the squared autocorrelation of those contrasts in evenly sampled white noise: n of them carry
/// as much information about its variance as n / (this sum) independent values.
[[nodiscard]] double contrast_redundancy(ContrastShape shape);

}  // namespace coilwright::measurement::signals
