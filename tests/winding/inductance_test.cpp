#include "coilwright/winding/inductance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "coilwright/magnetics/axial_force.hpp"
#include "error_text.hpp"
#include "winding/read_table.hpp"

namespace coilwright::winding {
namespace {

using std::numbers::pi;
constexpr double mu0 = 4e-7 * pi;  // exact before 2019, 5e-10 from today's value

// Maxwell: mutual inductance of two coaxial loops.
double loop_pair(double a, double b, double distance) {
  const double k = std::sqrt(4.0 * a * b / ((a + b) * (a + b) + distance * distance));
  return mu0 * std::sqrt(a * b) * ((2.0 / k - k) * std::comp_ellint_1(k) - 2.0 / k * std::comp_ellint_2(k));
}

// Geometric mean distance of a rectangle b by c from itself, exact (Maxwell; Grover's "Inductance Calculations").
double mean_distance(double b, double c) {
  const double x = b / c, s = x * x;
  const double exponent = -(std::log1p(1.0 / s) * s + std::log1p(s) / s) / 12.0 +
                          2.0 / 3.0 * (x * std::atan(1.0 / x) + std::atan(x) / x) - 25.0 / 12.0;
  return std::hypot(b, c) * std::exp(exponent);
}

// Maxwell's ring of small rectangular section, in which the loop sees itself at the mean distance.
double ring(double radius, double b, double c) {
  return mu0 * radius * (std::log(8.0 * radius / mean_distance(b, c)) - 2.0);
}

// The section cut into cells: loops at the cells' centres, rings for the cells themselves. Error falls as 1/cells^2.
double by_cells(const CoilSection& section, int radial, int axial) {
  const double width = (section.outer_radius - section.inner_radius) / radial;
  const double height = section.length / axial;
  const auto radius = [&](int i) { return section.inner_radius + (i + 0.5) * width; };
  double sum = 0.0;
  for (int i = 0; i < radial; ++i) {
    for (int j = 0; j < radial; ++j) {
      // Cells in the same pair of layers depend on their axial distance only.
      for (int k = 0; k < axial; ++k) {
        const double pairs = k == 0 ? axial : 2.0 * (axial - k);
        const bool same = i == j && k == 0;
        sum += pairs * (same ? ring(radius(i), height, width) : loop_pair(radius(i), radius(j), k * height));
      }
    }
  }
  const double share = static_cast<double>(section.turns) / (radial * axial);
  return sum * share * share;
}

// Nagaoka's coefficient of a coil thinned to a cylinder.
double coefficient(double diameter_over_length) {
  const double radius = 7e-3, length = 2.0 * radius / diameter_over_length, turns = 83.0;
  const double thin = 1e-7 * radius;  // half thickness: the sheet's value to 1e-7 (1 + 1 / length in radii)
  const double L =
      inductance({.inner_radius = radius - thin, .outer_radius = radius + thin, .length = length, .turns = 83});
  return L * length / (mu0 * turns * turns * pi * radius * radius);
}

TEST(Inductance, ApproachesLorenzCurrentSheet) {
  for (const double u : {0.08, 0.7, 3.9, 17.0}) {
    // Lorenz 1879 in Nagaoka's form; u = diameter / length.
    const double k = u / std::hypot(1.0, u);
    const double K = std::comp_ellint_1(k), E = std::comp_ellint_2(k);
    const double lorenz = 4.0 / (3.0 * pi * u) * ((K + (u * u - 1.0) * E) / k - u * u);
    EXPECT_NEAR(coefficient(u) / lorenz, 1.0, 1e-6) << u;  // the thickness left, and n1 > 1e-15 in the code
  }
}

TEST(Inductance, ApproachesNagaokasTable) {
  for (const auto& row : read_table("winding_nagaoka.csv")) {
    // Six digits are printed. For coils shorter than a quarter of their diameter Nagaoka's own computation by hand is
    // up to 9e-6 from Lorenz's exact formula, as evaluated in double precision apart from this code.
    EXPECT_NEAR(coefficient(row[0]), row[1], row[0] < 4.0 ? 1.5e-6 : 9e-6) << "diameter / length " << row[0];
  }
}

TEST(Inductance, OfABrooksCoilIsThePublishedOne) {
  // Grover: L = 0.025491 N^2 c microhenry, c in cm; square section c by c, inner radius c.
  const double c = 13e-3;
  const double L = inductance({.inner_radius = c, .outer_radius = 2.0 * c, .length = c, .turns = 310});
  EXPECT_NEAR(L / (0.025491e-6 * 310.0 * 310.0 * c * 100.0), 1.0, 2e-5);  // half of the last digit
}

TEST(Inductance, ApproachesMaxwellsRingAsTheSectionShrinks) {
  // Curvature corrections are of second order in section over radius: a fifth of the size, 1/25 of the difference
  // (less logarithms).
  const double radius = 11e-3;
  const auto difference = [&](double scale) {
    const double b = 0.2 * radius * scale, c = 0.13 * radius * scale;
    const double thick =
        inductance({.inner_radius = radius - 0.5 * c, .outer_radius = radius + 0.5 * c, .length = b, .turns = 1});
    return std::abs(thick / ring(radius, b, c) - 1.0);
  };
  EXPECT_LT(difference(1.0), 0.2 * 0.2);
  EXPECT_LT(difference(0.2), difference(1.0) / 15.0);
  EXPECT_LT(difference(0.04), 1e-5);  // (0.2 * 0.04)^2 / 16 * ln = 2e-5, and the quadrature's own error
}

TEST(Inductance, AgreesWithTheSumOverCells) {
  struct Case {
    CoilSection section;
    int radial, axial;
    double tolerance;  // quadrature's error as documented, plus that of the extrapolated cells
  };
  const Case cases[] = {
      {{.inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 12e-3, .turns = 450}, 20, 36, 1e-5},
      {{.inner_radius = 1.2e-3, .outer_radius = 4.1e-3, .length = 2.3e-3, .turns = 37}, 24, 20, 2e-5},
      {{.inner_radius = 0.7e-3, .outer_radius = 10.3e-3, .length = 40e-3, .turns = 911}, 20, 80, 3e-5},
      {{.inner_radius = 2.1e-3, .outer_radius = 12.7e-3, .length = 1.1e-3, .turns = 64}, 60, 6, 2e-4},
  };
  for (const Case& c : cases) {
    const double coarse = by_cells(c.section, c.radial, c.axial);
    const double fine = by_cells(c.section, 2 * c.radial, 2 * c.axial);
    const double extrapolated = fine + (fine - coarse) / 3.0;
    EXPECT_NEAR(inductance(c.section) / extrapolated, 1.0, c.tolerance) << "length " << c.section.length;
  }
}

TEST(Inductance, GrowsByTheInfiniteSolenoidsShareWithLength) {
  // Both ends of a long coil cost the same whatever its length, so at fixed turns per length the difference of two long
  // coils is the field energy of the part between: pi n^2 mu0 l (r^2 + 2 R w / 3 - w^2 / 2).
  const double r = 2e-3, R = 5e-3, w = R - r, l = 1.0;
  const double longer = inductance({.inner_radius = r, .outer_radius = R, .length = 2.0 * l, .turns = 6000});
  const double shorter = inductance({.inner_radius = r, .outer_radius = R, .length = l, .turns = 3000});
  const double between = mu0 * pi * 9e6 * (r * r + 2.0 * R * w / 3.0 - 0.5 * w * w) / l;
  // The ends see each other with (R / l)^2 / 4 = 6e-6 of it.
  EXPECT_NEAR((longer - shorter) / between, 1.0, 1e-5);
}

TEST(Inductance, ScalesWithSizeAndWithTurnsSquared) {
  const CoilSection section{.inner_radius = 2.7e-3, .outer_radius = 8.8e-3, .length = 6.1e-3, .turns = 120};
  CoilSection larger = section;
  larger.inner_radius *= 3.3;
  larger.outer_radius *= 3.3;
  larger.length *= 3.3;
  larger.turns *= 7;
  EXPECT_NEAR(inductance(larger) / inductance(section), 3.3 * 49.0, 1e-11 * 161.7);  // roundings
}

TEST(Inductance, RejectsSectionsThatAreNone) {
  const auto text = [](auto change) {
    CoilSection section{.inner_radius = 3e-3, .outer_radius = 8e-3, .length = 5e-3, .turns = 40};
    change(section);
    return error_text([&] { (void)inductance(section); });
  };
  EXPECT_EQ(text([](auto& s) { s.inner_radius = -1e-3; }), "inner_radius: must be finite and >= 0; got -0.001");
  EXPECT_EQ(text([](auto& s) { s.outer_radius = 3e-3; }),
            "outer_radius: must be finite and above inner_radius; got 0.003");
  EXPECT_EQ(text([](auto& s) { s.length = 1e-8; }),
            "length: must be between 1e-4 and 1e4 outer radii (outside, differences lose the digits); got 1e-08");
  EXPECT_EQ(text([](auto& s) { s.length = std::nan(""); }),
            "length: must be between 1e-4 and 1e4 outer radii (outside, differences lose the digits); got nan");
  EXPECT_EQ(text([](auto& s) { s.turns = 0; }), "turns: must be >= 1; got 0");
}

// Both sections cut into cells, a loop at the centre of each. Error falls as 1/cells^2.
double mutual_by_cells(const CoilSection& first, const CoilSection& second, double distance, int cells) {
  double sum = 0.0;
  const auto radius = [&](const CoilSection& coil, int i) {
    return coil.inner_radius + (i + 0.5) / cells * (coil.outer_radius - coil.inner_radius);
  };
  const auto place = [&](const CoilSection& coil, int i) { return ((i + 0.5) / cells - 0.5) * coil.length; };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < cells; ++k)
        for (int l = 0; l < cells; ++l)
          sum += loop_pair(radius(first, i), radius(second, j), distance + place(second, l) - place(first, k));
  return sum * first.turns * second.turns / std::pow(cells, 4);
}

const CoilSection left{.inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 12e-3, .turns = 450};
const CoilSection right{.inner_radius = 2.2e-3, .outer_radius = 7.1e-3, .length = 8.5e-3, .turns = 130};

TEST(MutualInductance, AgreesWithTheSumOverCells) {
  for (const double distance : {10.9e-3, 17e-3, 51e-3}) {
    const double coarse = mutual_by_cells(left, right, distance, 8);
    const double fine = mutual_by_cells(left, right, distance, 16);
    // What is left of the cells after the extrapolation: their next order, (1/16)^4.
    EXPECT_NEAR(mutual_inductance(left, right, distance) / (fine + (fine - coarse) / 3.0), 1.0, 3e-5) << distance;
  }
}

TEST(MutualInductance, FallsOffByTheForceBetweenTheCoils) {
  // F = I1 I2 dM/dz, with the force of another room that knows nothing of inductance.
  const auto coil = [](const CoilSection& section, int radial, int axial) {
    return magnetics::ThickCoil({.inner_radius = section.inner_radius,
                                 .outer_radius = section.outer_radius,
                                 .length = section.length,
                                 .turns_radial = radial,
                                 .turns_axial = axial});
  };
  const double z = 15.3e-3, h = 0.1e-3;
  const auto slope = [&](double step) {
    return (mutual_inductance(left, right, z + step) - mutual_inductance(left, right, z - step)) / (2.0 * step);
  };
  const double force = magnetics::axial_force(coil(left, 15, 30), 1.7, coil(right, 10, 13), 0.6, z);
  // Central differences of two steps: the error left is of fourth order in h over the 5 mm between the faces, 2e-7
  // times a factor of the order of one (3e-7 at twice this step).
  EXPECT_NEAR(1.7 * 0.6 * (4.0 * slope(h) - slope(2.0 * h)) / 3.0 / force, 1.0, 1e-7);
}

TEST(MutualInductance, ApproachesTwoDipoles) {
  const auto moment = [](const CoilSection& coil) {
    const double R = coil.outer_radius, r = coil.inner_radius;
    return coil.turns * pi * (R * R + R * r + r * r) / 3.0;
  };
  const double distance = 0.6;
  // (radius / distance)^2 = 3e-4, times a factor of the order of one.
  EXPECT_NEAR(mutual_inductance(left, right, distance) /
                  (mu0 * moment(left) * moment(right) / (2.0 * pi * std::pow(distance, 3))),
              1.0, 1e-3);
}

TEST(MutualInductance, IsTheSameWhenTheCoilsSwap) {
  EXPECT_NEAR(mutual_inductance(left, right, 13e-3) / mutual_inductance(right, left, 13e-3), 1.0, 1e-13);  // roundings
}

TEST(MutualInductance, OfTouchingHalvesMakesUpTheWhole) {
  // A coil cut across is its halves in series: L = 2 L_half + 2 M.
  const CoilSection whole{.inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 24e-3, .turns = 900};
  const double halves = 2.0 * inductance(left) + 2.0 * mutual_inductance(left, left, 12e-3);
  // The documented errors: 2e-5 of 2 M, which is 0.21 of the whole, and 6e-7 each of 2 L_half (0.79) and of the whole.
  EXPECT_NEAR(halves / inductance(whole), 1.0, 2e-5 * 0.21 + 6e-7 * 1.79);
}

TEST(MutualInductance, RejectsCoilsThatOverlap) {
  EXPECT_EQ(error_text([] { (void)mutual_inductance(left, right, 0.0102); }),
            "distance: must be finite and at least half of both lengths (0.01025); got 0.0102");
  CoilSection none = right;
  none.turns = 0;
  EXPECT_EQ(error_text([&] { (void)mutual_inductance(left, none, 0.03); }), "turns: must be >= 1; got 0");
}

}  // namespace
}  // namespace coilwright::winding
