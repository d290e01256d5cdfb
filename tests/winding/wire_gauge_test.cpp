#include "coilwright/winding/wire_gauge.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "coilwright/winding/copper.hpp"
#include "error_text.hpp"
#include "winding/read_table.hpp"

namespace coilwright::winding {
namespace {

constexpr double mil = 25.4e-6;     // m
constexpr double kilofoot = 304.8;  // m

TEST(WireGauge, BareDiameterRoundsToThatOfTheMagnetWireStandard) {
  for (const auto& row : read_table("winding_magnet_wire.csv")) {
    // The standard prints a tenth of a mil.
    EXPECT_NEAR(gauge(static_cast<int>(row[0])).bare_diameter / mil, row[1], 0.05) << "AWG " << row[0];
  }
}

TEST(WireGauge, InsulatedDiameterAndAmpacityArePrintedInTheirSources) {
  for (const auto& row : read_table("winding_magnet_wire.csv")) {
    const WireGauge wire = gauge(static_cast<int>(row[0]));
    EXPECT_NEAR(wire.insulated_diameter / mil, row[2], 1e-9) << "AWG " << row[0];  // the same decimal number
    EXPECT_DOUBLE_EQ(wire.chassis_ampacity, row[4]) << "AWG " << row[0];
  }
}

TEST(WireGauge, ResistanceMatchesTheMakersTableAtTheSameDiameter) {
  for (const auto& row : read_table("winding_magnet_wire.csv")) {
    if (std::isnan(row[3])) continue;  // not in the source
    const WireGauge wire = gauge(static_cast<int>(row[0]));
    // The table is for diameters rounded to 0.1 mil, up to 1.3 % off; resistance goes with the inverse square.
    const double at_nominal = wire.resistance_per_length * std::pow(wire.bare_diameter / (row[1] * mil), 2) * kilofoot;
    // Four digits are printed, so half of the last is at most 5e-4 of the value; the resistivity has five.
    EXPECT_NEAR(at_nominal / row[3], 1.0, 5.5e-4) << "AWG " << row[0];
  }
}

TEST(WireGauge, AnchorsOfTheAmericanGaugeAreExact) {
  EXPECT_DOUBLE_EQ(gauge(36).bare_diameter, 0.127e-3);  // ASTM B258: 0.005 inch
  // Thirty-nine gauges up (0000) is 0.46 inch, so 20 gauges are a factor 92^(20/39).
  EXPECT_NEAR(gauge(20).bare_diameter / gauge(40).bare_diameter, std::pow(0.46 / 0.005, 20.0 / 39.0), 1e-13);
  EXPECT_NEAR(gauge(28).bare_diameter, 0.32e-3, 0.005e-3);  // "0.32 mm (28 AWG)" in the paper
}

TEST(WireGauge, EveryQuantityIsMonotonicOverTheWholeTable) {
  for (int awg = thickest_gauge; awg < thinnest_gauge; ++awg) {
    const WireGauge thick = gauge(awg), thin = gauge(awg + 1);
    EXPECT_EQ(thick.awg, awg);
    EXPECT_GT(thick.bare_diameter, thin.bare_diameter);
    EXPECT_GT(thick.insulated_diameter, thin.insulated_diameter);
    EXPECT_GT(thick.copper_section(), thin.copper_section());
    EXPECT_LT(thick.resistance_per_length, thin.resistance_per_length);
    EXPECT_GT(thick.chassis_ampacity, thin.chassis_ampacity);
    EXPECT_GT(thick.insulated_diameter, thick.bare_diameter);
  }
}

TEST(WireGauge, RejectsAGaugeThatIsNotInTheTable) {
  EXPECT_EQ(error_text([] { (void)gauge(19); }), "awg: must be a whole number from 20 to 40; got 19");
  EXPECT_EQ(error_text([] { (void)gauge(41); }), "awg: must be a whole number from 20 to 40; got 41");
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

// The exponent again: least squares of the logarithms through AWG 28, and how far the table lies from the law.
TEST(WireGauge, SmoothAmpacityFollowsTheTable) {
  double products = 0.0, squares = 0.0;
  for (int awg = thickest_gauge; awg <= thinnest_gauge; ++awg) {
    const double x = std::log(gauge(awg).bare_diameter / gauge(28).bare_diameter);
    products += x * std::log(gauge(awg).chassis_ampacity / 1.4);
    squares += x * x;
  }
  EXPECT_NEAR(products / squares, 2.0601, 5e-5);  // the digits of the constant
  EXPECT_EQ(gauge(28).smooth_ampacity, 1.4);
  for (int awg = 23; awg <= 39; ++awg)
    EXPECT_NEAR(gauge(awg).chassis_ampacity / gauge(awg).smooth_ampacity, 1.0, awg == 29 || awg == 39 ? 0.09 : 0.06)
        << awg;
  // No gauge carries more per section than a thicker one and a thinner one together suggest.
  for (int awg = thickest_gauge; awg < thinnest_gauge; ++awg)
    EXPECT_NEAR(gauge(awg).smooth_ampacity / gauge(awg + 1).smooth_ampacity,
                gauge(28).smooth_ampacity / gauge(29).smooth_ampacity, 1e-12);
}

}  // namespace
}  // namespace coilwright::winding
