#include "truth/laboratory/noise.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace truth::laboratory {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double mains = 50.0;  // Hz
constexpr double low_pass_corner = 10.0;
constexpr int pink_filters = 8;

double pink_corner(int i) {
  return 0.03 * std::pow(100.0 / 0.03, i / (pink_filters - 1.0));
}

// A first-order filter of white noise, exactly, at any times (Ornstein and Uhlenbeck).
std::vector<double> filtered(Random& random, double corner, const std::vector<double>& times) {
  std::vector<double> out;
  double value = random.normal();
  double before = times.empty() ? 0.0 : times.front();
  for (const double time : times) {
    const double kept = std::exp(-two_pi * corner * (time - before));
    before = time;
    value = kept * value + std::sqrt(1.0 - kept * kept) * random.normal();
    out.push_back(value);
  }
  return out;
}

}  // namespace

Noise::Noise(Colour colour, Random& random) : colour_(colour), random_(random) {}

std::vector<double> Noise::at(const std::vector<double>& times) {
  std::vector<double> out;
  switch (colour_) {
    case Colour::white:
      for (std::size_t i = 0; i < times.size(); ++i) out.push_back(random_.normal());
      break;
    case Colour::low_passed:
      out = filtered(random_, low_pass_corner, times);
      break;
    case Colour::pink: {
      out.assign(times.size(), 0.0);
      for (int i = 0; i < pink_filters; ++i) {
        const std::vector<double> part = filtered(random_, pink_corner(i), times);
        for (std::size_t k = 0; k < out.size(); ++k) out[k] += part[k] / std::sqrt(static_cast<double>(pink_filters));
      }
      break;
    }
    case Colour::hum: {
      const double phase = two_pi * random_.uniform();
      for (const double time : times)  // a sine of amplitude 1 has a variance of a half
        out.push_back(std::sin(two_pi * mains * time + phase) + std::sqrt(0.5) * random_.normal());
      break;
    }
  }
  return out;
}

double covariance(Colour colour, double apart) {
  const double distance = std::abs(apart);
  switch (colour) {
    case Colour::white:
      break;
    case Colour::low_passed:
      return std::exp(-two_pi * low_pass_corner * distance);
    case Colour::pink: {
      double sum = 0.0;
      for (int i = 0; i < pink_filters; ++i) sum += std::exp(-two_pi * pink_corner(i) * distance);
      return sum / pink_filters;
    }
    case Colour::hum:
      return 0.5 * std::cos(two_pi * mains * distance) + (distance == 0.0 ? 0.5 : 0.0);
  }
  return distance == 0.0 ? 1.0 : 0.0;
}

Eigen::VectorXd over_noise(Colour colour, double white, const std::vector<double>& times,
                           const Eigen::VectorXd& change) {
  if (colour == Colour::white) return change / std::sqrt(1.0 + white);
  constexpr Eigen::Index longest = 1500;
  Eigen::VectorXd out(change.size());
  const auto samples = static_cast<Eigen::Index>(times.size());
  for (Eigen::Index first = 0; first < samples; first += longest) {
    const Eigen::Index count = std::min(longest, samples - first);
    Eigen::MatrixXd matrix(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index k = 0; k <= i; ++k)
        matrix(i, k) = covariance(colour, times[static_cast<std::size_t>(first + i)] -
                                              times[static_cast<std::size_t>(first + k)]) +
                       (i == k ? white : 0.0);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(matrix);
    for (Eigen::Index channel = 0; channel < change.size() / samples; ++channel)
      out.segment(channel * samples + first, count) =
          factor.matrixL().solve(change.segment(channel * samples + first, count));
  }
  return out;
}

}  // namespace truth::laboratory
