#include "coilwright/winding/wire.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "coilwright/winding/copper.hpp"
#include "error_text.hpp"
#include "winding/read_table.hpp"

namespace coilwright::winding {
namespace {

constexpr double mil = 25.4e-6;     // m
constexpr double kilofoot = 304.8;  // m

TEST(Wire, BareDiameterRoundsToThatOfTheMagnetWireStandard) {
  for (const auto& row : read_table("winding_magnet_wire.csv")) {
    // The standard prints a tenth of a mil.
    EXPECT_NEAR(gauge(static_cast<int>(row[0])).bare_diameter / mil, row[1], 0.05) << "AWG " << row[0];
  }
}

TEST(Wire, InsulatedDiameterAndAmpacityArePrintedInTheirSources) {
  for (const auto& row : read_table("winding_magnet_wire.csv")) {
    const Wire wire = gauge(static_cast<int>(row[0]));
    EXPECT_DOUBLE_EQ(wire.chassis_ampacity, row[4]) << "AWG " << row[0];
    if (std::isnan(row[2])) continue;  // the standard has no single build thicker than AWG 14
    EXPECT_NEAR(wire.insulated_diameter / mil, row[2], 1e-9) << "AWG " << row[0];  // the same decimal number
  }
}

TEST(Wire, HeavyBuildAndLimitsOfTheCopperArePrintedInTheirSources) {
  for (const auto& row : read_table("winding_magnet_wire.csv")) {
    const Wire wire = gauge(static_cast<int>(row[0]), Enamel::grade_2);
    EXPECT_NEAR(wire.least_bare / mil, row[6], 1e-9) << "AWG " << row[0];  // the same decimal numbers
    EXPECT_NEAR(wire.largest_bare / mil, row[7], 1e-9) << "AWG " << row[0];
    // NEMA's copper is from 1 % thinner to 0.5 % thicker than its nominal, or a tenth of a mil where that is more.
    constexpr double rounding = 0.051;
    EXPECT_LE(row[1] - row[6], std::max(0.01 * row[1], 0.1) + rounding) << "AWG " << row[0];
    EXPECT_LE(row[7] - row[1], std::max(0.005 * row[1], 0.1) + rounding) << "AWG " << row[0];
    if (std::isnan(row[5])) {
      EXPECT_EQ(wire.insulated_diameter, round_wire(wire.bare_diameter, Enamel::grade_2).insulated_diameter);
      continue;
    }
    EXPECT_NEAR(wire.insulated_diameter / mil, row[5], 1e-9) << "AWG " << row[0];
    EXPECT_GT(wire.insulated_diameter, gauge(static_cast<int>(row[0])).insulated_diameter) << "AWG " << row[0];
  }
}

TEST(Wire, ResistanceMatchesTheMakersTableAtTheSameDiameter) {
  for (const auto& row : read_table("winding_magnet_wire.csv")) {
    if (std::isnan(row[3])) continue;  // not in the source
    const Wire wire = gauge(static_cast<int>(row[0]));
    // The table is for diameters rounded to 0.1 mil, up to 1.3 % off; resistance goes with the inverse square.
    const double at_nominal = wire.resistance_per_length * std::pow(wire.bare_diameter / (row[1] * mil), 2) * kilofoot;
    // Four digits are printed, so half of the last is at most 5e-4 of the value; the resistivity has five.
    EXPECT_NEAR(at_nominal / row[3], 1.0, 5.5e-4) << "AWG " << row[0];
  }
}

TEST(Wire, AnchorsOfTheAmericanGaugeAreExact) {
  EXPECT_DOUBLE_EQ(gauge(36).bare_diameter, 0.127e-3);  // ASTM B258: 0.005 inch
  // Thirty-nine gauges up (0000) is 0.46 inch, so 20 gauges are a factor 92^(20/39).
  EXPECT_NEAR(gauge(20).bare_diameter / gauge(40).bare_diameter, std::pow(0.46 / 0.005, 20.0 / 39.0), 1e-13);
  EXPECT_NEAR(gauge(28).bare_diameter, 0.32e-3, 0.005e-3);  // "0.32 mm (28 AWG)" in the paper
}

TEST(Wire, EveryQuantityIsMonotonicOverTheWholeTable) {
  for (int awg = thickest_gauge; awg < thinnest_gauge; ++awg) {
    const Wire thick = gauge(awg), thin = gauge(awg + 1);
    EXPECT_EQ(thick.awg, awg);
    EXPECT_GT(thick.bare_diameter, thin.bare_diameter);
    EXPECT_GT(thick.insulated_diameter, thin.insulated_diameter);
    EXPECT_GT(thick.copper_section(), thin.copper_section());
    EXPECT_LT(thick.resistance_per_length, thin.resistance_per_length);
    EXPECT_GT(thick.chassis_ampacity, thin.chassis_ampacity);
    EXPECT_GT(thick.insulated_diameter, thick.bare_diameter);
  }
}

TEST(Wire, RejectsAGaugeOrADiameterThatThereIsNot) {
  EXPECT_EQ(error_text([] { (void)gauge(9); }), "awg: must be a whole number from 10 to 50; got 9");
  EXPECT_EQ(error_text([] { (void)gauge(51); }), "awg: must be a whole number from 10 to 50; got 51");
  EXPECT_EQ(error_text([] { (void)round_wire(0.017e-3); }),
            "bare_diameter: must be from 1.8e-05 to 0.005 m; got 1.7e-05");
  EXPECT_EQ(error_text([] { (void)round_wire(5.1e-3); }), "bare_diameter: must be from 1.8e-05 to 0.005 m; got 0.0051");
  EXPECT_EQ(error_text([] { (void)round_wire(std::nan("")); }),
            "bare_diameter: must be from 1.8e-05 to 0.005 m; got nan");
  EXPECT_EQ(error_text([] { (void)with_overall_diameter(round_wire(0.2e-3), 0.2e-3); }),
            "insulated_diameter: must be finite and above the largest copper of 0.2 mm (0.000203 m); got 0.0002");
}

// The standard prints overall diameters, the program has increases: two ways to write each row.
TEST(Wire, OfANominalDiameterHasTheOverallDiametersOfTheStandard) {
  const auto rows = read_table("winding_iec_wire.csv");
  ASSERT_EQ(rows.size(), 50U);
  for (const auto& row : rows) {
    const double bare = row[0] * 1e-3;
    EXPECT_NEAR(round_wire(bare, Enamel::grade_1).insulated_diameter * 1e3, row[1], 1e-9) << row[0];
    EXPECT_NEAR(round_wire(bare, Enamel::grade_2).insulated_diameter * 1e3, row[2], 1e-9) << row[0];
  }
}

// Another committee's table for the same film: both build to the same voltages.
TEST(Wire, OfIecGradeOneIsTheSingleBuildOfNema) {
  for (const auto& row : read_table("winding_magnet_wire.csv")) {
    if (std::isnan(row[2])) continue;
    const Wire american = gauge(static_cast<int>(row[0]));
    const Wire metric = round_wire(american.bare_diameter);
    EXPECT_NEAR(metric.insulated_diameter / american.insulated_diameter, 1.0, 0.014) << "AWG " << row[0];
    EXPECT_EQ(metric.resistance_per_length, american.resistance_per_length);
    EXPECT_EQ(metric.smooth_ampacity, american.smooth_ampacity);
    // At a row the slopes between rows meet; rounding of logarithms.
    EXPECT_NEAR(metric.chassis_ampacity / american.chassis_ampacity, 1.0, 1e-9);
  }
}

// NEMA's heavy build is wider than IEC's grade 2 in fine wires: a mould for grade 2 would not take it.
TEST(Wire, OfIecGradeTwoIsThinnerThanTheHeavyBuildOfFineGauges) {
  for (int awg = 24; awg <= 40; ++awg) {
    const Wire heavy = gauge(awg, Enamel::grade_2);
    const double over = heavy.insulated_diameter / round_wire(heavy.bare_diameter, Enamel::grade_2).insulated_diameter;
    EXPECT_GT(over, awg <= 30 ? 0.995 : 1.007) << "AWG " << awg;
    EXPECT_LT(over, awg <= 30 ? 1.0075 : 1.0325) << "AWG " << awg;
  }
}

TEST(Wire, BetweenTwoNominalDiametersLiesBetweenTheirs) {
  double thinner = round_wire(least_bare_diameter).insulated_diameter;
  for (double bare = least_bare_diameter * 1.01; bare < largest_bare_diameter; bare *= 1.01) {
    const Wire wire = round_wire(bare);
    EXPECT_GT(wire.insulated_diameter, thinner) << bare;
    EXPECT_GT(round_wire(bare, Enamel::grade_2).insulated_diameter, wire.insulated_diameter) << bare;
    EXPECT_LT(wire.least_bare, bare);
    EXPECT_GT(wire.largest_bare, bare);
    EXPECT_LT(wire.largest_bare, wire.insulated_diameter) << bare;
    thinner = wire.insulated_diameter;
  }
}

TEST(Wire, IsCalledAsItIsOrdered) {
  EXPECT_EQ(gauge(28).name(), "AWG 28");
  EXPECT_EQ(gauge(28).enamel_name(), "single build");
  EXPECT_EQ(gauge(28, Enamel::grade_2).enamel_name(), "heavy build");
  EXPECT_EQ(round_wire(0.25e-3).name(), "0.25 mm");
  EXPECT_EQ(round_wire(0.25e-3).enamel_name(), "grade 1");
  EXPECT_EQ(with_overall_diameter(round_wire(0.25e-3), 0.3e-3).enamel_name(), "0.3 mm over the enamel");
}

TEST(Copper, ResistanceGrowsByTheStandardsCoefficient) {
  EXPECT_DOUBLE_EQ(copper_resistance_ratio(20.0), 1.0);
  // IEC 60028 in the form engineers know: resistances are as 234.5 + T (rounded to 0.1 K by it).
  EXPECT_NEAR(copper_resistance_ratio(155.0), (234.5 + 155.0) / (234.5 + 20.0), 2e-4);
}

TEST(Copper, RejectsTemperaturesWhereTheLinearLawEnds) {
  EXPECT_EQ(error_text([] { (void)copper_resistance_ratio(-250.0); }),
            "temperature: must be finite and above -234.5 degC, where the linear law ends; got -250");
  EXPECT_EQ(error_text([] { (void)copper_resistance_ratio(std::nan("")); }),
            "temperature: must be finite and above -234.5 degC, where the linear law ends; got nan");
}

// The exponents again: least squares of the logarithms through AWG 28 and through AWG 20, and how far the table lies
// from the laws.
TEST(Wire, SmoothAmpacityFollowsTheTable) {
  const auto exponent = [](int from, int to, int through, double ampacity) {
    double products = 0.0, squares = 0.0;
    for (int awg = from; awg <= to; ++awg) {
      const double x = std::log(gauge(awg).bare_diameter / gauge(through).bare_diameter);
      products += x * std::log(gauge(awg).chassis_ampacity / ampacity);
      squares += x * x;
    }
    return products / squares;
  };
  EXPECT_NEAR(exponent(20, 40, 28, 1.4), 2.0601, 5e-5);  // the digits of the constants
  EXPECT_NEAR(exponent(10, 19, 20, gauge(20).smooth_ampacity), 1.6254, 5e-5);
  EXPECT_EQ(gauge(28).smooth_ampacity, 1.4);
  for (int awg = 23; awg <= 39; ++awg)
    EXPECT_NEAR(gauge(awg).chassis_ampacity / gauge(awg).smooth_ampacity, 1.0, awg == 29 || awg == 39 ? 0.09 : 0.06)
        << awg;
  for (int awg = 10; awg <= 22; ++awg) {
    const double over = gauge(awg).chassis_ampacity / gauge(awg).smooth_ampacity;
    EXPECT_GT(over, awg < 14 ? 0.88 : 1.09) << awg;
    EXPECT_LT(over, awg < 14 ? 0.99 : 1.23) << awg;
  }
  // No gauge carries more per section than a thicker one and a thinner one together suggest.
  for (int awg = thickest_gauge; awg < thinnest_gauge; ++awg)
    EXPECT_NEAR(gauge(awg).smooth_ampacity / gauge(awg + 1).smooth_ampacity,
                awg < 20 ? gauge(12).smooth_ampacity / gauge(13).smooth_ampacity
                         : gauge(28).smooth_ampacity / gauge(29).smooth_ampacity,
                1e-12);
}

TEST(Wire, AsSoldHasTheLeastAndLargestResistanceOfTheMakersTable) {
  for (const auto& row : read_table("winding_bare_wire.csv")) {
    const Wire wire = gauge(static_cast<int>(row[0]));
    const double nominal = wire.resistance_per_length * kilofoot;
    const ResistanceRange range = resistance_range(wire);
    // Four digits are printed, so half of the last is at most 5e-4 of the value; the resistivity has five.
    // Up to AWG 26 the table has an older limit of the thickest copper.
    if (!std::isnan(row[1])) {
      EXPECT_NEAR(nominal * range.least / row[1], 1.0, 5.5e-4) << "AWG " << row[0];
    }
    EXPECT_NEAR(nominal * range.largest / row[2], 1.0, 5.5e-4) << "AWG " << row[0];
  }
}

TEST(Wire, AsSoldEnclosesTheNominalAndLeavesTheEnamelRoom) {
  for (int awg = thickest_gauge; awg <= thinnest_gauge; ++awg) {
    const Wire wire = gauge(awg);
    EXPECT_LT(wire.least_bare, wire.bare_diameter) << "AWG " << awg;
    EXPECT_GT(wire.largest_bare, wire.bare_diameter) << "AWG " << awg;
    EXPECT_LT(wire.largest_bare, wire.insulated_diameter) << "AWG " << awg;
  }
}

}  // namespace
}  // namespace coilwright::winding
