#include "measurement/identification/model_error.hpp"

#include <algorithm>
#include <cmath>

#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {

bool is_far_from_noise(const FittedHypothesis& fitted) {
  return fitted.whiteness.level > search_effort.near_the_noise;
}

double model_error_of(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted) {
  return is_far_from_noise(fitted) ? std::sqrt(overdispersion_of(runs, fitted)) : 1.0;
}

void set_model_error(std::span<replay::PreparedRun> runs, double model_error) {
  for (replay::PreparedRun& prepared : runs) prepared.model_error = model_error;
}

bool is_same_model_error(double one, double other) {
  constexpr double factor = 1.25;  // numbers hardly depend on the weight of their priors
  return std::max(one, other) <= factor * std::min(one, other);
}

}  // namespace coilwright::measurement::identification
