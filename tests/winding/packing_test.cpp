#include "coilwright/winding/packing.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "coilwright/winding/winding.hpp"
#include "error_text.hpp"

namespace coilwright::winding {
namespace {

struct Point {
  double axial, radial;
};

// Centres of all wires, as a winder would place them: every second layer half a pitch aside if layers nest.
std::vector<Point> centres(const Winding& winding) {
  std::vector<Point> points;
  for (int layer = 0; layer < winding.spec().turns_radial; ++layer) {
    const double shift = winding.spec().packing.nested() && layer % 2 == 1 ? 0.5 : 0.0;
    for (int turn = 0; turn < winding.spec().turns_axial; ++turn) {
      points.push_back({(turn + 0.5 + shift) * winding.axial_pitch(), layer_radius(winding, layer)});
    }
  }
  return points;
}

// Rounding of sums of a dozen pitches, in diameters.
constexpr double rounding = 1e-12;

TEST(Packing, WiresNeitherOverlapNorStandOutOfTheWinding) {
  const Packing packings[] = {Packing::prototype(), Packing::orthocyclic(), Packing::square(),
                              Packing{{.axial = 1.13, .radial = 0.93}}, Packing{{.axial = 1.87, .radial = 0.5}}};
  for (const Packing& packing : packings) {
    const Winding winding{
        {.inner_radius = 2.3e-3, .turns_radial = 5, .turns_axial = 7, .wire = gauge(31), .packing = packing}};
    const double diameter = winding.wire().insulated_diameter;
    const auto points = centres(winding);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_GE(points[i].radial - 0.5 * diameter, winding.inner_radius() - rounding * diameter);
      EXPECT_LE(points[i].radial + 0.5 * diameter, winding.outer_radius() + rounding * diameter);
      EXPECT_GE(points[i].axial - 0.5 * diameter, -rounding * diameter);
      EXPECT_LE(points[i].axial + 0.5 * diameter, winding.length() + rounding * diameter);
      for (std::size_t j = 0; j < i; ++j) {
        const double distance = std::hypot(points[i].axial - points[j].axial, points[i].radial - points[j].radial);
        EXPECT_GE(distance, diameter * (1.0 - rounding));
      }
    }
  }
}

TEST(Packing, OrthocyclicWindingsApproachTheDensestPackingOfCircles) {
  const Winding winding{{.inner_radius = 9e-3,
                         .turns_radial = 500,
                         .turns_axial = 700,
                         .wire = gauge(37),
                         .packing = Packing::orthocyclic()}};
  const double bare_to_insulated = winding.wire().bare_diameter / winding.wire().insulated_diameter;
  const double circles = winding.copper_fraction() / (bare_to_insulated * bare_to_insulated);
  // Edges cost half a pitch in 700 and 0.13 of a layer in 433: 1.0e-3.
  EXPECT_NEAR(circles, std::numbers::pi / (2.0 * std::numbers::sqrt3), 1.1e-3);
}

TEST(Packing, DefaultsToThePrototypesPitches) {
  const Winding winding{{.inner_radius = 3e-3, .turns_radial = 15, .turns_axial = 30, .wire = gauge(28)}};
  EXPECT_NEAR(winding.axial_pitch(), 0.4e-3, 1e-15);          // 12 mm over 30 turns; tolerance: rounding
  EXPECT_NEAR(winding.radial_pitch(), 6.5e-3 / 15.0, 1e-15);  // 6.5 mm over 15 layers
  EXPECT_DOUBLE_EQ(Packing{}.axial(), Packing::prototype().axial());
  EXPECT_DOUBLE_EQ(Packing{}.radial(), Packing::prototype().radial());
}

TEST(Packing, AcceptsThreeHalvesRootWrittenByTheCaller) {
  EXPECT_NO_THROW((Packing{{.axial = 1.0, .radial = 0.8660254037844386}}));
}

TEST(Packing, RejectsWiresThatOverlap) {
  EXPECT_EQ(error_text([] { Packing{{.axial = 0.97, .radial = 1.2}}; }),
            "packing.axial: must be finite and >= 1 (turns of a layer do not overlap); got 0.97");
  EXPECT_EQ(error_text([] { Packing{{.axial = INFINITY, .radial = 1.2}}; }),
            "packing.axial: must be finite and >= 1 (turns of a layer do not overlap); got inf");
  EXPECT_EQ(error_text([] { Packing{{.axial = 1.2, .radial = 0.79}}; }),
            "packing.radial: must be finite and >= 0.8 (layers do not overlap at axial 1.2); got 0.79");
  EXPECT_EQ(error_text([] { Packing{{.axial = 2.5, .radial = 0.4}}; }),
            "packing.radial: must be finite and >= 0.5 (layers do not overlap at axial 2.5); got 0.4");
}

}  // namespace
}  // namespace coilwright::winding
