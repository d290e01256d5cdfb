#include "measurement/signals/whittaker_smoother.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace coilwright::measurement::signals {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr Eigen::Index order = 3;

// D^T D of third differences: divided differences times h^3 3!, which are 1, -3, 3, -1 for even sampling.
SparseMatrix roughness(std::span<const double> times) {
  const auto n = static_cast<Eigen::Index>(times.size());
  const double interval = (times.back() - times.front()) / static_cast<double>(n - 1);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i + order < n; ++i)
    for (Eigen::Index j = 0; j <= order; ++j) {
      double weight = 1.0;
      for (Eigen::Index k = 0; k <= order; ++k)
        if (k != j) weight *= interval / (times[i + j] - times[i + k]);
      entries.emplace_back(i, i + j, 6.0 * weight);
    }
  SparseMatrix differences(std::max<Eigen::Index>(n - order, 0), n);
  differences.setFromTriplets(entries.begin(), entries.end());
  return SparseMatrix(differences.transpose()) * differences;
}

std::vector<double> solved(const SparseMatrix& rough, std::span<const double> values, double penalty) {
  const auto n = static_cast<Eigen::Index>(values.size());
  SparseMatrix system(n, n);
  system.setIdentity();
  system += penalty * rough;
  // The natural order keeps the matrix banded.
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factors(system);
  const Eigen::VectorXd result = factors.solve(Eigen::Map<const Eigen::VectorXd>(values.data(), n));
  return {result.data(), result.data() + n};
}

// Trace of the smoother: the sum of its gains for even sampling, of which three are 1 (parabolas pass unchanged).
double freedom(std::size_t n, double penalty) {
  double sum = static_cast<double>(std::min<std::size_t>(n, order));
  for (std::size_t k = order; k < n; ++k) {
    const double phase = std::numbers::pi * (static_cast<double>(k) - 1.0) / static_cast<double>(n);
    sum += 1.0 / (1.0 + penalty * std::pow(2.0 * std::sin(0.5 * phase), 6));
  }
  return sum;
}

}  // namespace

std::vector<double> smoothed(std::span<const double> times, std::span<const double> values, double penalty) {
  if (static_cast<Eigen::Index>(values.size()) <= order) return {values.begin(), values.end()};
  return solved(roughness(times), values, penalty);
}

double smoothing_length(double penalty) {
  return std::pow(penalty, 1.0 / 6.0);
}

double best_penalty(std::span<const SampledSegment> segments, double sigma) {
  std::vector<SparseMatrix> rough;
  for (const SampledSegment& segment : segments) rough.push_back(roughness(segment.times));
  double best = 1.0;
  double least = std::numeric_limits<double>::infinity();
  for (int half_decade = 0; half_decade <= 24; ++half_decade) {
    const double penalty = std::pow(10.0, 0.5 * half_decade);
    double error = 0.0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const std::vector<double> smooth = solved(rough[s], segments[s].values, penalty);
      for (std::size_t i = 0; i < smooth.size(); ++i) {
        const double left = (segments[s].values[i] - smooth[i]) / sigma;
        error += left * left - 1.0;
      }
      error += 2.0 * freedom(smooth.size(), penalty);
    }
    if (error < least) {
      least = error;
      best = penalty;
    }
  }
  return best;
}

Derivatives derivatives(std::span<const double> times, std::span<const double> values) {
  const std::size_t n = values.size();
  Derivatives result{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  if (n < 3) return result;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = times[i] - times[i - 1];
    const double after = times[i + 1] - times[i];
    const double slope_before = (values[i] - values[i - 1]) / before;
    const double slope_after = (values[i + 1] - values[i]) / after;
    result.first[i] = (slope_before * after + slope_after * before) / (before + after);
    result.second[i] = 2.0 * (slope_after - slope_before) / (before + after);
  }
  for (std::vector<double>* slopes : {&result.first, &result.second}) {
    slopes->front() = (*slopes)[1];
    slopes->back() = (*slopes)[n - 2];
  }
  return result;
}

}  // namespace coilwright::measurement::signals
