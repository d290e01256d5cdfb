#include "measurement/replay/initial_state_prior.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "coilwright/algebra/least_squares.hpp"

namespace coilwright::measurement::replay {
namespace {

using mechanics::JointVector;
using simulation::State;

// Standard deviations of an initial state of which the measurement tells little, rad and rad/s: they alone bound a free
// initial state in directions that the cameras do not see.
constexpr double free_angle = 0.5;
constexpr double free_rate = 20.0;
// A parabola through so many of the first samples gives angle and rate at the first one.
constexpr std::size_t parabola_samples = 15;

struct ChannelStart {
  double value{}, rate{}, value_sigma{}, rate_sigma{};
};

// Value and slope at the first sample of a parabola through the first few, with their standard deviations.
ChannelStart start_of(const data::Run& run, const data::Channel& channel, double sigma, SampleRange range) {
  const std::size_t first = range.first;
  const std::size_t count = std::min(parabola_samples, range.samples());
  Eigen::MatrixXd powers(static_cast<Eigen::Index>(count), 3);
  Eigen::VectorXd values(static_cast<Eigen::Index>(count));
  const double duration = run.times[first + count - 1] - run.times[first];
  for (std::size_t i = 0; i < count; ++i) {
    const double t = (run.times[first + i] - run.times[first]) / duration;
    powers.row(static_cast<Eigen::Index>(i)) << 1.0, t, t * t;
    values[static_cast<Eigen::Index>(i)] = channel.values[first + i];
  }
  const Eigen::VectorXd fitted = algebra::least_squares(powers, values);
  const Eigen::Matrix3d covariance = (powers.transpose() * powers).inverse() * sigma * sigma;
  return {.value = fitted[0],
          .rate = fitted[1] / duration,
          .value_sigma = std::sqrt(covariance(0, 0)),
          .rate_sigma = std::sqrt(covariance(1, 1)) / duration};
}

}  // namespace

InitialStatePrior initial_state_prior(const PreparedRun& prepared, SampleRange range, const actuator::Model& nominal) {
  const data::Run& run = *prepared.run;
  const int n = nominal.joints();
  InitialStatePrior prior;
  State& mean = prior.mean;
  State& sigma = prior.sigma;
  mean = {.angles = JointVector::Zero(n), .rates = JointVector::Zero(n)};
  sigma = {.angles = JointVector::Constant(n, free_angle), .rates = JointVector::Constant(n, free_rate)};
  const bool measured = run.start == data::Start::measured;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const data::Channel& channel = run.channels[c];
    const ChannelStart start = start_of(run, channel, prepared.noise[c].sigma, range);
    switch (channel.kind) {
      case data::ChannelKind::bending_angle:
        // Shared equally between the joints unless a joint is measured itself.
        if (n > 1 && sigma.angles.maxCoeff() < free_angle) break;
        mean.angles.setConstant(start.value / n);
        mean.rates.setConstant(start.rate / n);
        if (measured && n == 1) sigma.angles.setConstant(start.value_sigma);
        if (measured && n == 1) sigma.rates.setConstant(start.rate_sigma);
        break;
      case data::ChannelKind::joint_angle:
        mean.angles[channel.joint] = start.value;
        mean.rates[channel.joint] = start.rate;
        if (measured) sigma.angles[channel.joint] = start.value_sigma;
        if (measured) sigma.rates[channel.joint] = start.rate_sigma;
        break;
      default:
        break;
    }
  }
  for (const data::Channel& channel : run.channels)
    if (channel.kind == data::ChannelKind::joint_rate) mean.rates[channel.joint] = channel.values[range.first];
  return prior;
}

}  // namespace coilwright::measurement::replay
