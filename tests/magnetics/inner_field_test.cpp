#include "coilwright/magnetics/inner_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "magnetics/filament_reference.hpp"

namespace coilwright::magnetics {
namespace {

using testing::ThrowsMessage;

using std::numbers::pi;

const ThickCoil layered_coil({.inner_radius = 3.1e-3,
                              .outer_radius = 9.3e-3,
                              .length = 11.7e-3,
                              .turns_radial = 14,
                              .turns_axial = 29,
                              .winding = CurrentDistribution::uniform});

// 1 - Nagaoka's table of 1909 (its own digits), at diameter over length 4, 2, 1 and 0.5. Chen, Brug and Goldfarb (IEEE
// Trans. Magn. 27, 3601, 1991) give 0.4745 and 0.3116 for length over diameter 0.5 and 1 at zero susceptibility.
TEST(DemagnetisationFactor, IsOneLessNagaokasCoefficient) {
  const auto factor = [](double diameter_over_length) {
    return demagnetisation_factor({.radius = 0.5 * diameter_over_length * 7e-3, .length = 7e-3});
  };
  EXPECT_NEAR(factor(4.0), 1.0 - 0.365438, 1e-5);
  EXPECT_NEAR(factor(2.0), 0.4745, 5e-5);
  EXPECT_NEAR(factor(1.0), 0.3116, 5e-5);
  EXPECT_NEAR(factor(0.5), 1.0 - 0.818136, 1e-6);
}

// A thin disc: 1 - L / (pi R) (ln(8 R / L) - 1/2), the next term being of the order (L / R)^3; a long rod: 4 R / (3 pi)
// 2 / L, the charges of one end alone.
TEST(DemagnetisationFactor, KeepsTheLimitsOfADiscAndOfARod) {
  const double thin = 1e-3;
  EXPECT_NEAR(demagnetisation_factor({.radius = 1.0, .length = thin}), 1.0 - thin / pi * (std::log(8.0 / thin) - 0.5),
              1e-8);
  EXPECT_NEAR(demagnetisation_factor({.radius = 1.0, .length = 1e3}) * 1e3, 8.0 / (3.0 * pi), 1e-3);
}

// The prototype's disc, by the audit of the physics: N = 0.595 and 2.125 to 2.063 N, a factor of 0.971.
TEST(RecoilFactor, LowersThePolarisationOfAFlatMagnet) {
  const CylinderSize disc{.radius = 10e-3, .length = 6e-3};
  EXPECT_NEAR(demagnetisation_factor(disc), 0.595, 5e-4);
  EXPECT_NEAR(recoil_factor(disc, 1.05), 2.063 / 2.125, 3e-4);
  EXPECT_EQ(recoil_factor(disc, 1.0), 1.0);
}

// H at the centre of a face, from the charge of both: M / 2 (2 - L / sqrt(L^2 + R^2)); at the rim the near face has
// half the effect. Between face centre and rim it falls.
TEST(FaceDemagnetisationFactors, AreWorstAtTheCentreOfAFace) {
  const CylinderSize size{.radius = 8e-3, .length = 5e-3};
  const FaceValues factors = face_demagnetisation_factors(size);
  EXPECT_NEAR(factors[0], 1.0 - 0.5 * size.length / std::hypot(size.length, size.radius), 1e-9);
  for (std::size_t i = 1; i < face_points / 2; ++i) EXPECT_LT(factors[i], factors[i - 1]);
  for (std::size_t i = 0; i < face_points / 2; ++i) EXPECT_NEAR(factors[i], factors[i + face_points / 2], 1e-9);
}

// The energy of a rigid magnet is -J V times the mean field, so the force is its slope: the room's own force, which
// shares no quadrature along the magnet with the mean.
TEST(AxialField, HasTheForceAsItsSlope) {
  const CylinderSize size{.radius = 8.7e-3, .length = 5.3e-3};
  const CylinderMagnet magnet({.radius = size.radius, .length = size.length, .remanence = 1.31});
  const double moment = 1.31 * pi * size.radius * size.radius * size.length;
  for (const double distance : {9.5e-3, 14e-3, 40e-3}) {
    constexpr double step = 2e-5;  // central differences: (step / distance)^2, 4e-6 at the nearest
    const double slope = (axial_field(layered_coil, 1.7, size, distance + step).mean -
                          axial_field(layered_coil, 1.7, size, distance - step).mean) /
                         (2.0 * step);
    EXPECT_NEAR(moment * slope / axial_force(layered_coil, 1.7, magnet, distance), 1.0, 2e-5) << distance;
  }
}

// Two magnets: reciprocity by the double integral of loops' mutual inductance in long double, which shares nothing.
TEST(AxialField, IsTheMeanOfTheFluxThroughTheCylinder) {
  const CylinderMagnet source({.radius = 6.5e-3, .length = 4.1e-3, .remanence = 1.2});
  const CylinderSize size{.radius = 9.2e-3, .length = 3.3e-3};
  constexpr double distance = 5.9e-3;
  using Rule = boost::math::quadrature::gauss_kronrod<long double, 31>;
  const auto flux = [&](long double z) {
    const auto loop = [&](long double s) {
      return filament_reference::inductance(source.radius(), size.radius, z - s);
    };
    return Rule::integrate(loop, -0.5L * source.length(), 0.5L * source.length(), 4, 1e-12L);
  };
  const long double mean =
      Rule::integrate(flux, distance - 0.5L * size.length, distance + 0.5L * size.length, 4, 1e-11L) / size.length /
      (pi * size.radius * size.radius);
  const double expected = 1.2 / vacuum_permeability * static_cast<double>(mean);
  EXPECT_NEAR(axial_field(source, size, distance).mean / expected, 1.0, 1e-7);
  EXPECT_NEAR(axial_field(source, size, -distance).mean / expected, 1.0, 1e-7);
}

// Far away the field of a dipole on its axis: 2 m / (4 pi z^3), the next term (size / distance)^2.
TEST(AxialField, BecomesThatOfADipole) {
  const CylinderMagnet source({.radius = 2e-3, .length = 1.5e-3, .remanence = 1.2});
  const double moment = 1.2 / vacuum_permeability * pi * 4e-6 * 1.5e-3;
  const double dipole = moment / (2.0 * pi * 0.3 * 0.3 * 0.3);
  const AxialField field = axial_field(source, {.radius = 1e-3, .length = 1e-3}, 0.3);
  EXPECT_NEAR(field.mean / dipole, 1.0, 2e-4);
  EXPECT_NEAR(field.faces[0] / dipole, 1.0, 6e-3);  // a face is 0.5 mm nearer: (1 + 0.5 / 300)^3
}

// On the axis of a solenoid of one shell, K / 2 (cos - cos) at the two faces.
TEST(AxialField, IsTheTextbookFieldOnTheAxis) {
  const CylinderMagnet source({.radius = 5e-3, .length = 4e-3, .remanence = 1.0});
  const CylinderSize size{.radius = 4e-3, .length = 2e-3};
  const auto on_axis = [](double z) {
    return 0.5 / vacuum_permeability *
           ((z + 2e-3) / std::hypot(z + 2e-3, 5e-3) - (z - 2e-3) / std::hypot(z - 2e-3, 5e-3));
  };
  const AxialField field = axial_field(source, size, 4e-3);
  EXPECT_NEAR(field.faces[0] / on_axis(3e-3), 1.0, 1e-7);
  EXPECT_NEAR(field.faces[face_points / 2] / on_axis(5e-3), 1.0, 1e-7);
}

TEST(AxialField, SaysWhichNumberBreaksWhichRule) {
  using Error = std::invalid_argument;
  EXPECT_THAT([] { (void)demagnetisation_factor({.radius = 0.0, .length = 1.0}); },
              ThrowsMessage<Error>("cylinder radius must be finite and > 0; got 0"));
  EXPECT_THAT([] { (void)demagnetisation_factor({.radius = 1.0, .length = -2.0}); },
              ThrowsMessage<Error>("cylinder length must be finite and > 0; got -2"));
  EXPECT_THAT([] { (void)recoil_factor({.radius = 1.0, .length = 1.0}, 0.9); },
              ThrowsMessage<Error>("recoil permeability must be finite and >= 1; got 0.9"));
}

}  // namespace
}  // namespace coilwright::magnetics
