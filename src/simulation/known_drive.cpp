#include "known_drive.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace coilwright::simulation {
namespace {

// Of what a drive's lag leaves in the motion, s: a slower one is as smooth as the motion.
constexpr double slowest_transient = 2e-3;

// Of a drive's state and in its unit: nearer than this to where it ends is there. Below the error of a step.
constexpr double drive_tolerance = 1e-10;

}  // namespace

KnownDrive::KnownDrive(const actuator::Model& model)
    : first_(static_cast<std::size_t>(2 * model.joints())),
      states_(static_cast<std::size_t>(model.drive_states())),
      lag_(model.drive_lag()) {}

void KnownDrive::forget() {
  fading_.clear();
  lagged_.reset();
  end_.resize(0);
}

void KnownDrive::hold(double time, Eigen::VectorXd end, PackedState& values, PackedState& slopes,
                      const PackedDerivative& derive) {
  start_time_ = time;
  if (!(lag_ > 0.0)) {
    end_ = std::move(end);
    return;
  }
  PackedState fading(values.size(), 0.0);
  for (std::size_t i = 0; i < states_; ++i) fading[first_ + i] = values[first_ + i] - end[static_cast<Eigen::Index>(i)];
  PackedState there(values.size(), 0.0);
  PackedState bent(values.size(), 0.0);
  for (int i = 0; i < 2 && lag_ < slowest_transient; ++i) {
    for (std::size_t k = 0; k < there.size(); ++k) there[k] = values[k] - fading[k];
    derive(there, bent);
    for (std::size_t k = 0; k < there.size(); ++k)
      if (k < first_ || k >= first_ + states_) fading[k] = lag_ * (bent[k] - slopes[k]);
  }
  for (std::size_t k = 0; k < there.size(); ++k) {
    values[k] -= fading[k];
    slopes[k] += fading[k] / lag_;
  }
  std::fill_n(slopes.begin() + static_cast<std::ptrdiff_t>(first_), states_, 0.0);
  fading_ = fading;
}

bool KnownDrive::knows_along_curves() const {
  return lag_ > 0.0 && lag_ <= slowest_transient;
}

void KnownDrive::follow(algebra::SmoothCurve ends, const PackedState& values, PackedState& slopes) {
  lagged_.emplace(std::move(ends), lag_, std::span(values.data() + first_, states_));
  std::fill_n(slopes.data() + first_, states_, 0.0);
}

double KnownDrive::fading_share(double time) const {
  return std::exp(-(time - start_time_) / lag_);
}

void KnownDrive::add_fading(PackedState& values, double share) const {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += share * fading_[i];
}

PackedState KnownDrive::whole(PackedState values, double time) const {
  if (!fading_.empty()) add_fading(values, fading_share(time));
  if (lagged_) lagged_->at(time, {values.data() + first_, states_});
  return values;
}

void KnownDrive::leave_what_is_integrated(PackedState& slopes, double time) const {
  if (!fading_.empty()) add_fading(slopes, fading_share(time) / lag_);
  std::fill_n(slopes.data() + first_, states_, 0.0);
}

double KnownDrive::fading_slope(int first, int count, double time) const {
  if (fading_.empty()) return 0.0;
  double sum = 0.0;
  for (int i = first; i < first + count; ++i) sum += fading_[static_cast<std::size_t>(i)];
  return -fading_share(time) / lag_ * sum;
}

bool KnownDrive::come_to_rest(PackedState& values) {
  if (end_.size() == 0) return false;
  Eigen::Map<Eigen::VectorXd> states(values.data() + first_, end_.size());
  if (!((states - end_).lpNorm<Eigen::Infinity>() <= drive_tolerance)) return false;
  states = end_;
  end_.resize(0);
  return true;
}

double KnownDrive::longest_step(const PackedState& values, const PackedState& slopes, double next) const {
  double arrival = 0.0;
  for (Eigen::Index i = 0; i < end_.size(); ++i) {
    const std::size_t at = first_ + static_cast<std::size_t>(i);
    const double away = std::abs(end_[i] - values[at]);
    if (away > drive_tolerance) arrival = std::max(arrival, slopes[at] == 0.0 ? next : away / std::abs(slopes[at]));
  }
  return arrival > 0.0 ? std::min(next, arrival) : next;
}

void KnownDrive::forget_what_is_gone(double time) {
  constexpr double gone = 1e-17;
  if (!fading_.empty() && fading_share(time) < gone) fading_.clear();
}

}  // namespace coilwright::simulation
