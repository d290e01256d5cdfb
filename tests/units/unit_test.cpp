#include "coilwright/units/unit.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>
#include <string>

#include "coilwright/units/plausible.hpp"

namespace coilwright::units {
namespace {

Unit unit(std::string_view name) {
  return split_unit(name).value().unit;
}

TEST(Units, AreTheLongestEndOfAName) {
  EXPECT_EQ(split_unit("gap_mm")->quantity, "gap");
  EXPECT_EQ(split_unit("omega1_deg_s")->quantity, "omega1");
  EXPECT_EQ(split_unit("omega1_deg_s")->unit.suffix, "deg_s");
  EXPECT_EQ(split_unit("stiffness_Nmm_rad")->unit.suffix, "Nmm_rad");
  EXPECT_EQ(split_unit("damping_Nms_rad")->unit.suffix, "Nms_rad");
}

TEST(Units, OfOneDimensionHaveOneGreatestPlausibleNumber) {
  EXPECT_DOUBLE_EQ(greatest_plausible(unit("angle_deg")), 3600);
  EXPECT_DOUBLE_EQ(greatest_plausible(unit("mass_g")), 1e6);
  EXPECT_DOUBLE_EQ(greatest_plausible(unit("t_degC")), greatest_plausible(unit("t_K")));
  EXPECT_GT(greatest_plausible(unit("stiffness_Nm_rad")), 25845);  // a membrane with 10 g at 256 Hz, a metre a radian
  for (const Unit& a : all_units())
    for (const Unit& b : all_units()) {
      if (a.dimension != b.dimension) continue;
      const double in_a = greatest_plausible(a) * a.numerator / a.denominator;
      EXPECT_NEAR(in_a / (greatest_plausible(b) * b.numerator / b.denominator), 1.0, 1e-14);  // two roundings of each
    }
}

TEST(Units, AreNotSeenInWordsOrBareSuffixes) {
  EXPECT_FALSE(split_unit("turns_radial"));
  EXPECT_FALSE(split_unit("gap"));
  EXPECT_FALSE(split_unit("mm"));
  EXPECT_FALSE(split_unit("_mm"));
  EXPECT_FALSE(split_unit("gap_MM"));
  EXPECT_FALSE(split_unit(""));
}

TEST(Units, ConvertToTheNearestDoubleOfTheDecimal) {
  // Each right side is a decimal literal: the compiler's nearest double. Multiplying by 1e-3 misses several of them.
  EXPECT_EQ(to_si(9.9, unit("radius_mm")), 0.0099);
  EXPECT_EQ(to_si(4.35, unit("radius_mm")), 0.00435);
  EXPECT_EQ(to_si(12.4, unit("stiffness_Nmm_rad")), 0.0124);
  EXPECT_EQ(to_si(17.3, unit("mass_g")), 0.0173);
  EXPECT_EQ(to_si(1320.0, unit("remanence_mT")), 1.32);
  EXPECT_EQ(to_si(0.31, unit("modulus_MPa")), 310000.0);
  EXPECT_EQ(to_si(1.07, unit("density_g_cm3")), 1070.0);
  EXPECT_EQ(to_si(35.0, unit("margin_pct")), 0.35);
}

TEST(Units, ConvertAnglesAndTemperatures) {
  EXPECT_EQ(to_si(180.0, unit("angle_deg")), std::numbers::pi);
  EXPECT_EQ(to_si(90.0, unit("speed_deg_s")), std::numbers::pi / 2);
  EXPECT_EQ(to_si(80.0, unit("limit_degC")), 353.15);
  EXPECT_EQ(to_si(-273.15, unit("limit_degC")), 0.0);
  // 1 N mm per degree is 180/pi N mm per radian.
  EXPECT_NEAR(to_si(1.0, unit("stiffness_Nmm_deg")), 0.05729577951308232, 1e-17);  // one rounding of 0.057
}

// Keys of the effects' parameters (docs/theory/effects.md).
TEST(Units, KnowWhatIsOverAUnit) {
  EXPECT_EQ(split_unit("coefficient_1_rad2")->quantity, "coefficient");
  EXPECT_EQ(split_unit("sharpness_1_rad")->quantity, "sharpness");
  EXPECT_EQ(split_unit("fade_1_A2")->quantity, "fade");
  EXPECT_EQ(split_unit("conductance_1_Ohm")->quantity, "conductance");
  EXPECT_EQ(to_si(0.4, unit("drag_Nmms2_rad2")), 0.0004);
}

TEST(Units, OfTheMeasuredDataFormatAreAllThere) {
  for (const std::string suffix :
       {"s", "A", "V", "Nm", "Nmm", "N", "deg", "rad", "deg_s", "rad_s", "degC", "m", "mm"}) {
    EXPECT_EQ(unit("x_" + suffix).suffix, suffix);
  }
}

// NIST SP 811 (2008), appendix B.8.
TEST(Units, OfBalancesAndWrenchesAreThoseOfTheTables) {
  EXPECT_DOUBLE_EQ(to_si(1.0, unit("force_lbf")), 4.4482216152605);
  EXPECT_DOUBLE_EQ(to_si(16.0, unit("force_ozf")), to_si(1.0, unit("force_lbf")));
  EXPECT_DOUBLE_EQ(to_si(1000.0, unit("force_gf")), 9.80665);
  EXPECT_DOUBLE_EQ(to_si(1.0, unit("torque_kgfcm")), 0.0980665);
  EXPECT_NEAR(to_si(1.0, unit("torque_lbfft")), 1.355818, 5e-7);
  EXPECT_NEAR(to_si(1.0, unit("torque_ozfin")), 7.061552e-3, 5e-10);
  EXPECT_DOUBLE_EQ(to_si(77.0, unit("temperature_degF")), 298.15);
  EXPECT_DOUBLE_EQ(to_si(9.0, difference_unit("temperature_degF")), 5.0);
  EXPECT_EQ(to_si(2.0, unit("time_min")), 120.0);
}

TEST(Units, HaveEachSuffixOnce) {
  std::set<std::string_view> seen;
  for (const Unit& each : all_units()) EXPECT_TRUE(seen.insert(each.suffix).second) << each.suffix;
}

TEST(Units, GiveBackTheDecimalThatWasRead) {
  for (const double value : {9.9, 4.35, 0.1, 17.3, 123.456, 1e-7, -2.7, 1.4}) {
    for (const Unit& each : all_units()) {
      if (each.offset != 0.0) continue;
      EXPECT_EQ(from_si(to_si(value, each), each), value) << each.suffix;
    }
  }
  EXPECT_EQ(from_si(353.15, "limit_degC"), 80.0);
  EXPECT_EQ(from_si(0.25, "no unit"), 0.25);
}

// A factor with pi rounds twice, and its way back is not the nearest quotient for one number in forty.
TEST(Units, GiveBackTheVeryDoubleWhateverItsDigits) {
  std::mt19937_64 random(20250311);
  std::uniform_real_distribution<double> anything(0.1, 100.0);
  for (int i = 0; i < 2000; ++i)
    for (const std::string_view name : {"angle_deg", "stiffness_Nm_deg", "stiffness_Nmm_deg", "gap_mm", "mass_g"}) {
      const double value = to_memory(anything(random), name);
      EXPECT_EQ(to_memory(from_memory(value, name), name), value) << name;
    }
}

TEST(Units, LeaveATemperatureInDegreesCelsiusWhereMemoryDoes) {
  EXPECT_EQ(to_memory(80.0, "temperature_limit_degC"), 80.0);
  EXPECT_EQ(from_memory(80.0, "temperature_limit_degC"), 80.0);
  EXPECT_EQ(to_memory(9.9, "radius_mm"), 0.0099);
  EXPECT_EQ(from_memory(0.0099, "radius_mm"), 9.9);
  EXPECT_EQ(to_memory(180.0, "base_tilt_deg"), std::numbers::pi);
  EXPECT_EQ(to_memory(15.0, "turns_radial"), 15.0);
}

TEST(Units, OfADifferenceHaveNoOffset) {
  EXPECT_EQ(difference_unit("coil_temperature_degC").suffix, "K");
  EXPECT_EQ(to_si(2.5, difference_unit("coil_temperature_degC")), 2.5);
  EXPECT_EQ(difference_unit("peak_speed_deg_s").suffix, "deg_s");
  EXPECT_EQ(difference_unit("damping_ratio").suffix, "");
}

TEST(Units, OfANumberInAListStandAtTheEndOfItsName) {
  EXPECT_EQ(key_with_unit("/magnetics/0/torque_Nmm_A/12"), "/magnetics/0/torque_Nmm_A");
  EXPECT_EQ(key_with_unit("/links/0/mass_kg"), "/links/0/mass_kg");
  EXPECT_EQ(key_with_unit("torque_Nmm"), "torque_Nmm");
}

}  // namespace
}  // namespace coilwright::units
