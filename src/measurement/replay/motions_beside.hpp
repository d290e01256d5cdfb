#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "measurement/replay/linear_motion.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::replay {

/// The motions beside a simulated one, to first order: where a window goes from another start, or with another number
/// of its model. One of them costs a slope of the model a row, where a simulation costs seven a step or more. Each row
/// of the input (at most 4 ms) is one linear motion, that of its middle, so that what faces or bristles do within a row
/// is not followed.
class MotionsBeside {
 public:
  /// Those beside `motion`, which simulate_window() gave for `model` in `window`, whose input is driven as planned
  /// (LocalNumbers::keeps_the_input()). Refers to model and motion.
  MotionsBeside(const actuator::Model& model, const Window& window, const Trajectory& motion);

  /// The motion of `other` from `start`. Nothing where it has other states.
  [[nodiscard]] std::optional<Trajectory> of(const actuator::Model& other, const simulation::State& start) const;

 private:
  struct Row {
    simulation::State middle;
    DrivingInput input;
    Eigen::VectorXd slopes{};  // of the model there
    Eigen::MatrixXd transition{}, integral{};
  };
  const actuator::Model& model_;
  const Trajectory& motion_;
  std::vector<Row> rows_;  // one fewer than those of the motion
};

}  // namespace coilwright::measurement::replay
