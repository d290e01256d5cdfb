#include "measurement/localise/harmonic_dependence.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/algebra/minimum_norm.hpp"

namespace coilwright::measurement::localise {
namespace {

// Least squares of mean, cosine and sine.
struct HarmonicFit {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();
  [[nodiscard]] Eigen::Vector3d coefficients() const { return algebra::minimum_norm(products, moments); }
};

}  // namespace

Dependence harmonic_dependence(double frequency, const PooledSeries& samples, const SampleBlocks& blocks,
                               std::size_t motions) {
  Dependence result{.variable = "frequency"};
  const auto wave = [&](std::size_t i) {
    const double phase = 2.0 * std::numbers::pi * frequency * samples.time[i];
    return Eigen::Vector3d(1.0, std::cos(phase), std::sin(phase));
  };
  std::vector<HarmonicFit> fits(2 * motions);
  const auto fit_of = [&](std::size_t i, std::size_t parity) {
    return 2 * (static_cast<std::size_t>(samples.run[i]) - 1) + parity;
  };
  double mean = 0.0;
  for (std::size_t i = 0; i < samples.torque.size(); ++i) {
    HarmonicFit& fit = fits[fit_of(i, blocks.number[i] % 2)];
    fit.products += wave(i) * wave(i).transpose();
    fit.moments += wave(i) * samples.torque[i];
    mean += samples.torque[i] / static_cast<double>(samples.torque.size());
  }
  std::vector<Eigen::Vector3d> coefficients;
  double amplitude = 0.0;
  for (const HarmonicFit& fit : fits) {
    coefficients.push_back(fit.coefficients());
    amplitude += fit.products(0, 0) * coefficients.back().tail<2>().norm() / static_cast<double>(samples.torque.size());
  }
  double left = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < samples.torque.size(); ++i) {
    const double expected = coefficients[fit_of(i, 1 - blocks.number[i] % 2)].dot(wave(i));
    left += (samples.torque[i] - expected) * (samples.torque[i] - expected);
    all += (samples.torque[i] - mean) * (samples.torque[i] - mean);
  }
  if (all > 0.0) result.explained = std::max(1.0 - left / all, 0.0);
  result.at = {frequency};
  result.residual = {amplitude};
  return result;
}

}  // namespace coilwright::measurement::localise
