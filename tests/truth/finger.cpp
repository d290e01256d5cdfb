#include "truth/finger.hpp"

#include <algorithm>

namespace truth {

double curve_error(const CurveError& error, double angle) {
  if (error == CurveError{}) return 0.0;
  constexpr double middle = 0.4363;  // 25 degrees
  constexpr double half = 0.7854;    // 45 degrees
  const double x = std::clamp((angle - middle) / half, -1.0, 1.0);
  const double x2 = x * x;
  return error[0] * x + error[1] * (2.0 * x2 - 1.0) + error[2] * x * (4.0 * x2 - 3.0) +
         error[3] * (8.0 * x2 * (x2 - 1.0) + 1.0);
}

}  // namespace truth
