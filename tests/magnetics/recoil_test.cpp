#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "coilwright/magnetics/inner_field.hpp"
#include "coilwright/magnetics/pair_curve.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "magnetics/prototype.hpp"

namespace coilwright::magnetics {
namespace {

using testing::ThrowsMessage;

using std::numbers::pi;

const CylinderMagnet recoiling_magnet(
    {.radius = 10e-3, .length = 6e-3, .remanence = 1.44, .recoil_permeability = 1.05});
constexpr double current = 1.4;

// Finite elements with a recoil of 1.05 (studies/force_by_finite_elements): at 0.9 mm the mean of push and pull, which
// the coil's attraction of the material leaves as it is; from 6 mm on that attraction is below 0.01 %.
TEST(Recoil, TakesFromTheForceWhatFiniteElementsSay) {
  const auto force = [](double gap) { return -axial_force(prototype, current, recoiling_magnet, 9e-3 + gap); };
  EXPECT_NEAR(force(0.9e-3), 2.0481, 2.5e-4 * 2.0481);
  EXPECT_NEAR(force(6e-3), 0.84261, 2.5e-4 * 0.84261);
  EXPECT_NEAR(force(12e-3), 0.32689, 2.5e-4 * 0.32689);
}

// Far away only the moment counts, which recoil lowers by the factor of the mean inner field.
TEST(Recoil, TakesTheMeanFarAway) {
  for (const double length : {1.1e-3, 6e-3, 25e-3}) {
    const CylinderMagnet bar({.radius = 7e-3, .length = length, .remanence = 1.3, .recoil_permeability = 1.08});
    const double share = axial_force(prototype, 1.0, bar, 3.0) / axial_force(prototype, 1.0, bar.without_recoil(), 3.0);
    EXPECT_NEAR(share, recoil_factor({.radius = 7e-3, .length = length}, 1.08), 5e-6) << length;
  }
}

// Everything of a uniform sheet or of a disc of charge from loops and rings of points: Boost's elliptic integrals and
// sums, nothing of the library.
struct Field {
  double radial;
  double axial;
};

// B of a loop over mu0, per ampere (Smythe, Static and Dynamic Electricity, sec. 7.10).
Field of_loop(double a, double rho, double z) {
  const double near = (a - rho) * (a - rho) + z * z;
  const double far = std::sqrt((a + rho) * (a + rho) + z * z);
  const double k = std::sqrt(4.0 * a * rho) / far;
  const double first = std::comp_ellint_1(k);
  const double second = std::comp_ellint_2(k);
  return {.radial = z / (2.0 * pi * rho * far) * (-first + (a * a + rho * rho + z * z) / near * second),
          .axial = 1.0 / (2.0 * pi * far) * (first + (a * a - rho * rho - z * z) / near * second)};
}

using Rule = boost::math::quadrature::gauss<double, 20>;

// H of a cylinder of magnetisation 1, inside it: the charge of its two faces, rings of which each has the field of a
// charged ring.
Field own_field(const CylinderMagnet& of, double rho, double z) {
  Field sum{};
  for (const double sign : {1.0, -1.0}) {
    const double height = z - sign * 0.5 * of.length();
    const auto ring = [&](double a) {
      const double near = (a - rho) * (a - rho) + height * height;
      const double far = std::sqrt((a + rho) * (a + rho) + height * height);
      const double k = std::sqrt(4.0 * a * rho) / far;
      const double second = std::comp_ellint_2(k);
      return Field{.radial = a / (2.0 * pi * rho * far) *
                             (std::comp_ellint_1(k) - (a * a - rho * rho + height * height) / near * second),
                   .axial = a * height / (pi * far * near) * second};
    };
    // The integrand peaks at a = rho with the width of the height: graded towards it from both sides.
    const auto half = [&](double from, double to, double Field::*part) {
      return (to - from) *
             Rule::integrate([&](double t) { return 3.0 * t * t * (ring(from + (to - from) * t * t * t).*part); }, 0.0,
                             1.0);
    };
    for (double Field::*part : {&Field::radial, &Field::axial})
      sum.*part += sign * (half(rho, of.radius(), part) - half(rho, 0.0, part));
  }
  return sum;
}

// Energy of the magnetisation that recoil adds in the coil's field, -mu0 M1 . H, J per ampere and chi.
double energy_at(const Pose& pose) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), pose.axis);
  const double magnetisation = recoiling_magnet.remanence() / vacuum_permeability;
  const auto coil_field = [](const Eigen::Vector3d& at) {
    const double rho = std::hypot(at.x(), at.y());
    Field sum{};
    using Layers = boost::math::quadrature::gauss<double, 10>;
    for (double Field::*part : {&Field::radial, &Field::axial})
      sum.*part =
          0.25 *
          Layers::integrate(
              [&](double u) {
                const double a = 6.25e-3 + 3.25e-3 * u;
                return Layers::integrate([&](double v) { return of_loop(a, rho, at.z() - 6e-3 * v).*part; }, -1.0, 1.0);
              },
              -1.0, 1.0) *
          450.0;
    return Eigen::Vector3d(sum.radial * at.x() / rho, sum.radial * at.y() / rho, sum.axial);
  };
  using Points = boost::math::quadrature::gauss<double, 15>;
  constexpr int round = 12;
  return Points::integrate(
      [&](double u) {
        const double rho = 0.5 * recoiling_magnet.radius() * (1.0 + u);
        return Points::integrate(
            [&](double v) {
              const double z = 0.5 * recoiling_magnet.length() * v;
              const Field own = own_field(recoiling_magnet, rho, z);
              double mean = 0.0;
              for (int i = 0; i < round; ++i) {
                const double phi = 2.0 * pi * (i + 0.5) / round;
                const Eigen::Vector3d out(std::cos(phi), std::sin(phi), 0.0);
                const Eigen::Vector3d extra = own.radial * out + own.axial * Eigen::Vector3d::UnitZ();
                const Eigen::Vector3d place = pose.position + turn * (rho * out + z * Eigen::Vector3d::UnitZ());
                mean += (turn * extra).dot(coil_field(place)) / round;
              }
              return -2.0 * pi * rho * 0.5 * recoiling_magnet.radius() * 0.5 * recoiling_magnet.length() *
                     magnetisation * vacuum_permeability * mean;
            },
            -1.0, 1.0);
      },
      -1.0, 1.0);
}

