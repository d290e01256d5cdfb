#include "sizing/surrogate/expected_gain.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "sizing/sampling/eigen_vectors.hpp"
#include "sizing/surrogate/surrogate.hpp"

namespace coilwright::sizing {
namespace {

using Point = std::vector<double>;

// The model goes through so many designs: the front, what lies behind it, then those that come nearest to the limits. A
// factorisation of 150 takes 1 ms.
constexpr std::size_t most_chosen_from = 150;
// Gains count within the range of the feasible designs and of so many that come nearest to the limits: feasible ones
// may be a cluster, which no design would be worth leaving for if their range were all.
constexpr std::size_t infeasible_in_range = 40;
// Of a prior variance of 1. What is known has a smaller one, by rounding even a negative one.
constexpr double least_variance = 1e-10;

// The logarithm of the probability that a normal variable is below 0, also where the probability is too small for a
// number.
double log_below_zero(double mean, double deviation) {
  const double z = -mean / deviation;
  if (z > -20) return std::log(0.5 * std::erfc(-z / std::numbers::sqrt2));
  return -0.5 * z * z - std::log(-z * std::sqrt(2 * std::numbers::pi));
}

// By how much a normal variable is expected to lie below a bound (above it counts 0).
double expected_below(double bound, double mean, double deviation) {
  const double z = (bound - mean) / deviation;
  return (bound - mean) * 0.5 * std::erfc(-z / std::numbers::sqrt2) +
         deviation * std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
}

std::vector<std::size_t> designs_of_model(const Samples& samples) {
  std::vector<std::pair<std::pair<double, double>, std::size_t>> order;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    if (!sample.evaluated) continue;
    order.push_back({{sample.violation, sample.feasible() ? samples.excess(sample.values) : 0.0}, i});
  }
  std::ranges::sort(order);
  order.resize(std::min(order.size(), most_chosen_from));
  std::vector<std::size_t> designs;
  for (const auto& entry : order) designs.push_back(entry.second);
  return designs;
}

// Constraints enter as their asinh: they matter near their limit only, and far from it run over decades.
Surrogate model_through(const Samples& samples, const std::vector<std::size_t>& designs) {
  const auto count = static_cast<Eigen::Index>(designs.size());
  Eigen::MatrixXd at(count, static_cast<Eigen::Index>(samples.space().dimension()));
  Eigen::MatrixXd values(count, static_cast<Eigen::Index>(samples.objective_count() + samples.constraint_count()));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Sample& sample = samples[designs[static_cast<std::size_t>(i)]];
    at.row(i) = as_vector(sample.unit).transpose();
    values.row(i) << as_vector(sample.values).transpose(), as_vector(sample.constraints).transpose().array().asinh();
  }
  return {at, values};
}

// The worst of each objective that counts.
Objectives worst_of(const Samples& samples, const std::vector<std::size_t>& designs) {
  Objectives best = samples[designs.front()].values, worst = best;
  std::size_t infeasible = 0;
  for (const std::size_t i : designs) {
    const Sample& sample = samples[i];
    if (!sample.feasible() && ++infeasible > infeasible_in_range) break;
    for (std::size_t k = 0; k < best.size(); ++k) {
      best[k] = std::min(best[k], sample.values[k]);
      worst[k] = std::max(worst[k], sample.values[k]);
    }
  }
  for (std::size_t k = 0; k < best.size(); ++k) worst[k] += 0.1 * (worst[k] - best[k]);
  return worst;
}

bool is_nearest_to_failure(const Samples& samples, const Point& unit) {
  double nearest = std::numeric_limits<double>::infinity();
  bool failed = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double distance = (as_vector(samples[i].unit) - as_vector(unit)).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    failed = !samples[i].evaluated;
  }
  return failed;
}

// What the model expects of one candidate: the mean of each output, and its deviation.
double merit_of(const Eigen::VectorXd& means, const Eigen::VectorXd& deviations, const UpperBounds& bounds,
                const Objectives& worst) {
  double gain = 0, log_feasible = 0;
  for (const UpperBound& bound : bounds.all()) {
    double product = 1;
    for (std::size_t k = 0; k < worst.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      product *= expected_below(std::min(bound.corner[k], worst[k]), means[i], deviations[i]);
    }
    gain = std::max(gain, product);
  }
  for (auto i = static_cast<Eigen::Index>(worst.size()); i < means.size(); ++i)
    log_feasible += log_below_zero(means[i], deviations[i]);
  return std::log(std::max(gain, std::numeric_limits<double>::min())) + log_feasible;
}

}  // namespace

std::vector<std::size_t> of_most_expected_gain(const Samples& samples, const std::vector<Point>& candidates,
                                               std::size_t count) {
  const std::vector<std::size_t> designs = designs_of_model(samples);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!is_nearest_to_failure(samples, candidates[i])) left.push_back(i);
  }
  if (designs.size() < 3 || left.empty()) return {};
  Eigen::MatrixXd places(static_cast<Eigen::Index>(candidates.front().size()), static_cast<Eigen::Index>(left.size()));
  for (Eigen::Index j = 0; j < places.cols(); ++j)
    places.col(j) = as_vector(candidates[left[static_cast<std::size_t>(j)]]);
  auto [means, covariance, deviations] = model_through(samples, designs).predicted(places);
  const Objectives worst = worst_of(samples, designs);
  UpperBounds bounds = samples.bounds();
  std::vector<std::size_t> chosen;
  Eigen::ArrayXd taken = Eigen::ArrayXd::Zero(places.cols());  // minus infinity for what is chosen
  while (chosen.size() < std::min(count, left.size())) {
    Eigen::ArrayXd merits = taken;
    for (Eigen::Index j = 0; j < places.cols(); ++j) {
      const double deviation = std::sqrt(std::max(covariance(j, j), least_variance));
      merits[j] += merit_of(means.row(j).transpose(), (deviation * deviations).cwiseMax(1e-12), bounds, worst);
    }
    Eigen::Index best = 0;
    merits.maxCoeff(&best);
    taken[best] = -std::numeric_limits<double>::infinity();
    chosen.push_back(left[static_cast<std::size_t>(best)]);
    const Eigen::VectorXd expected = means.row(best).transpose().head(static_cast<Eigen::Index>(worst.size()));
    bounds.add(as_std(expected), samples.size());
    const Eigen::VectorXd column = covariance.col(best);
    covariance -= column * column.transpose() / std::max(column[best], least_variance);
  }
  return chosen;
}

}  // namespace coilwright::sizing
