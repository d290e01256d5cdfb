#include "truth/film.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "truth/random.hpp"

namespace truth {

int channels(Camera camera) {
  return camera == Camera::joint_angles ? 2 : 1;
}

Eigen::VectorXd observed(Camera camera, const Quirks& quirks, const Experiment& experiment, const Record& record) {
  const int columns = channels(camera);
  Eigen::VectorXd seen(static_cast<Eigen::Index>(record.size()) * columns);
  const double phase = 2.0 * std::numbers::pi * Random(quirks.chance + experiment.number).uniform();
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double hum =
        quirks.hum * std::sin(2.0 * std::numbers::pi * quirks.hum_frequency * experiment.times[i] + phase);
    for (int c = 0; c < columns; ++c) {
      const double angle = camera == Camera::joint_angles ? record[i][c] : record[i][0] + record[i][1];
      seen[at++] = quirks.angle_scale * angle + quirks.angle_offset + hum;
    }
  }
  return seen;
}

Films film(Camera camera, const Finger& finger, const Quirks& quirks, const std::vector<Experiment>& runs) {
  Films out;
  for (const Experiment& run : runs) out.push_back(observed(camera, quirks, run, record(finger, quirks, run)));
  return out;
}

double largest_difference(const Films& a, const Films& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, (a[i] - b[i]).norm() / std::sqrt(static_cast<double>(a[i].size())));
  return largest;
}

double whole_difference(const Films& a, const Films& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum);
}

Calibration::Calibration(Camera camera, const Finger& finger, const std::vector<Experiment>& runs,
                         const Films& nominal) {
  constexpr double change = 1e-3;
  Finger stiffer = finger;
  stiffer.stiffness *= 1.0 + change;
  Finger damper = finger;
  damper.damping *= 1.0 + change;
  by_stiffness_ = film(camera, stiffer, {}, runs);
  by_damping_ = film(camera, damper, {}, runs);
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    by_stiffness_[i] = (by_stiffness_[i] - nominal[i]) / change;
    by_damping_[i] = (by_damping_[i] - nominal[i]) / change;
  }
}

Films Calibration::absorb(const Films& moved, const Films& nominal) const {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < moved.size(); ++i) {
    Eigen::MatrixX2d slope(moved[i].size(), 2);
    slope << by_stiffness_[i], by_damping_[i];
    normal += slope.transpose() * slope;
    right += slope.transpose() * (moved[i] - nominal[i]);
  }
  const Eigen::Vector2d change = normal.colPivHouseholderQr().solve(right);
  Films left = moved;
  for (std::size_t i = 0; i < left.size(); ++i) left[i] -= change[0] * by_stiffness_[i] + change[1] * by_damping_[i];
  return left;
}

}  // namespace truth
