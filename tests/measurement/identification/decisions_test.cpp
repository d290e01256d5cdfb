#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/identification/slide_fits.hpp"
#include "measurement/slider_model.hpp"

// The functions that decide, each by a case that a hand can compute.
namespace coilwright::measurement::identification {
namespace {

// The slide and effects as a fit of 100 samples left them: white, with this chi-square.
FittedHypothesis left_with(double chi_square, const std::vector<actuator::Effect>& effects = {}) {
  static const replay::DeclaredModel declared = slide(true_mass, true_damping);
  FittedHypothesis out{.hypothesis = fit::Hypothesis(declared, effects)};
  out.fit.values = out.hypothesis.start();
  out.fit.chi_square = chi_square;
  out.fit.used_samples = 100;
  return out;
}

TEST(Overdispersion, OfAWhiteResidualIsItsMeanSquareAndNeverBelowOne) {
  EXPECT_DOUBLE_EQ(overdispersion_of({}, left_with(400.0)), 4.0);
  EXPECT_DOUBLE_EQ(overdispersion_of({}, left_with(50.0)), 1.0);
}

// Of the values 1, 1, 0, 0, .. the sum of squares is 2, that of products of neighbours 1: the correlation time is
// 1 + 2 (1/2) = 2 samples.
TEST(Overdispersion, OfAResidualWithStructureCountsItsCorrelationTime) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const data::Run run = slide_run(20, {}, no_error);
  const std::vector runs{replay::prepare_run(run, declared, model_of(declared))};
  FittedHypothesis fitted = left_with(300.0);
  fitted.whiteness.structure = 2.0;
  fitted.fit.runs.resize(1);
  fitted.fit.runs.front().residuals = Eigen::VectorXd::Zero(20);
  fitted.fit.runs.front().residuals.head(2).setOnes();
  EXPECT_NEAR(overdispersion_of(runs, fitted), 3.0 * 2.0, 1e-12);
}

}  // namespace
}  // namespace coilwright::measurement::identification
