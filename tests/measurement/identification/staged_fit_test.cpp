#include "measurement/identification/staged_fit.hpp"

#include <gtest/gtest.h>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr fit::FitEffort effort{.iterations = 8, .tolerance = 1e-2};

// By how much the last step of a fit may lower chi-square beside a known fit that leaves this much of it.
double last_gain_beside(double chi_square, std::size_t samples) {
  FittedHypothesis known{.hypothesis = fit::Hypothesis(slide(2.0, 3.0), {})};
  known.fit.chi_square = chi_square;
  known.fit.used_samples = samples;
  return ends_by_what_is_left(effort, known).tolerance * chi_square;
}

TEST(ShortFits, EndByAShareOfWhatIsLeftAboveTheNoise) {
  EXPECT_DOUBLE_EQ(last_gain_beside(24000.0, 12000), effort.tolerance * 12000.0);
  EXPECT_DOUBLE_EQ(last_gain_beside(13000.0, 12000), effort.tolerance * 1000.0);
}

TEST(ShortFits, EndWhereAStepGainsWhatDecidesNothing) {
  EXPECT_DOUBLE_EQ(last_gain_beside(12100.0, 12000), decision_thresholds.decisive_gain);
  EXPECT_DOUBLE_EQ(last_gain_beside(11800.0, 12000), decision_thresholds.decisive_gain);  // below the noise
}

TEST(ShortFits, AreNeverLongerThanTheyMayBe) {
  EXPECT_DOUBLE_EQ(last_gain_beside(100.0, 90), effort.tolerance * 100.0);
}

}  // namespace
}  // namespace coilwright::measurement::identification