// A tilted and displaced pose: force and torque of what recoil adds are slopes of an energy over the magnet's volume,
// while the library takes the Lorentz force on currents on its surface. 0.1 % of what is 4 % of the wrench.
TEST(Recoil, TakesFromTheWrenchWhatAVolumeIntegralSays) {
  const Pose pose{.position = {3e-3, 0.0, 12.5e-3}, .axis = {std::sin(0.35), 0.0, std::cos(0.35)}};
  const Wrench with = wrench(prototype, 1.0, recoiling_magnet, pose);
  const Wrench without = wrench(prototype, 1.0, recoiling_magnet.without_recoil(), pose);
  const double change = 0.05 / (1.0 + 0.05 * demagnetisation_factor({.radius = 10e-3, .length = 6e-3}));
  constexpr double step = 1e-4;
  const auto slope = [&](const auto& moved) {
    return -change * (energy_at(moved(step)) - energy_at(moved(-step))) / (2.0 * step);
  };
  const double force_x =
      slope([&](double s) { return Pose{.position = pose.position + Eigen::Vector3d(s, 0, 0), .axis = pose.axis}; });
  const double force_z =
      slope([&](double s) { return Pose{.position = pose.position + Eigen::Vector3d(0, 0, s), .axis = pose.axis}; });
  const double size = with.force.norm() - without.force.norm();
  EXPECT_NEAR(with.force.x() - without.force.x(), force_x, 1e-3 * std::abs(size));
  EXPECT_NEAR(with.force.z() - without.force.z(), force_z, 1e-3 * std::abs(size));
  constexpr double turn = 0.01;
  const auto turned = [&](double angle) {
    return Pose{.position = pose.position, .axis = {std::sin(0.35 + angle), 0.0, std::cos(0.35 + angle)}};
  };
  const double torque = -change * (energy_at(turned(turn)) - energy_at(turned(-turn))) / (2.0 * turn);
  EXPECT_NEAR(with.torque.y() - without.torque.y(), torque, 1e-3 * std::abs(size) * 10e-3);
  // On the axis the wrench is the axial force; off it a hair away nearly so.
  const Wrench beside =
      wrench(prototype, 1.0, recoiling_magnet, {.position = {1e-7, 0.0, 9.9e-3}, .axis = {0.0, 0.0, 1.0}});
  const double axial = axial_force(prototype, 1.0, recoiling_magnet, 9.9e-3);
  EXPECT_NEAR(beside.force.z(), axial, 1e-6 * std::abs(axial));
}

