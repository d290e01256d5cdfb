#pragma once

#include <Eigen/Core>
#include <vector>

#include "truth/camera.hpp"
#include "truth/motion.hpp"

namespace truth {

[[nodiscard]] int channel_count(Camera camera);

/// Readings of the camera for a motion, rad, without noise: sample after sample, each with all its channels.
[[nodiscard]] Eigen::VectorXd camera_view(Camera camera, const UnmodelledEffects& effects, const Experiment& experiment,
                                          const Trajectory& record);

/// The readings of all runs.
using RecordedAngles = std::vector<Eigen::VectorXd>;
[[nodiscard]] RecordedAngles recorded_angles(Camera camera, const Finger& finger, const UnmodelledEffects& effects,
                                             const std::vector<Experiment>& runs);

/// The largest rms difference in one run, rad.
[[nodiscard]] double largest_difference(const RecordedAngles& a, const RecordedAngles& b);

/// Norm of the difference over all samples of all runs, rad.
[[nodiscard]] double total_difference(const RecordedAngles& a, const RecordedAngles& b);

/// The changes of a motion that stiffness and damping of the declared model cause, to first order.
class Calibration {
 public:
  Calibration(Camera camera, const Finger& finger, const std::vector<Experiment>& runs, const RecordedAngles& nominal);

  /// `moved` with the changes subtracted that bring it closest to `nominal`, one stiffness and damping for all runs.
  [[nodiscard]] RecordedAngles absorb(const RecordedAngles& moved, const RecordedAngles& nominal) const;

 private:
  RecordedAngles by_stiffness_;
  RecordedAngles by_damping_;
};

}  // namespace truth
