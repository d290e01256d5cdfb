#include "measurement/planning/expected_information.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace coilwright::measurement::planning {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of one reading.
Expectation expectation(double probability, double mean, double spread) {
  return {.probability = probability,
          .mean = VectorXd::Constant(1, mean),
          .spread = spread > 0.0 ? MatrixXd::Constant(1, 1, spread) : MatrixXd(1, 0)};
}

double density(const Expectation& of, double at) {
  const double variance = 1.0 + of.spread.squaredNorm();
  return std::exp(-0.5 * std::pow(at - of.mean[0], 2) / variance) / std::sqrt(2.0 * std::numbers::pi * variance);
}

// Mutual information of one reading and the explanations, by quadrature.
double exact_bits(const std::vector<Expectation>& explanations) {
  constexpr double step = 0.01;
  double sum = 0.0;
  for (double at = -60.0; at < 60.0; at += step) {
    double all = 0.0;
    for (const Expectation& each : explanations) all += each.probability * density(each, at);
    for (const Expectation& each : explanations)
      if (const double own = density(each, at); own > 1e-200)
        sum += step * each.probability * own * std::log2(own / all);
  }
  return sum;
}

double open_bits_of(const std::vector<Expectation>& explanations) {
  std::vector<double> probabilities;
  for (const Expectation& each : explanations) probabilities.push_back(each.probability);
  return open_bits(probabilities);
}

TEST(RemainingBits, AreNoLessThanWhatTheMutualInformationLeaves) {
  for (const double apart : {0.5, 1.0, 2.0, 4.0, 8.0})
    for (const double spread : {0.0, 1.0, 3.0}) {
      const std::vector explanations = {expectation(0.6, 0.0, 0.5), expectation(0.3, apart, spread),
                                        expectation(0.1, -apart, 0.0)};
      const double open = open_bits_of(explanations);
      const double least = open - exact_bits(explanations);
      const double bound = std::exp(log_remaining_bits(explanations));
      EXPECT_GE(bound, least) << apart << " " << spread;
      EXPECT_LE(bound, least + 0.3 * open) << apart << " " << spread;
    }
}

TEST(RemainingBits, FallWithTheOverlapHoweverSmall) {
  for (const double apart : {20.0, 200.0}) {
    const std::vector explanations = {expectation(0.5, 0.0, 0.0), expectation(0.5, apart, 0.0)};
    EXPECT_NEAR(log_remaining_bits(explanations), -apart * apart / 8.0 - std::log(std::numbers::ln2), 1e-9);
  }
}

TEST(RemainingBits, AreAllThatIsOpenWhereAllExpectTheSame) {
  const std::vector explanations = {expectation(0.5, 1.0, 2.0), expectation(0.25, 1.0, 2.0),
                                    expectation(0.25, 1.0, 2.0)};
  EXPECT_NEAR(open_bits_of(explanations), 1.5, 1e-12);
  EXPECT_NEAR(std::exp(log_remaining_bits(explanations)), 1.5, 1e-12);
}

// The same covariance, of which one reading has all or each of four its share.
TEST(RemainingBits, AreThoseOfTheReadingsAlongWhichExplanationsDiffer) {
  const std::vector one = {expectation(0.5, 0.0, 1.5), expectation(0.5, 2.0, 0.7)};
  const VectorXd direction = VectorXd::Constant(4, 0.5);
  std::vector four = one;
  for (Expectation& each : four) {
    each.mean = each.mean[0] * direction;
    each.spread = each.spread(0, 0) * direction;
  }
  EXPECT_NEAR(log_remaining_bits(four), log_remaining_bits(one), 1e-12);
}

// Two families of readings along one circle, two of their deviations apart: moved half way they are one.
TEST(RemainingBits, CountWhatBendsWithTheNumbers) {
  const auto on_circle = [](double at) { return VectorXd(40.0 * Eigen::Vector2d(std::cos(at), std::sin(at))); };
  const auto family = [&](double at) {
    return Expectation{.probability = 0.5,
                       .mean = on_circle(at),
                       .spread = on_circle(at + 0.5) - on_circle(at),
                       .moved = [=](const VectorXd& by) { return on_circle(at + 0.5 * by[0]); }};
  };
  const std::vector bent = {family(0.0), family(1.0)};
  std::vector straight = bent;
  for (Expectation& each : straight) each.moved = nullptr;
  const double exact = std::log2(1.0 + std::exp(-0.5));
  const double error = std::abs(std::exp(log_remaining_bits(bent)) - exact);
  EXPECT_LT(error, 0.08);
  EXPECT_LT(error, 0.7 * std::abs(std::exp(log_remaining_bits(straight)) - exact));
}

}  // namespace
}  // namespace coilwright::measurement::planning
