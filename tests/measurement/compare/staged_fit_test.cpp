#include "measurement/compare/staged_fit.hpp"

#include <gtest/gtest.h>

#include "measurement/slider_model.hpp"

namespace coilwright::measurement::compare {
namespace {

double tolerance_beside(double chi_square, std::size_t samples) {
  FittedHypothesis known{.hypothesis = fit::Hypothesis(slide(2.0, 3.0), {})};
  known.fit.chi_square = chi_square;
  known.fit.used_samples = samples;
  return ends_by_what_is_left({.iterations = 8, .tolerance = 1e-2}, known).tolerance;
}

// Chi-square falls by this in the last step of a fit.
TEST(ShortFits, EndByAHundredthOfWhatIsLeftAboveTheNoise) {
  EXPECT_DOUBLE_EQ(tolerance_beside(24000.0, 12000) * 24000.0, 120.0);
  EXPECT_DOUBLE_EQ(tolerance_beside(13000.0, 12000) * 13000.0, 10.0);
}

TEST(ShortFits, EndWhereAStepGainsWhatDecidesNothing) {
  EXPECT_DOUBLE_EQ(tolerance_beside(12100.0, 12000) * 12100.0, 6.0);
  EXPECT_DOUBLE_EQ(tolerance_beside(11800.0, 12000) * 11800.0, 6.0);  // below the noise
}

TEST(ShortFits, AreNeverLongerThanTheyMayBe) {
  EXPECT_DOUBLE_EQ(tolerance_beside(100.0, 90), 1e-2);
}

}  // namespace
}  // namespace coilwright::measurement::compare
