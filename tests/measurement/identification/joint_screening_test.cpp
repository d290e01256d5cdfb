#include "measurement/identification/joint_screening.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::standard_effects;

constexpr Eigen::Index samples = 200;

Eigen::VectorXd drawn(Normal& normal) {
  Eigen::VectorXd out(samples);
  for (double& value : out) value = normal();
  return out;
}

ScreenedEffect candidate(std::string_view id, std::vector<double> values, Eigen::VectorXd direction) {
  const actuator::Effect guess{.kind = standard_effects().find(id), .values = std::move(values)};
  return {.guess = guess, .effect = guess, .residual_direction = std::move(direction)};
}

FittedHypothesis with_residual(const replay::DeclaredModel& declared, Eigen::VectorXd residual) {
  FittedHypothesis out{.hypothesis = fit::Hypothesis(declared, {})};
  out.fit.stacked_residuals = std::move(residual);
  return out;
}

// What columns explain of a residual, by a factorisation of the columns themselves.
double explained_by(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual) {
  const Eigen::VectorXd fitted = columns * columns.householderQr().solve(residual);
  return fitted.squaredNorm();
}

class JointScreening : public testing::Test {
 protected:
  Normal normal_{11};  // first: the candidates are drawn from it
  // Effects that may act in either direction.
  std::vector<ScreenedEffect> candidates_{
      candidate("angle_offset", {0.01}, drawn(normal_)), candidate("base_tilt", {0.02}, drawn(normal_)),
      candidate("rest_angle", {0.03}, drawn(normal_)), candidate("current_offset", {0.04}, drawn(normal_)),
      candidate("stiffness_hardening", {0.5}, drawn(normal_))};
  replay::DeclaredModel declared_ = slide(true_mass, true_damping);
};

TEST_F(JointScreening, FindsTheTripleOfWhichNoPartExplainsAnything) {
  // A residual along a - b + c, in which a and b are nearly one, and c is orthogonal to what they leave.
  const Eigen::VectorXd common = drawn(normal_);
  Eigen::VectorXd rest = drawn(normal_);
  rest -= common * (common.dot(rest) / common.squaredNorm());
  candidates_[0].residual_direction = common + 0.05 * rest;
  candidates_[1].residual_direction = common;
  candidates_[2].residual_direction = drawn(normal_);
  const Eigen::VectorXd residual = -(candidates_[0].residual_direction - candidates_[1].residual_direction) * 20.0 -
                                   candidates_[2].residual_direction;
  const FittedHypothesis base = with_residual(declared_, residual);
  const auto found = combinations_by_predicted_fall(base, candidates_, 3, 2);
  ASSERT_EQ(found.size(), 2u);
  std::vector<std::string_view> ids;
  for (const actuator::Effect& effect : found.front().effects) ids.push_back(effect.kind->id());
  EXPECT_EQ(ids, (std::vector<std::string_view>{"angle_offset", "base_tilt", "rest_angle"}));
  EXPECT_NEAR(found.front().predicted_chi_square_fall, residual.squaredNorm(), 1e-6 * residual.squaredNorm());
  // The starts of the fit: the strongest that SearchEffort allows, of opposite sign, and the guess itself.
  EXPECT_NEAR(found.front().effects[0].values[0], 0.03, 1e-12);
  EXPECT_NEAR(found.front().effects[1].values[0], -0.06, 1e-12);
  EXPECT_NEAR(found.front().effects[2].values[0], 0.03, 1e-9);
}

TEST_F(JointScreening, PredictsWhatAFactorisationOfTheDirectionsExplains) {
  const Eigen::VectorXd residual = drawn(normal_);
  const FittedHypothesis base = with_residual(declared_, residual);
  for (const std::size_t size : {2u, 3u}) {
    double best = 0.0;
    const auto n = candidates_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = i + 1; k < n; ++k) {
        for (std::size_t l = size == 2 ? n - 1 : k + 1; l < n; ++l) {
          Eigen::MatrixXd columns(samples, static_cast<Eigen::Index>(size));
          columns.col(0) = candidates_[i].residual_direction;
          columns.col(1) = candidates_[k].residual_direction;
          if (size == 3) columns.col(2) = candidates_[l].residual_direction;
          best = std::max(best, explained_by(columns, residual));
        }
      }
    }
    const auto found = combinations_by_predicted_fall(base, candidates_, size, 100);
    ASSERT_EQ(found.size(), 10u);  // of five effects, two as well as three
    EXPECT_NEAR(found.front().predicted_chi_square_fall, best, 1e-9 * best);
    EXPECT_TRUE(std::ranges::is_sorted(
        found, [](const auto& a, const auto& b) { return a.predicted_chi_square_fall > b.predicted_chi_square_fall; }));
  }
}

TEST_F(JointScreening, LeavesOutWhatWouldActAgainstItsSign) {
  const Eigen::VectorXd friction = drawn(normal_);
  const Eigen::VectorXd drag = drawn(normal_);
  // The residual wants friction of the wrong sign.
  const FittedHypothesis base = with_residual(declared_, friction - drag);
  const std::vector<ScreenedEffect> both{candidate("dry_friction", {1e-4}, friction),
                                         candidate("quadratic_drag", {1e-5}, drag)};
  EXPECT_TRUE(combinations_by_predicted_fall(base, both, 2, 4).empty());
  const FittedHypothesis other = with_residual(declared_, -friction - drag);
  EXPECT_EQ(combinations_by_predicted_fall(other, both, 2, 4).size(), 1u);
}

TEST_F(JointScreening, LeavesOutDirectionsThatAreOne) {
  const Eigen::VectorXd one = drawn(normal_);
  const FittedHypothesis base = with_residual(declared_, one);
  const std::vector<ScreenedEffect> same{candidate("base_tilt", {0.02}, one),
                                         candidate("rest_angle", {0.03}, 2.0 * one)};
  EXPECT_TRUE(combinations_by_predicted_fall(base, same, 2, 4).empty());
}

}  // namespace
}  // namespace coilwright::measurement::identification
