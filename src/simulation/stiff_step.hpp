#pragma once

#include <optional>

#include "coilwright/actuator/model/model.hpp"
#include "frozen_contact.hpp"
#include "packed_state.hpp"
#include "rosenbrock_step.hpp"
#include "step_error.hpp"

namespace coilwright::simulation {

/// Steps while faces are pressed together that would ring faster than the motion changes: Rodas5P on the motion with
/// every face held as it is (FrozenContact), to where the first faces begin or cease to push. For models without
/// effects that act (Model::has_terms).
class StiffStep {
 public:
  struct Taken {
    double duration{};       ///< s; 0: none, where the explicit pair may as well take steps that are so short
    double next{};           ///< how long the next step may be, s
    bool contact_changed{};  ///< at its end, or at once
  };

  StiffStep(const actuator::Model& model, const StepTolerance& tolerance);

  /// A step of `duration` (s), or as long as its error allows; `is_given`: that long whatever its error.
  Taken take(const PackedState& start, const PackedState& slopes, const actuator::CoilCurrents& currents,
             const mechanics::JointVector& applied, double duration, bool is_given);
  /// Of the step taken: angles and rates at its end, and at `share` of it from 0 to 1.
  [[nodiscard]] const MotionVector& end() const { return step_.end(); }
  [[nodiscard]] MotionVector at(double share) const { return step_.at(share); }

 private:
  [[nodiscard]] double ringing(const PackedState& start) const;
  [[nodiscard]] double error(const MotionVector& slopes, double duration) const;
  [[nodiscard]] std::optional<double> changed_share(const FrozenContact& contact, int joint, const MotionVector& start,
                                                    double duration) const;
  [[nodiscard]] double first_change(const FrozenContact& contact, const MotionVector& start, double duration) const;

  const actuator::Model& model_;
  StepTolerance tolerance_;
  mechanics::JointVector squared_frequencies_;  // of each joint alone while its faces push, 1/s^2
  RosenbrockStep step_;
};

}  // namespace coilwright::simulation
