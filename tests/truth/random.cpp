#include "truth/random.hpp"

#include <cmath>
#include <numbers>

namespace truth {

double Random::log_uniform(double lower, double upper) {
  return lower * std::exp(uniform() * std::log(upper / lower));
}

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  const double angle = 2.0 * std::numbers::pi * uniform();
  has_spare_ = true;
  spare_ = radius * std::sin(angle);
  return radius * std::cos(angle);
}

}  // namespace truth
