#pragma once

#include <Eigen/Core>
#include <vector>

#include "truth/camera.hpp"
#include "truth/motion.hpp"

namespace truth {

[[nodiscard]] int channels(Camera camera);

/// What the camera shows of a motion, rad, channels of a sample side by side, without noise.
[[nodiscard]] Eigen::VectorXd observed(Camera camera, const Quirks& quirks, const Experiment& experiment,
                                       const Record& record);

/// A motion a run, as the camera shows it.
using Films = std::vector<Eigen::VectorXd>;
[[nodiscard]] Films film(Camera camera, const Finger& finger, const Quirks& quirks,
                         const std::vector<Experiment>& runs);

/// Rms difference in the run where it is largest, rad.
[[nodiscard]] double largest_difference(const Films& a, const Films& b);

/// Norm of the difference over all samples of all runs, rad.
[[nodiscard]] double whole_difference(const Films& a, const Films& b);

/// What the declared stiffness and damping can do to a motion, to first order.
class Calibration {
 public:
  Calibration(Camera camera, const Finger& finger, const std::vector<Experiment>& runs, const Films& nominal);

  /// `moved`, brought as close to `nominal` as both can, all runs together.
  [[nodiscard]] Films absorb(const Films& moved, const Films& nominal) const;

 private:
  Films by_stiffness_;
  Films by_damping_;
};

}  // namespace truth
