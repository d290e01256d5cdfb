#include "measurement/final_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement {
namespace {

compare::FittedHypothesis fitted_to(const replay::DeclaredModel& declared, const data::Run& run) {
  fit::Hypothesis hypothesis(declared, {});
  const std::vector runs{replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  auto found = fit::fit({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
  EXPECT_TRUE(found.value);
  return compare::score(runs, std::move(hypothesis), std::move(*found.value));
}

// Fitted to 0.6 s of a slide with noise, and compared with 4 s without: the errors are due to the errors of the fitted
// numbers alone, and over many draws of noise their size is the uncertainty that is stated for a single draw.
TEST(FinalErrors, StateTheUncertaintyDueToTheFittedNumbers) {
  const replay::DeclaredModel declared = slide(2.2, 2.7);
  const std::vector<data::Run> judged{slide_run(400, {}, no_error)};
  constexpr int draws = 60;
  double observed = 0.0;
  double stated = 0.0;
  for (int seed = 1; seed <= draws; ++seed) {
    Normal normal(static_cast<std::uint64_t>(seed));
    const compare::FittedHypothesis model =
        fitted_to(declared, slide_run(60, {}, [&] { return noise_sigma * normal(); }));
    const FinalErrors errors(judged, declared,
                             {.declared = model, .before = model, .after = model, .overdispersion = 1.0}, {});
    ASSERT_EQ(errors.errors().size(), 1U);
    observed += std::pow(errors.errors().front().after.rmse, 2);
    stated += std::pow(errors.errors().front().uncertainty_rmse, 2);
  }
  EXPECT_GT(std::sqrt(observed / draws), 2.0 * noise_sigma);  // beyond the noise: an extrapolation
  // Two numbers: the mean of 60 squares is known to about 20 %, its root to 10 %.
  EXPECT_NEAR(std::sqrt(stated / observed), 1.0, 0.25);
}

}  // namespace
}  // namespace coilwright::measurement
