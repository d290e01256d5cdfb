#include "coilwright/winding/winding.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "coilwright/winding/copper.hpp"
#include "coilwright/winding/inductance.hpp"
#include "error_text.hpp"

namespace coilwright::winding {
namespace {

Winding prototype() {
  return Winding{{.inner_radius = 3e-3, .turns_radial = 15, .turns_axial = 30, .wire = gauge(28)}};
}

// Table II of the paper gives r_c, R_c, l_c, N_r and N_z; wire length, mass and resistance were worked out from them by
// hand (450 turns, 2 pi 6.25 mm each).
TEST(Winding, OfThePrototypeHasItsDimensionsAndResistance) {
  const Winding coil = prototype();
  EXPECT_EQ(coil.turns(), 450);
  EXPECT_NEAR(coil.outer_radius(), 9.5e-3, 1e-15);  // rounding
  EXPECT_NEAR(coil.length(), 12e-3, 1e-15);
  EXPECT_NEAR(coil.mean_radius(), 6.25e-3, 1e-15);
  EXPECT_NEAR(coil.wire_length(), 17.67, 0.005);    // digits quoted
  EXPECT_NEAR(coil.resistance(20.0), 3.76, 0.005);  // digits quoted
  // Quoted for wire of 0.32 mm; AWG 28 is 0.3211 mm.
  const double at_quoted_diameter = coil.copper_mass() * std::pow(0.32e-3 / coil.wire().bare_diameter, 2);
  EXPECT_NEAR(at_quoted_diameter, 12.7e-3, 0.05e-3);  // digits quoted
  EXPECT_DOUBLE_EQ(coil.wire().chassis_ampacity, 1.4);
}

TEST(Winding, WireLengthIsTheSumOfItsTurns) {
  for (const Packing& packing : {Packing::prototype(), Packing::orthocyclic()}) {
    const Winding coil{
        {.inner_radius = 4.1e-3, .turns_radial = 6, .turns_axial = 11, .wire = gauge(33), .packing = packing}};
    double sum = 0.0;
    for (int layer = 0; layer < 6; ++layer) sum += 11 * 2.0 * std::numbers::pi * layer_radius(coil, layer);
    EXPECT_NEAR(coil.wire_length() / sum, 1.0, 1e-14);  // rounding
    // Layers are centred in the winding whatever their pitch.
    EXPECT_NEAR(0.5 * (layer_radius(coil, 0) + layer_radius(coil, 5)) / coil.mean_radius(), 1.0, 1e-14);
  }
}

TEST(Winding, ResistanceTimesMassDependsOnWireLengthOnly) {
  // R m = rho density l^2 whatever the gauge: an independent relation between three results.
  for (const int awg : {22, 29, 38}) {
    const Winding coil{{.inner_radius = 3.7e-3, .turns_radial = 9, .turns_axial = 14, .wire = gauge(awg)}};
    const double length = coil.wire_length();
    EXPECT_NEAR(coil.resistance(20.0) * coil.copper_mass() / (1.7241e-8 * 8960.0 * length * length), 1.0, 1e-13);
  }
}

TEST(Winding, ResistanceFollowsTemperature) {
  const Winding coil = prototype();
  EXPECT_NEAR(coil.resistance(155.0) / coil.resistance(20.0), 1.0 + 0.00393 * 135.0, 1e-14);
}

TEST(Winding, CopperFractionIsTurnsTimesSectionOverTheWindow) {
  // 450 circles of 0.3211 mm in 6.5 mm by 12 mm.
  EXPECT_NEAR(prototype().copper_fraction(), 450.0 * 0.25 * std::numbers::pi * 0.3211 * 0.3211 / (6.5 * 12.0), 3e-4);
}

TEST(Winding, FitSaysByHowMuchARoomIsTooSmall) {
  const Winding coil = prototype();
  const Fit loose = fit(coil, {.outer_radius = 10.2e-3, .length = 12.5e-3});
  EXPECT_TRUE(loose.fits());
  EXPECT_NEAR(loose.radial_excess, -0.7e-3, 1e-15);
  EXPECT_NEAR(loose.axial_excess, -0.5e-3, 1e-15);
  const Fit narrow = fit(coil, {.outer_radius = 9.1e-3, .length = 12.5e-3});
  EXPECT_FALSE(narrow.fits());
  EXPECT_NEAR(narrow.radial_excess, 0.4e-3, 1e-15);
  const Fit brief = fit(coil, {.outer_radius = std::numeric_limits<double>::infinity(), .length = 11.7e-3});
  EXPECT_FALSE(brief.fits());
  EXPECT_NEAR(brief.axial_excess, 0.3e-3, 1e-15);
}

TEST(Winding, ThatFillsItsRoomExactlyFits) {
  EXPECT_TRUE(fit(prototype(), {.outer_radius = 9.5e-3, .length = 12e-3}).fits());
  EXPECT_FALSE(fit(prototype(), {.outer_radius = 9.5e-3 - 1e-9, .length = 12e-3}).fits());
}

TEST(Winding, InductanceIsThatOfItsSection) {
  // The prototype by Wheeler's formula for multilayer coils, 0.8 a^2 n^2 / (6 a + 9 b + 10 c) microhenry in inches,
  // good to a few per cent where the three terms are alike (here 1.5, 4.3, 2.6).
  const double inch = 25.4e-3;
  const double a = 6.25e-3 / inch, b = 12e-3 / inch, c = 6.5e-3 / inch;
  const double wheeler = 0.8e-6 * a * a * 450.0 * 450.0 / (6.0 * a + 9.0 * b + 10.0 * c);
  EXPECT_NEAR(prototype().inductance() / wheeler, 1.0, 0.03);
}

TEST(Winding, RejectsInputsOutsideTheirRules) {
  const auto text = [](auto change) {
    Winding::Spec spec{.inner_radius = 3e-3, .turns_radial = 15, .turns_axial = 30, .wire = gauge(28)};
    change(spec);
    return error_text([&] { Winding{spec}; });
  };
  EXPECT_EQ(text([](auto& s) { s.turns_radial = 0; }), "turns_radial: must be >= 1; got 0");
  EXPECT_EQ(text([](auto& s) { s.turns_axial = -3; }), "turns_axial: must be >= 1; got -3");
  EXPECT_EQ(text([](auto& s) { s.turns_axial = 1 << 30; }),
            "turns_radial * turns_axial: must be at most 2147483647; got 15 * 1073741824");
  EXPECT_EQ(text([](auto& s) { s.wire = {}; }), "wire.bare_diameter: must be > 0; got 0");
  EXPECT_EQ(text([](auto& s) { s.inner_radius = 0.5e-3; }),
            "inner_radius: must be finite and >= 0.0005334 m (1.5 insulated diameters of AWG 28); got 0.0005");
  EXPECT_EQ(text([](auto& s) { s.inner_radius = std::nan(""); }),
            "inner_radius: must be finite and >= 0.0005334 m (1.5 insulated diameters of AWG 28); got nan");
}

TEST(Winding, RejectsRoomsAndLayersThatDoNotExist) {
  EXPECT_EQ(error_text([] { (void)fit(prototype(), {.outer_radius = 0.0, .length = 1e-2}); }),
            "room.outer_radius: must be > 0; got 0");
  EXPECT_EQ(error_text([] { (void)fit(prototype(), {.outer_radius = 1e-2, .length = -2.0}); }),
            "room.length: must be > 0; got -2");
  EXPECT_EQ(error_text([] { (void)layer_radius(prototype(), 15); }), "layer: must be from 0 to 14; got 15");
}

}  // namespace
}  // namespace coilwright::winding
