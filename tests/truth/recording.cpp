#include "truth/recording.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "truth/random.hpp"

namespace truth {

int channel_count(Camera camera) {
  return camera == Camera::joint_angles ? 2 : 1;
}

Eigen::VectorXd camera_view(Camera camera, const UnmodelledEffects& effects, const Experiment& experiment,
                            const Trajectory& record) {
  const int columns = channel_count(camera);
  Eigen::VectorXd seen(static_cast<Eigen::Index>(record.size()) * columns);
  const double phase = 2.0 * std::numbers::pi * Random(effects.chance + experiment.number).uniform();
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double hum =
        effects.hum * std::sin(2.0 * std::numbers::pi * effects.hum_frequency * experiment.camera_times()[i] + phase);
    for (int c = 0; c < columns; ++c) {
      const double angle = camera == Camera::joint_angles ? record[i][c] : record[i][0] + record[i][1];
      seen[at++] = effects.angle_scale * angle + effects.angle_offset + effects.parallax * angle * angle + hum;
    }
  }
  return seen;
}

RecordedAngles recorded_angles(Camera camera, const Finger& finger, const UnmodelledEffects& effects,
                               const std::vector<Experiment>& runs) {
  RecordedAngles out;
  for (const Experiment& run : runs) out.push_back(camera_view(camera, effects, run, simulate(finger, effects, run)));
  return out;
}

double largest_difference(const RecordedAngles& a, const RecordedAngles& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, (a[i] - b[i]).norm() / std::sqrt(static_cast<double>(a[i].size())));
  return largest;
}

double total_difference(const RecordedAngles& a, const RecordedAngles& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum);
}

Calibration::Calibration(Camera camera, const Finger& finger, const std::vector<Experiment>& runs,
                         const RecordedAngles& nominal) {
  constexpr double change = 1e-3;
  Finger stiffer = finger;
  stiffer.stiffness *= 1.0 + change;
  Finger damper = finger;
  damper.damping *= 1.0 + change;
  by_stiffness_ = recorded_angles(camera, stiffer, {}, runs);
  by_damping_ = recorded_angles(camera, damper, {}, runs);
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    by_stiffness_[i] = (by_stiffness_[i] - nominal[i]) / change;
    by_damping_[i] = (by_damping_[i] - nominal[i]) / change;
  }
}

RecordedAngles Calibration::absorb(const RecordedAngles& moved, const RecordedAngles& nominal) const {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < moved.size(); ++i) {
    Eigen::MatrixX2d slope(moved[i].size(), 2);
    slope << by_stiffness_[i], by_damping_[i];
    normal += slope.transpose() * slope;
    right += slope.transpose() * (moved[i] - nominal[i]);
  }
  const Eigen::Vector2d change = normal.colPivHouseholderQr().solve(right);
  RecordedAngles left = moved;
  for (std::size_t i = 0; i < left.size(); ++i) left[i] -= change[0] * by_stiffness_[i] + change[1] * by_damping_[i];
  return left;
}

}  // namespace truth
