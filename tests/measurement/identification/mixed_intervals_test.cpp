#include "measurement/identification/mixed_intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "measurement/identification/curvature.hpp"
#include "measurement/identification/slide_fits.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

// Two hypotheses that put the mass at two places, the reported one with 0.7: the variance about what it says is
// 0.7 own^2 + 0.3 (own^2 + apart^2).
TEST(MixedIntervals, HaveTheVarianceOfAllHypothesesAboutWhatIsReported) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  Normal normal(7);
  const data::Run run = slide_run(200, {}, [&] { return noise_sigma * normal(); });
  const std::vector runs{replay::prepare_run(run, declared, model_of(declared))};
  const FittedHypothesis fitted = fitted_to(runs, declared, {});
  const Eigen::VectorXd own = standard_deviations(fitted, 1.0);
  const double apart = 3.0 * own[0];
  WeighedFit reported{.values = fitted.fit.values, .covariance = covariance(fitted, 1.0)};
  WeighedFit rival = reported;
  rival.values[0] += apart;
  const Attribution found{.before = fitted,
                          .after = fitted,
                          .posterior = {.hypotheses = {{.probability = 0.7}, {.probability = 0.3}}},
                          .weighed = {reported, rival}};
  std::vector<Estimate> estimates;
  for (Eigen::Index i = 0; i < own.size(); ++i)
    estimates.push_back(
        local_estimate(fitted.hypothesis.parameters()[static_cast<std::size_t>(i)], fitted.fit.values[i], own[i]));
  const std::vector<Estimate> alone = estimates;
  widen_by_posterior(estimates, found, 1.0);
  const double factor = std::sqrt(1.0 + 0.3 * 9.0);
  EXPECT_NEAR((estimates[0].upper - estimates[0].lower) / (alone[0].upper - alone[0].lower), factor, 1e-9);
  EXPECT_EQ(estimates[0].value, alone[0].value);
  EXPECT_NEAR(estimates[1].upper, alone[1].upper, 1e-9 * std::abs(alone[1].upper));
}

}  // namespace
}  // namespace coilwright::measurement::identification
