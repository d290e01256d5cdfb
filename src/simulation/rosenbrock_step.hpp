#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>

#include "coilwright/mechanics/planar_chain.hpp"
#include "rosenbrock_method.hpp"

namespace coilwright::simulation {

/// Angles over rates, (2 n), and their slopes; no heap.
using MotionVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 2 * mechanics::max_joints, 1>;

/// One step of Rodas5P on a chain's equation of motion theta'' = F(theta, theta').
///
/// The Jacobian of angles and rates has the blocks 0, 1, -M^-1 K, -M^-1 B, so each stage solves (n, n) instead of
/// (2n, 2n): with s = 1 / (gamma h), (s^2 M + s B + K) x = M r_rates + (s M + B) r_angles for the angles' part x, and
/// the rates' part is s x - r_angles.
class RosenbrockStep {
 public:
  static constexpr auto& method = rodas5p;

  /// From `start` with the slopes `start_slopes` over `duration` (s, > 0). `slopes`: those of the equation about the
  /// start, M, B and K above. `derive(values)` gives the slopes of any angles and rates.
  template <typename Derive>
  void take(const MotionVector& start, const MotionVector& start_slopes, const mechanics::ChainSlopes& slopes,
            double duration, const Derive& derive) {
    const auto n = static_cast<int>(start.size() / 2);
    const double scale = 1.0 / (method.gamma * duration);
    const mechanics::JointMatrix& mass = slopes.by_acceleration;
    const mechanics::JointMatrix damped = scale * mass + slopes.by_rate;
    const Eigen::PartialPivLU<mechanics::JointMatrix> factors(scale * damped + slopes.by_angle);
    start_ = start;
    end_ = start;
    for (int i = 0; i < method.stages; ++i) {
      if (i > 0) move_place(i);
      MotionVector right = i == 0 ? start_slopes : derive(end_);
      for (int j = 0; j < i; ++j) right += method.carry[i][j] / duration * stages_[j];
      const mechanics::JointVector torques = mass.lazyProduct(right.tail(n)) + damped.lazyProduct(right.head(n));
      stages_[i].resize(start.size());
      stages_[i].head(n) = factors.solve(torques);
      stages_[i].tail(n) = scale * stages_[i].head(n) - right.head(n);
    }
    end_ += error();
  }

  [[nodiscard]] const MotionVector& end() const { return end_; }
  /// Of the end, less that of the embedded method of one order less.
  [[nodiscard]] const MotionVector& error() const { return stages_.back(); }
  /// Angles and rates inside the step, at `share` of its duration from 0 to 1.
  [[nodiscard]] MotionVector at(double share) const {
    MotionVector bend = MotionVector::Zero(end_.size());
    for (int term = method.dense_terms - 1; term >= 0; --term) {
      bend *= share;
      for (int j = 0; j < method.stages; ++j) bend += method.dense[term][j] * stages_[j];
    }
    return (1.0 - share) * start_ + share * (end_ + (1.0 - share) * bend);
  }

 private:
  void move_place(int stage) {
    if (stage >= method.own_places) {
      end_ += stages_[stage - 1];
      return;
    }
    end_ = start_;
    for (int j = 0; j < stage; ++j) end_ += method.place[stage][j] * stages_[j];
  }

  MotionVector start_;
  MotionVector end_;
  std::array<MotionVector, method.stages> stages_;
};

}  // namespace coilwright::simulation
