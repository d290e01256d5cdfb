#include "held_joints.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "crossing.hpp"

namespace coilwright::simulation {

using mechanics::JointMatrix;
using mechanics::JointVector;

// Accelerations of some joints at rest, rad/s^2: free + by_share y, linear in the shares y of friction on them.
struct HeldJoints::Pull {
  JointVector free;
  JointMatrix by_share;
};

HeldJoints::HeldJoints(const actuator::Model& model) : model_(model), signs_(JointVector::Zero(model.joints())) {}

bool HeldJoints::holds(int joint) const {
  return std::ranges::find(held_, joint) != held_.end();
}

void HeldJoints::set(const JointVector& shares, PackedState& values) const {
  const auto first = 2 * static_cast<std::size_t>(model_.joints());
  model_.set_friction(shares, {values.data() + first, values.size() - first});
}

void HeldJoints::stop(PackedState& values) const {
  const int n = model_.joints();
  Eigen::Map<Eigen::VectorXd>(values.data() + n, n)(held_).setZero();
}

HeldJoints::Pull HeldJoints::pull_on(const std::vector<int>& joints, PackedState values,
                                     const PackedDerivative& derive) const {
  // rad/s^2: a friction without any torque, of a drive that has none, counts as one that could just do this.
  constexpr double weakest = 1e-9;
  const auto count = static_cast<Eigen::Index>(joints.size());
  PackedState slopes(values.size(), 0.0);
  const auto accelerations = [&](const JointVector& shares) {
    set(shares, values);
    derive(values, slopes);
    const int n = model_.joints();
    return JointVector(Eigen::Map<const Eigen::VectorXd>(slopes.data() + n, n)(joints));
  };
  JointVector shares = signs_;
  for (const int joint : joints) shares[joint] = 0.0;
  Pull out{.free = accelerations(shares), .by_share = JointMatrix(count, count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    double& share = shares[joints[static_cast<std::size_t>(k)]];
    share = 1.0;
    out.by_share.col(k) = accelerations(shares) - out.free;
    out.by_share(k, k) -= weakest;
    share = 0.0;
  }
  return out;
}

void HeldJoints::decide(const PackedState& values, int slipping, const PackedDerivative& derive) {
  const int n = model_.joints();
  signs_ = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n).cwiseSign();
  held_.clear();
  std::vector<int> resting;
  for (int j = 0; j < n; ++j)
    if (signs_[j] == 0.0) resting.push_back(j);
  if (resting.empty()) return;
  const Pull pull = pull_on(resting, values, derive);
  // Gauss and Seidel's method for the shares, each within its bounds: it converges, since M is positive definite.
  constexpr int most = 1000;
  JointVector shares = JointVector::Zero(pull.free.size());
  double moved = 1.0;
  for (int sweep = 0; sweep < most && moved > 1e-14; ++sweep) {
    moved = 0.0;
    for (Eigen::Index k = 0; k < shares.size(); ++k) {
      const double left = pull.free[k] + pull.by_share.row(k).dot(shares);
      const double share = std::clamp(shares[k] - left / pull.by_share(k, k), -1.0, 1.0);
      moved = std::max(moved, std::abs(share - shares[k]));
      shares[k] = share;
    }
  }
  for (Eigen::Index k = 0; k < shares.size(); ++k) {
    const int joint = resting[static_cast<std::size_t>(k)];
    if (std::abs(shares[k]) < 1.0 && joint != slipping)
      held_.push_back(joint);
    else
      signs_[joint] = std::copysign(1.0, shares[k]);
  }
}

JointVector HeldJoints::shares(PackedState values, const PackedDerivative& derive) const {
  stop(values);
  const Pull pull = pull_on(held_, std::move(values), derive);
  const JointVector found = pull.by_share.partialPivLu().solve(-pull.free);
  JointVector out = signs_;
  for (std::size_t k = 0; k < held_.size(); ++k) out[held_[k]] = found[static_cast<Eigen::Index>(k)];
  return out;
}

JointVector HeldJoints::excess(const PackedState& values, const PackedDerivative& derive) const {
  const int n = model_.joints();
  JointVector out = -signs_.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(values.data() + n, n));
  if (held_.empty()) return out;
  const JointVector needed = shares(values, derive);
  for (const int joint : held_) out[joint] = std::abs(needed[joint]) - 1.0;
  return out;
}

std::optional<HeldJoints::Change> HeldJoints::first_change(double begin, std::span<const double> times,
                                                           const StateAt& state_at,
                                                           const DerivativeAt& derivative_at) const {
  if (!model_.holds_joints()) return std::nullopt;
  const auto excess_at = [&](double time) { return excess(state_at(time), derivative_at(time)); };
  for (const double time : times) {
    double end = time;
    std::optional<Change> first;
    JointVector last = excess_at(end);
    for (int j = 0; j < model_.joints(); ++j) {
      if (!(last[j] > 0.0)) continue;
      end = crossing(begin, end, [&](double at) { return excess_at(at)[j]; });
      last = excess_at(end);
      first = {.time = end, .joint = j, .slips = holds(j)};
    }
    if (first) return first;
    begin = time;
  }
  return std::nullopt;
}

}  // namespace coilwright::simulation
