#include "settling_detector.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

namespace coilwright::simulation {
namespace {

constexpr double standing = 1e-4;  // of the change

// How long a motion has to be watched, s: until all its parts have died down to 1/e, or shown that they are small.
double patience(const LinearSystem& system) {
  double longest = 0.0;
  for (const std::complex<double> value : system.eigenvalues()) {
    const double decay = value.real() < 0.0 ? -1.0 / value.real() : std::numeric_limits<double>::infinity();
    if (!system.sticks)
      longest = std::max(longest, decay);
    else if (value.imag() == 0.0)
      longest = std::max(longest, 3.0 * decay);
    else  // friction may end what nothing else damps; an oscillation of every joint shows within its period
      longest = std::max(longest, std::min(3.0 * decay, 3.0 * std::numbers::pi / std::abs(value.imag())));
  }
  return longest;
}

}  // namespace

SettlingDetector::SettlingDetector(const LinearSystem& system, Spec spec)
    : spec_(std::move(spec)),
      sticks_(system.sticks),
      patience_(patience(system)),
      since_(spec_.start),
      pose_(spec_.equilibrium) {}

bool SettlingDetector::near_equilibrium(const mechanics::JointVector& angles) const {
  return std::abs(angles.sum() - spec_.equilibrium.sum()) <= 0.5 * spec_.band * spec_.change;
}

bool SettlingDetector::has_not_moved(const mechanics::JointVector& angles) {
  if ((angles - pose_).lpNorm<Eigen::Infinity>() <= standing * spec_.change) return true;
  pose_ = angles;
  return false;
}

std::optional<mechanics::JointVector> SettlingDetector::observe(double time, const mechanics::JointVector& angles) {
  if (!(sticks_ ? has_not_moved(angles) : near_equilibrium(angles))) since_ = time;
  if (time - since_ < patience_) return std::nullopt;
  return sticks_ ? angles : spec_.equilibrium;
}

}  // namespace coilwright::simulation