// Within the tolerance asked for of the torque and force themselves.
TEST(Recoil, IsInTheCurvesAsInTheForces) {
  const HingeGeometry hinge{.coil_offset = 6.3e-3, .magnet_offset = 3.6e-3, .axis_offset = 11.5e-3};
  const Curve force = force_curve(prototype, recoiling_magnet, {.lower = 9.3e-3, .upper = 80e-3, .tolerance = 1e-6});
  for (const double distance : {9.3e-3, 9.7e-3, 12e-3, 33e-3, 79e-3}) {
    const double direct = axial_force(prototype, 1.0, recoiling_magnet, distance);
    EXPECT_NEAR(force.value(distance), direct, 1e-6 * force.scale()) << distance;
  }
  for (const Fidelity fidelity : {Fidelity::line_of_centres, Fidelity::exact}) {
    const Curve torque =
        torque_curve(prototype, recoiling_magnet, hinge, fidelity, {.lower = -0.02, .upper = 2.0, .tolerance = 1e-6});
    for (const double angle : {-0.02, 0.0, 0.1, 0.7, 1.9})
      EXPECT_NEAR(torque.value(angle), hinge_torque_per_ampere(prototype, recoiling_magnet, hinge, fidelity, angle),
                  1e-6 * torque.scale())
          << angle;
  }
}

// Thin and long magnets of smaller and larger radius than the coil, close and apart.
TEST(Recoil, IsInExactTorqueCurvesWithinATenthOfTheirTolerance) {
  for (const double gap : {0.3e-3, 1.5e-3})
    for (const double radius : {8e-3, 12e-3})
      for (const double length : {2e-3, 12e-3}) {
        const CylinderMagnet magnet(
            {.radius = radius, .length = length, .remanence = 1.44, .recoil_permeability = 1.1});
        const HingeGeometry hinge{
            .coil_offset = 6e-3 + gap, .magnet_offset = 0.5 * length + gap, .axis_offset = radius + 2.5e-3};
        const Curve torque =
            torque_curve(prototype, magnet, hinge, Fidelity::exact, {.lower = 0.0, .upper = 2.0, .tolerance = 1e-6});
        for (int i = 0; i <= 40; ++i)
          EXPECT_NEAR(torque.value(0.05 * i),
                      hinge_torque_per_ampere(prototype, magnet, hinge, Fidelity::exact, 0.05 * i),
                      1e-7 * torque.scale())
              << gap << ' ' << radius << ' ' << length << ' ' << 0.05 * i;
      }
}

// A magnet that goes into the bore of a coil, and a curve that a solver follows into the copper.
TEST(Recoil, IsInCurvesBeyondLevelFaces) {
  const CylinderMagnet rod({.radius = 2e-3, .length = 8e-3, .remanence = 1.3, .recoil_permeability = 1.05});
  const Curve force = force_curve(prototype, rod, {.lower = 1e-3, .upper = 60e-3, .tolerance = 1e-6});
  for (const double distance : {1e-3, 4e-3, 9.5e-3, 10.2e-3, 15e-3, 50e-3}) {
    const double direct = axial_force(prototype, 1.0, rod, distance);
    EXPECT_NEAR(force.value(distance), direct, 1e-6 * force.scale()) << distance;
  }
  const HingeGeometry hinge{.coil_offset = 6.3e-3, .magnet_offset = 3.6e-3, .axis_offset = 11.5e-3};
  const Curve torque = torque_curve(prototype, recoiling_magnet, hinge, Fidelity::line_of_centres,
                                    {.lower = -0.5, .upper = 2.0, .tolerance = 1e-6});
  for (const double angle : {0.0, 0.4, 1.9})
    EXPECT_NEAR(torque.value(angle),
                hinge_torque_per_ampere(prototype, recoiling_magnet, hinge, Fidelity::line_of_centres, angle),
                5e-6 * torque.scale())
        << angle;
  const double inside = hinge_torque_per_ampere(prototype, recoiling_magnet, hinge, Fidelity::line_of_centres, -0.3);
  EXPECT_NEAR(torque.value(-0.3), inside, 3e-3 * torque.scale());
}

TEST(Recoil, RefusesMaterialsThatAreNotNearlyRigid) {
  const auto of = [](double recoil) {
    return CylinderMagnet({.radius = 1.0, .length = 1.0, .remanence = 1.0, .recoil_permeability = recoil});
  };
  EXPECT_THAT([&] { (void)of(3.0); },
              ThrowsMessage<std::invalid_argument>("magnet recoil_permeability must be 1 to 1.2; got 3"));
  EXPECT_THAT([&] { (void)of(0.99); },
              ThrowsMessage<std::invalid_argument>("magnet recoil_permeability must be 1 to 1.2; got 0.99"));
}

}  // namespace
}  // namespace coilwright::magnetics
