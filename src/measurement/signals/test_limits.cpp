#include "measurement/signals/test_limits.hpp"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <cmath>

namespace coilwright::measurement::signals {

double energy_limit(const SumOfSquares& sum, double chance) {
  const double mean = sum.count + sum.allowed_energy;
  const double freedom = mean * mean / (sum.count + 2.0 * sum.allowed_energy);
  if (std::isinf(sum.degrees_of_freedom)) {
    const boost::math::gamma_distribution<double> distribution(0.5 * freedom, 2.0);
    return mean / freedom * boost::math::quantile(boost::math::complement(distribution, chance));
  }
  const boost::math::fisher_f_distribution<double> distribution(freedom, sum.degrees_of_freedom);
  return mean * boost::math::quantile(boost::math::complement(distribution, chance));
}

void PooledEnergy::add(double energy, const SumOfSquares& sum) {
  const double count = sum.count;
  const double known = sum.degrees_of_freedom;
  energy_ += energy;
  count_ += count;
  allowed_ += sum.allowed_energy;
  if (std::isinf(known)) {
    mean_ += count;
    variance_ += 2.0 * count;
  } else {
    // Moments of Fisher's F; runs of at least 64 samples have at least 32 degrees of freedom.
    mean_ += count * known / (known - 2.0);
    variance_ += 2.0 * count * known * known * (count + known - 2.0) / ((known - 2.0) * (known - 2.0) * (known - 4.0));
  }
}

double PooledEnergy::limit(double chance) const {
  const double mean = mean_ + allowed_;
  const double variance = variance_ + 4.0 * allowed_;
  const boost::math::gamma_distribution<double> distribution(mean * mean / variance, variance / mean);
  return boost::math::quantile(boost::math::complement(distribution, chance));
}

}  // namespace coilwright::measurement::signals
