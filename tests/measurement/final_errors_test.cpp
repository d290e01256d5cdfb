#include "measurement/final_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "measurement/random_numbers.hpp"
#include "measurement/slide.hpp"

namespace coilwright::measurement {
namespace {

compare::Scored fitted_to(const replay::DeclaredModel& declared, const data::Run& run) {
  fit::Hypothesis hypothesis(declared, {});
  const std::vector<replay::Record> records{replay::prepare(run, declared, hypothesis.model_at(hypothesis.start()))};
  auto found = fit::fit({.hypothesis = &hypothesis, .records = records, .start = hypothesis.start()});
  EXPECT_TRUE(found);
  return compare::scored(records, std::move(hypothesis), std::move(*found));
}

// Fitted to 0.6 s of a slide, judged over 4 s of which nobody measured a thing wrong: what is left is what the fitted
// numbers are off, and over many sets of noise its size is what one set says of itself.
TEST(FinalErrors, KnowHowFarTheFittedNumbersLeaveThemOpen) {
  const replay::DeclaredModel declared = slide(2.2, 2.7);
  const std::vector<data::Run> judged{slide_run(400, {}, no_error)};
  constexpr int draws = 60;
  double met = 0.0;
  double said = 0.0;
  for (int seed = 1; seed <= draws; ++seed) {
    Normal normal(static_cast<std::uint64_t>(seed));
    const compare::Scored model = fitted_to(declared, slide_run(60, {}, [&] { return noise_sigma * normal(); }));
    const FinalErrors errors(judged, declared, {.declared = model, .before = model, .after = model, .unit = 1.0});
    ASSERT_EQ(errors.errors().size(), 1U);
    met += std::pow(errors.errors().front().after.rmse, 2);
    said += std::pow(errors.errors().front().uncertainty_rmse, 2);
  }
  EXPECT_GT(std::sqrt(met / draws), 2.0 * noise_sigma);  // beyond the noise: an extrapolation
  // Two numbers: the mean of 60 squares is known to about 20 %, its root to 10 %.
  EXPECT_NEAR(std::sqrt(said / met), 1.0, 0.25);
}

}  // namespace
}  // namespace coilwright::measurement
