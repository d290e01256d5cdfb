#include "measurement/identification/numbers_off.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "measurement/identification/slide_fits.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

// A number that is no longer fitted freely.
void hold(replay::CalibrationParameter& number, double tolerance) {
  number.tolerance = replay::Tolerance{.deviation = tolerance};
  number.scale = tolerance;
  number.calibrated = false;
}

// A slide whose mass was weighed and whose damping is fitted.
replay::DeclaredModel weighed_slide(double mass, double tolerance) {
  replay::DeclaredModel declared = slide(mass, true_damping);
  hold(declared.calibration.front(), tolerance);
  return declared;
}

constexpr double sharp_sigma = 1e-2 * noise_sigma;

data::Run sharp_run(double drag) {
  return dragged_run(400, drag, sharp_sigma, 6);
}

struct Held {
  Held(data::Run recorded, replay::DeclaredModel model)
      : run(std::move(recorded)),
        declared(std::move(model)),
        runs{replay::prepare_run(run, declared, model_of(declared))},
        without(fitted(declared, {})) {}

  [[nodiscard]] FittedHypothesis fitted(const replay::DeclaredModel& under,
                                        std::vector<actuator::Effect> effects) const {
    return fitted_to(runs, under, std::move(effects));
  }
  data::Run run;
  replay::DeclaredModel declared;
  std::vector<replay::PreparedRun> runs;
  FittedHypothesis without;
};

// Free, the mass is what nobody has weighed would be; its gain is that over the model that holds it, less one number.
TEST(NumbersOff, HaveTheOneOfWhichSomebodyWasTooSure) {
  const Held compared(sharp_run(0.0), weighed_slide(true_mass + 0.05, 2e-4));
  const auto off = numbers_that_may_be_off(compared.runs, compared.without, 1.0);
  ASSERT_EQ(off.size(), 1u);
  EXPECT_EQ(off.front().name, "mass");
  const FittedHypothesis free = compared.fitted(slide(true_mass, true_damping), {});
  EXPECT_NEAR(off.front().estimate.value().value, free.fit.values[0], 1e-5);
  EXPECT_NEAR(off.front().estimate.value().value, true_mass, 1e-3);
  const double expected =
      quasi_bic(compared.without, 1.0) - quasi_bic(free, 1.0) - penalty_per_number(compared.without, 1.0);
  EXPECT_NEAR(off.front().gain, expected, 0.5);
}

TEST(NumbersOff, HaveNoValueWhereTheyAreAFunction) {
  replay::DeclaredModel declared = weighed_slide(true_mass + 0.05, 2e-4);
  declared.calibration.front().function = "path";
  const Held compared(sharp_run(0.0), declared);
  const auto off = numbers_that_may_be_off(compared.runs, compared.without, 1.0);
  ASSERT_EQ(off.size(), 1u);
  EXPECT_EQ(off.front().name, "path");
  EXPECT_FALSE(off.front().estimate.has_value());
}

// Both are held: the mass, which is right, does not make up for the damping, and is not named beside it.
TEST(NumbersOff, HaveNoneThatExplainsDecisivelyLess) {
  replay::DeclaredModel declared = weighed_slide(true_mass, 2e-3);
  replay::CalibrationParameter& damping = declared.calibration[1];
  damping.declared = 1.5 * true_damping;
  hold(damping, 0.05 * true_damping);
  const Held compared(sharp_run(0.0), declared);
  const auto off = numbers_that_may_be_off(compared.runs, compared.without, 1.0);
  ASSERT_EQ(off.size(), 1u);
  EXPECT_EQ(off.front().name, "damping");
  EXPECT_NEAR(off.front().estimate.value().value, true_damping, 0.02 * true_damping);
}

// Two and a half tolerances gain 6 before the charge of a number, which is 6; ten gain a hundred.
TEST(NumbersOff, AreNoneThatChanceMayHaveMovedSoFar) {
  const auto any = [](double tolerances) {
    constexpr double tolerance = 5e-3;
    const Held compared(sharp_run(0.0), weighed_slide(true_mass + tolerances * tolerance, tolerance));
    return !numbers_that_may_be_off(compared.runs, compared.without, 1.0).empty();
  };
  EXPECT_FALSE(any(0.5));
  EXPECT_FALSE(any(2.5));
  EXPECT_TRUE(any(10.0));
}

}  // namespace
}  // namespace coilwright::measurement::identification
