#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "packed_state.hpp"

namespace coilwright::simulation {

/// The joints that dry friction holds at rest, and the ways in which the others slide. Between two changes of these a
/// motion under Coulomb's law is smooth: friction keeps its sign where a joint slides, and a held joint does not move,
/// whatever its friction has to be for that.
class HeldJoints {
 public:
  /// A joint that slid stops, or one that was held slips.
  struct Change {
    double time{};  ///< s
    int joint{};
    bool slips{};
  };
  using StateAt = std::function<PackedState(double time)>;
  using DerivativeAt = std::function<PackedDerivative(double time)>;

  explicit HeldJoints(const actuator::Model& model);

  /// In ascending order.
  [[nodiscard]] std::span<const int> held() const { return held_; }
  [[nodiscard]] bool holds(int joint) const;
  /// Of friction on each joint, as EffectTerm::holds_joints has it: the sign of its sliding, 0 where it is held.
  [[nodiscard]] const mechanics::JointVector& signs() const { return signs_; }

  /// Decides anew. A joint whose rate is exactly zero is held where friction suffices, and else begins to slide as it
  /// is pulled. There is one answer: the accelerations a of least a^T M a / 2 - a^T q + sum of h |a| over the joints at
  /// rest, h what each can hold (Gauss's principle). `slipping`: a joint that is known to be pulled too hard, if by no
  /// more than rounding; -1: none. `derive`: with friction as it stands in a state, and nothing else that holds a
  /// joint.
  void decide(const PackedState& values, int slipping, const PackedDerivative& derive);

  /// Of friction on all joints at `values`: signs(), and of a held joint the share of its largest friction that holds
  /// it, beyond -1 to 1 where that does not suffice.
  [[nodiscard]] mechanics::JointVector shares(PackedState values, const PackedDerivative& derive) const;
  /// The first change from `begin` to the last of `times` (s, ascending) of a motion, given by its whole state and its
  /// derivative at a time. It is looked for from each of them to the next: what comes and goes between two is not seen.
  [[nodiscard]] std::optional<Change> first_change(double begin, std::span<const double> times, const StateAt& state_at,
                                                   const DerivativeAt& derivative_at) const;
  /// Writes shares of friction to its states.
  void set(const mechanics::JointVector& shares, PackedState& values) const;
  /// Puts the rates of held joints to zero, where dense output leaves rounding.
  void stop(PackedState& values) const;

 private:
  struct Pull;
  // Of each joint: how far the share of friction that holds it is beyond 1, or how fast it slides against its sign.
  [[nodiscard]] mechanics::JointVector excess(const PackedState& values, const PackedDerivative& derive) const;
  [[nodiscard]] Pull pull_on(const std::vector<int>& joints, PackedState values, const PackedDerivative& derive) const;

  const actuator::Model& model_;
  std::vector<int> held_;
  mechanics::JointVector signs_;
};

}  // namespace coilwright::simulation
