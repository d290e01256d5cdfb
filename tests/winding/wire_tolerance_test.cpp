#include "coilwright/winding/wire_tolerance.hpp"

#include <gtest/gtest.h>

#include "coilwright/winding/wire_gauge.hpp"
#include "error_text.hpp"
#include "winding/read_table.hpp"

namespace coilwright::winding {
namespace {

constexpr double kilofoot = 304.8;  // m

TEST(WireTolerance, GivesTheLeastAndLargestResistanceOfTheMakersTable) {
  for (const auto& row : read_table("winding_bare_wire.csv")) {
    const int awg = static_cast<int>(row[0]);
    const double nominal = gauge(awg).resistance_per_length * kilofoot;
    const ResistanceRange range = resistance_range(awg);
    // Four digits are printed, so half of the last is at most 5e-4 of the value; the resistivity has five.
    EXPECT_NEAR(nominal * range.least / row[1], 1.0, 5.5e-4) << "AWG " << awg;
    EXPECT_NEAR(nominal * range.largest / row[2], 1.0, 5.5e-4) << "AWG " << awg;
  }
}

TEST(WireTolerance, EncloseTheGaugeAndLeaveTheEnamelRoom) {
  for (int awg = thickest_gauge; awg <= thinnest_gauge; ++awg) {
    const WireGauge wire = gauge(awg);
    const BareDiameters sold = bare_diameters(awg);
    EXPECT_LT(sold.least, wire.bare_diameter) << "AWG " << awg;
    EXPECT_GT(sold.largest, wire.bare_diameter) << "AWG " << awg;
    EXPECT_LT(sold.largest, wire.insulated_diameter) << "AWG " << awg;
  }
}

TEST(WireTolerance, RejectsAGaugeThatIsNotInTheTable) {
  EXPECT_EQ(error_text([] { (void)bare_diameters(41); }), "awg: must be a whole number from 20 to 40; got 41");
  EXPECT_EQ(error_text([] { (void)resistance_range(19); }), "awg: must be a whole number from 20 to 40; got 19");
}

}  // namespace
}  // namespace coilwright::winding
