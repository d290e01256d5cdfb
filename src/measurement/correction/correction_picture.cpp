#include "measurement/correction/correction_picture.hpp"

#include <cmath>

#include "coilwright/algebra/definite.hpp"
#include "coilwright/algebra/spectral.hpp"

namespace coilwright::measurement::correction {
namespace {

using actuator::TorqueCorrection;

CorrectionPlace place_of(const TorqueCorrection& torque, std::size_t node) {
  const std::size_t columns = torque.axes.size() == 2 ? torque.axes[1].nodes.size() : 1;
  CorrectionPlace out{.at = {torque.axes[0].nodes[node / columns]}, .torque = torque.torques[node]};
  if (torque.axes.size() == 2) out.at.push_back(torque.axes[1].nodes[node % columns]);
  return out;
}

std::vector<double> products_of(const TorqueCorrection& torque) {
  if (torque.axes.size() < 2) return {};
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> table(torque.torques.data(), static_cast<Eigen::Index>(torque.axes[0].nodes.size()),
                                         static_cast<Eigen::Index>(torque.axes[1].nodes.size()));
  const Eigen::VectorXd singular = algebra::singular_values(table);
  std::vector<double> out;
  double sum = 0.0;
  for (Eigen::Index i = 0; i < singular.size(); ++i) {
    sum += singular[i] * singular[i];
    out.push_back(sum / singular.squaredNorm());
  }
  return out;
}

// Of K coefficients with a prior, K less what the prior alone would tell of each.
double degrees_of_freedom(const FittedCorrection& found) {
  const Eigen::VectorXd scales = found.corrected.hypothesis.scales();
  Eigen::MatrixXd scaled = scales.asDiagonal() * found.corrected.fit.normal_matrix * scales.asDiagonal();
  scaled.diagonal().array() += 1e-9 * scaled.diagonal().maxCoeff();
  const Eigen::MatrixXd covariance = algebra::inverse_of_definite(scaled);
  const Eigen::Index count = found.kind.basis().size();
  // The scale of a coefficient is the deviation of its prior.
  return static_cast<double>(count) - covariance.diagonal().tail(count).sum();
}

}  // namespace

NamelessCorrection described(const FittedCorrection& found) {
  const fit::Hypothesis& hypothesis = found.corrected.hypothesis;
  const Eigen::VectorXd& values = found.corrected.fit.values;
  NamelessCorrection out;
  const std::span<const double> calibration = hypothesis.calibration_in(values);
  out.calibration.assign(calibration.begin(), calibration.end());
  out.effects = hypothesis.effects_at(values);
  out.torque = found.kind.correction(out.effects.back().values);
  out.effects.pop_back();
  const Eigen::VectorXd torques = torques_at(out.torque, found.samples);
  out.rms = std::sqrt(torques.squaredNorm() / static_cast<double>(torques.size()));
  out.explained = 1.0 - found.corrected.chi_square_above_noise() / found.base.chi_square_above_noise();
  out.cross_validated_gain = found.cross_validated_gain;
  out.degrees_of_freedom = degrees_of_freedom(found);
  out.products = products_of(out.torque);
  const std::vector<char>& visited = found.kind.basis().visited;
  bool first = true;
  for (std::size_t node = 0; node < visited.size(); ++node) {
    if (visited[node] == 0) continue;
    const CorrectionPlace here = place_of(out.torque, node);
    if (first || here.torque > out.largest.torque) out.largest = here;
    if (first || here.torque < out.smallest.torque) out.smallest = here;
    first = false;
  }
  return out;
}

}  // namespace coilwright::measurement::correction
