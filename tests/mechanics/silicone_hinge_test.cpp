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

// The audit's figures for the prototype: 12.04 N mm/rad at nu = 0.49, 12.20 at 0.5, against 12.5 measured.
TEST(SiliconeHinge, OfASlitIsThePrototypesWithNothingFitted) {
  const Ligament prototype{.width = 22e-3, .height = 2.5e-3, .slot_width = 0.0};
  const double modulus = young_modulus_from_shore_a(28.0);
  EXPECT_NEAR(ligament_stiffness(prototype, {.young_modulus = modulus, .poisson_ratio = 0.49}), 12.04e-3, 0.005e-3);
  EXPECT_NEAR(ligament_stiffness(prototype, {.young_modulus = modulus, .poisson_ratio = 0.5}), 12.20e-3, 0.005e-3);
}

TEST(SiliconeHinge, OfASlitStiffensWithTheSquareOfItsHeight) {
  const Rubber rubber{.young_modulus = 0.8e6, .poisson_ratio = 0.47};
  const double base = ligament_stiffness({.width = 17e-3, .height = 1.7e-3, .slot_width = 0.0}, rubber);
  const double twice = ligament_stiffness({.width = 34e-3, .height = 5.1e-3, .slot_width = 0.0}, rubber);
  EXPECT_NEAR(twice / base, 2.0 * 9.0, 1e-13);
}

// Far beyond its height a slot is a plane-strain beam of its own length, a little longer or shorter at its ends.
TEST(SiliconeHinge, OfAWideSlotIsABeam) {
  const Rubber rubber{.young_modulus = 0.8e6, .poisson_ratio = 0.47};
  const double slot = ligament_stiffness({.width = 17e-3, .height = 1e-3, .slot_width = 1.0}, rubber);
  const double beam = hinge_stiffness({.width = 17e-3, .height = 1e-3, .length = 1.0}, 0.8e6 / (1.0 - 0.47 * 0.47));
  EXPECT_NEAR(slot / beam, 1.0, 15.8 / 12e3);
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
  const Ligament slit{.width = 22e-3, .height = 2.5e-3, .slot_width = 0.0};
  EXPECT_EQ(message([&] { (void)ligament_stiffness(slit, {.young_modulus = 1e6, .poisson_ratio = 0.51}); }),
            "poisson_ratio must lie in 0 to 0.5; got 0.51");
  EXPECT_EQ(message([&] { (void)ligament_stiffness(slit, {.young_modulus = -1e6, .poisson_ratio = 0.49}); }),
            "young_modulus must be finite and > 0; got -1000000");
  EXPECT_EQ(message([] {
              (void)ligament_stiffness({.width = 1.0, .height = 1.0, .slot_width = -0.1}, {1e6, 0.49});
            }),
            "slot_width must be finite and >= 0; got -0.1");
  EXPECT_EQ(message([] { (void)young_modulus_from_shore_a(5.0); }), "shore_a must lie in 20 to 80; got 5");
}

}  // namespace
}  // namespace coilwright::mechanics
