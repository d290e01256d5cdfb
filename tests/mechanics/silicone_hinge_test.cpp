#include "coilwright/mechanics/silicone_hinge.hpp"

#include <gtest/gtest.h>

#include <string>

namespace coilwright::mechanics {
namespace {

// Elastosil M 4601 is Shore 28A; the errata of the source paper works with E = 1.05 MPa and finds L = 2.4 mm for the
// prototype's 12.5 N mm/rad. Both are quoted to their last digit.
TEST(SiliconeHinge, GivesThePrototypesStiffness) {
  const double modulus = young_modulus_from_shore_a(28.0);
  EXPECT_NEAR(modulus, 1.05e6, 0.005e6);
  EXPECT_NEAR(hinge_stiffness({.width = 22e-3, .height = 2.5e-3, .length = 2.4e-3}, modulus), 12.5e-3, 0.1e-3);
}

TEST(SiliconeHinge, StiffensWithTheCubeOfItsHeightAndLinearlyWithWidth) {
  const HingeStrip strip{.width = 17e-3, .height = 1.7e-3, .length = 3.1e-3};
  const double base = hinge_stiffness(strip, 0.8e6);
  EXPECT_NEAR(hinge_stiffness({.width = 34e-3, .height = 1.7e-3, .length = 3.1e-3}, 0.8e6) / base, 2.0, 1e-14);
  EXPECT_NEAR(hinge_stiffness({.width = 17e-3, .height = 3.4e-3, .length = 3.1e-3}, 0.8e6) / base, 8.0, 1e-13);
}

TEST(SiliconeHinge, NamesTheFieldTheRuleAndTheValue) {
  const auto message = [](auto&& action) -> std::string {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_EQ(message([] { (void)hinge_stiffness({.width = 22e-3, .height = 0.0, .length = 2e-3}, 1e6); }),
            "height must be finite and > 0; got 0");
  EXPECT_EQ(message([] { (void)young_modulus_from_shore_a(5.0); }), "shore_a must lie in 20 to 80; got 5");
}

}  // namespace
}  // namespace coilwright::mechanics
