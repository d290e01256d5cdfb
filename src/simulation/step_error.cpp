#include "step_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coilwright::simulation {

double StepErrorChecker::error(algebra_type& /*algebra*/, const PackedState& values, const PackedState& slopes,
                               const PackedState& errors, double step) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double allowed = this->allowed(i, std::abs(values[i]) + std::abs(step) * std::abs(slopes[i]));
    // A step so long that the equation overflowed inside it says nothing: it is too long, unless it began like that.
    if (!std::isfinite(errors[i]) && std::isfinite(allowed)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, std::abs(errors[i]) / allowed);
  }
  return largest;
}

}  // namespace coilwright::simulation
