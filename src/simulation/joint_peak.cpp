#include "joint_peak.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::simulation {
namespace {

// The angle of joint j where it turns round inside the last step, by the stepper's dense output. An angle at a turning
// point errs by the square of the time's error: eight halvings of a secant's bracket leave 1e-5 of the swing in a step.
double turning_angle(const Stepper& stepper, int j, double first_rate, double last_rate) {
  double low = stepper.previous_time();
  double high = stepper.time();
  double time = low + (high - low) * first_rate / (first_rate - last_rate);
  for (int i = 0; i < 8; ++i) {
    (stepper.at(time).rates[j] * first_rate > 0.0 ? low : high) = time;
    time = 0.5 * (low + high);
  }
  return stepper.at(time).angles[j];
}

}  // namespace

JointPeak::JointPeak(const State& start) : before_(start), angle_(start.angles.lpNorm<Eigen::Infinity>()) {}

void JointPeak::add(const Stepper& stepper, const State& now) {
  const double span = stepper.time() - stepper.previous_time();
  for (int j = 0; j < static_cast<int>(now.angles.size()); ++j) {
    const double ends = std::max(std::abs(now.angles[j]), std::abs(before_.angles[j]));
    angle_ = std::max(angle_, ends);
    const double first = before_.rates[j];
    const double last = now.rates[j];
    if (first * last >= 0.0) continue;
    // Most steps cannot reach beyond the largest angle so far: a joint that rattles on its stop, a motion that dies.
    if (ends + span * std::max(std::abs(first), std::abs(last)) <= angle_) continue;
    angle_ = std::max(angle_, std::abs(turning_angle(stepper, j, first, last)));
  }
  before_ = now;
}

}  // namespace coilwright::simulation
