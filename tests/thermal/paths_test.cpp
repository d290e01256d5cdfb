#include "coilwright/thermal/paths.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "error_text.hpp"

namespace coilwright::thermal {
namespace {

TEST(Wedge, WedgeConductsLikeTheSumOfItsArcs) {
  const Wedge wedge{.angle = 0.55, .hinge_distance = 11.5e-3, .core_radius = 9.5e-3};
  // Strips across the disc at height y: width 2 sqrt(R^2 - y^2), arc length (h + y) angle. With y = R sin(t) the rule
  // is periodic, so the midpoint sum converges geometrically.
  const int strips = 400;
  double conductance = 0.0;  // over conductivity, m
  for (int i = 0; i < strips; ++i) {
    const double t = std::numbers::pi * ((i + 0.5) / strips - 0.5);
    const double strip = 2.0 * std::pow(9.5e-3 * std::cos(t), 2) * std::numbers::pi / strips;
    conductance += strip / ((11.5e-3 + 9.5e-3 * std::sin(t)) * 0.55);
  }
  const double area = std::numbers::pi * 9.5e-3 * 9.5e-3;
  EXPECT_NEAR(equivalent_air_gap(wedge) / (area / conductance), 1.0, 1e-12);  // rounding of 400 terms
  EXPECT_EQ(equivalent_air_gap({.angle = 0.0, .hinge_distance = 11.5e-3, .core_radius = 9.5e-3}), 0.0);
}

TEST(Wedge, RejectsWedgesOutsideTheirRules) {
  const auto text = [](const Wedge& wedge) { return error_text([&] { (void)equivalent_air_gap(wedge); }); };
  EXPECT_EQ(text({.angle = -0.1, .hinge_distance = 0.012, .core_radius = 0.009}),
            "angle: must be finite and >= 0; got -0.1");
  EXPECT_EQ(text({.angle = 0.1, .hinge_distance = 0.012, .core_radius = 0.0}),
            "core_radius: must be finite and > 0; got 0");
  EXPECT_EQ(text({.angle = 0.1, .hinge_distance = 0.008, .core_radius = 0.009}),
            "hinge_distance: must be finite and above core_radius; got 0.008");
}

// Shells of even heat from the outside in: each passes on what is made within it.
TEST(RingConduction, AgreesWithASumOverShells) {
  const Ring ring{.inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 12e-3, .conductivity = 0.55};
  const int shells = 2000;
  const double step = (ring.outer_radius - ring.inner_radius) / shells;
  const double section = std::numbers::pi * (std::pow(ring.outer_radius, 2) - std::pow(ring.inner_radius, 2));
  double rise = 0.0;
  double mean = 0.0;
  for (int i = shells - 1; i >= 0; --i) {
    const double radius = ring.inner_radius + (i + 0.5) * step;
    const double within = std::numbers::pi * (radius * radius - std::pow(ring.inner_radius, 2)) / section;  // of 1 W
    rise += within * step / (2.0 * std::numbers::pi * radius * ring.length * ring.conductivity);
    mean += within * step / (2.0 * std::numbers::pi * radius * ring.length * ring.conductivity) * within;
  }
  const RingConduction found = ring_conduction(ring);
  EXPECT_NEAR(1.0 / found.to_side / mean, 1.0, 1e-6);  // 1 / shells^2
  EXPECT_NEAR((1.0 / found.to_side + found.hot_spot_by_side) / rise, 1.0, 1e-6);
  // Between ends a parabola: its top is q L^2 / 8 k above them, its mean q L^2 / 12 k; 1 W leaves at both.
  const double along = ring.length / (ring.conductivity * section);
  EXPECT_NEAR(0.5 / found.to_end, along / 12.0, 1e-12 * along);
  EXPECT_NEAR(0.5 / found.to_end + found.hot_spot_by_ends, along / 8.0, 1e-12 * along);
}

TEST(AcrossWires, IsTheFillerWithoutCopperAndGrowsWithIt) {
  EXPECT_EQ(across_wires(0.0, 0.2), 0.2);
  EXPECT_NEAR(across_wires(0.47, 0.2), 0.5547, 5e-5);
  EXPECT_EQ(error_text([] { (void)across_wires(1.0, 0.2); }), "copper_share: must be >= 0 and below 1; got 1");
}

// Admittance of the bar at a real frequency s, 1/s, by slices from its end face inwards.
double admittance(const SolidEnd& bar, double s, int slices) {
  const double step = bar.length / slices;
  const double along = bar.conductivity * bar.section / step;
  double beyond = 1.0 / (1.0 / (bar.heat_transfer * bar.section) + 0.5 / along);
  for (int i = 0; i < slices; ++i) {
    const double here = beyond + (bar.heat_transfer * bar.perimeter + s * bar.heat_capacity * bar.section) * step;
    beyond = 1.0 / (1.0 / here + (i + 1 < slices ? 1.0 : 0.5) / along);
  }
  return beyond;
}

TEST(SolidEndNode, DrawsWhatTheBarDrawsSteadilyAndInSlowChanges) {
  for (const double length : {2e-3, 8.6e-3, 20e-3}) {
    const SolidEnd bar{.length = length,
                       .section = 528e-6,
                       .perimeter = 92e-3,
                       .conductivity = 0.2,
                       .heat_capacity = 1.469e6,
                       .heat_transfer = 40.0};
    const SolidEndNode node = solid_end_node(bar);
    const auto of_node = [&](double s) {
      const double sum = node.to_root + node.to_ambient + node.heat_capacity * s;
      return node.to_root * (sum - node.to_root) / sum;
    };
    // Slices converge as 1 / n^2: 800 of them are within 1e-6.
    EXPECT_NEAR(of_node(0.0) / admittance(bar, 0.0, 800), 1.0, 3e-6);
    // The third order of s is left out: with h P / c A = 4.7e-3 1/s of the bar, s a tenth of it.
    EXPECT_NEAR(of_node(5e-4) / admittance(bar, 5e-4, 800), 1.0, 1e-4);
  }
}

// View factor between the two faces by area elements, each face cut into n by n.
double view_to_other_face(double angle, double height, int n) {
  const double step = 1.0 / n;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const double a = (i + 0.5) * step * height, b = (k + 0.5) * step * height;
      const double square = a * a + b * b - 2.0 * a * b * std::cos(angle);
      const double cosines = a * b * std::sin(angle) * std::sin(angle);
      // Strips along the width, exactly: integral of (1 - |u|) 2 / (square + u^2)^2 du over u from 0 to 1.
      const double root = std::sqrt(square);
      const double along = (1.0 / (2.0 * square)) * (1.0 / (square + 1.0) + std::atan(1.0 / root) / root) -
                           0.5 * (1.0 / square - 1.0 / (square + 1.0));
      sum += cosines * 2.0 * along / std::numbers::pi;
    }
  }
  return sum * step * step * height;
}

TEST(OpenFaceShare, IsTheViewFactorOutOfTheWedge) {
  for (const double height : {0.5, 1.0, 2.0})
    for (const double degrees : {20.0, 30.0, 45.0, 60.0, 90.0, 120.0}) {
      const double angle = degrees * std::numbers::pi / 180.0;
      EXPECT_NEAR(open_face_share(angle, height), 1.0 - view_to_other_face(angle, height, 400), 0.025)
          << degrees << " deg, height over width " << height;
    }
  EXPECT_EQ(open_face_share(0.0, 1.0), 0.0);
  EXPECT_NEAR(open_face_share(std::numbers::pi, 1.0), 1.0, 1e-15);
  EXPECT_EQ(error_text([] { (void)open_face_share(-0.1, 1.0); }), "angle: must be from 0 to pi rad; got -0.1");
}

}  // namespace
}  // namespace coilwright::thermal
