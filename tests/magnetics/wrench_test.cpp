#include "coilwright/magnetics/wrench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "magnetics/prototype.hpp"
#include "random_pairs.hpp"
#include "reference_cases.hpp"

namespace coilwright::magnetics {
namespace {

Eigen::Vector3d vector(const nlohmann::json& v) {
  return Eigen::Vector3d(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
}

// The reference gives 1e-13. Relative to the length of the force, and for the torque to force times magnet radius or
// the torque itself, whichever is larger (a torque may vanish by symmetry).
TEST(Wrench, AgreesWithTheIndependentReferenceInEveryCase) {
  const auto data = reference::load("noncoaxial.json");
  ASSERT_EQ(data["cases"].size(), 13U);
  for (const auto& c : data["cases"]) {
    const CylinderMagnet magnet = reference::magnet(c["magnet"]);
    const Wrench result = wrench(reference::coil(c["coil"], c["coil_model"]), c["coil"]["I"], magnet,
                                 {.position = vector(c["pos"]), .axis = vector(c["axis"])});
    const Eigen::Vector3d force = vector(c["F_on_magnet"]);
    const Eigen::Vector3d torque = vector(c["T_about_magnet_centre"]);
    const double force_error = (result.force - force).norm() / force.norm();
    const double torque_error =
        (result.torque - torque).norm() / std::max(torque.norm(), 0.1 * force.norm() * magnet.radius());
    EXPECT_LT(force_error, 1e-7) << c["id"];
    EXPECT_LT(torque_error, 1e-7) << c["id"];
  }
}

/// What third law and moment balance leave over when the bodies change roles: largest component over the largest
/// component of the wrench, torques in units of force times `size`.
double imbalance(const Pose& pose, const Wrench& on_second, const Wrench& on_first_in_second_frame,
                 const Eigen::Quaterniond& to_second, double size) {
  const Eigen::Vector3d force = to_second.inverse() * on_first_in_second_frame.force;
  const Eigen::Vector3d torque = to_second.inverse() * on_first_in_second_frame.torque;
  const Eigen::Vector3d force_left = force + on_second.force;
  const Eigen::Vector3d torque_left = torque + on_second.torque + pose.position.cross(on_second.force);
  const double scale = std::max(on_second.force.norm(), on_second.torque.norm() / size);
  return std::max(force_left.norm(), torque_left.norm() / (size + pose.position.norm())) / scale;
}

Pose seen_from_second(const Pose& pose, const Eigen::Quaterniond& to_second) {
  return {.position = to_second * -pose.position, .axis = to_second * Eigen::Vector3d::UnitZ()};
}

// The independent coaxial cases through the wrench: on a common axis it promises what the axial force does, also with
// faces level or touching.
TEST(Wrench, KeepsTenDigitsOnACommonAxis) {
  const auto data = reference::load("coaxial.json");
  for (const auto& c : data["cases"]) {
    const std::string kind = c["kind"];
    const Pose pose{.position = {0, 0, c["z"].get<double>()}};
    Wrench result;
    if (kind == "coil_magnet")
      result =
          wrench(reference::coil(c["coil"], c["coil_model"]), c["coil"]["I"], reference::magnet(c["magnet"]), pose);
    else if (kind == "magnet_magnet")
      result = wrench(reference::magnet(c["magnet1"]), reference::magnet(c["magnet2"]), pose);
    else if (kind == "coil_coil")
      result = wrench(reference::coil(c["coil1"], c["coil_model"]), c["coil1"]["I"],
                      reference::coil(c["coil2"], c["coil_model"]), c["coil2"]["I"], pose);
    else
      continue;  // bare sheets are no bodies
    EXPECT_NEAR(result.force.z() / c["Fz_on_2"].get<double>(), 1.0, 1e-10) << c["id"];
    EXPECT_EQ(result.torque.norm(), 0.0) << c["id"];
  }
}

// A tenth of a nanometre off the axis the wrench is found by its quadrature over the second body's sheets, which must
// give the coaxial force's other formulas: 1e-7 promised, of which the offset itself takes 2e-8.
TEST(Wrench, ComesDownToTheAxialForceNextToACommonAxis) {
  const ThickCoil other({.inner_radius = 4.1e-3,
                         .outer_radius = 7.3e-3,
                         .length = 8.7e-3,
                         .turns_radial = 9,
                         .turns_axial = 22,
                         .winding = CurrentDistribution::layer_centres});
  const CylinderMagnet pin({.radius = 2.2e-3, .length = 9e-3, .remanence = 1.3});
  constexpr double aside = 1e-10;
  const auto check = [](const Wrench& result, double expected) {
    EXPECT_NEAR(result.force.z() / expected, 1.0, 1e-7);
    EXPECT_LT(result.force.head<2>().norm(), 1e-7 * std::abs(expected));
    EXPECT_LT(result.torque.norm(), 1e-7 * 10e-3 * std::abs(expected));
  };
  for (const double z : {9.4e-3, 13e-3, 300e-3}) {
    check(wrench(prototype, 1.2, prototype_magnet, {.position = {aside, 0, z}}),
          axial_force(prototype, 1.2, prototype_magnet, z));
    check(wrench(prototype_magnet, pin, {.position = {aside, 0, z}}), axial_force(prototype_magnet, pin, z));
    check(wrench(prototype, 1.2, other, 0.7, {.position = {aside, 0, z + 2e-3}}),
          axial_force(prototype, 1.2, other, 0.7, z + 2e-3));
  }
  // In the bore, wholly and partly.
  for (const double z : {0.8e-3, -4e-3}) {
    check(wrench(prototype, 1.2, pin, {.position = {aside, 0, z}}), axial_force(prototype, 1.2, pin, z));
    check(wrench(prototype, 1.2, pin, {.position = {aside, 0, z}, .axis = {0, 0, -2}}),
          -axial_force(prototype, 1.2, pin, z));
  }
}

// Action and reaction, moments included, with the roles of source and target exchanged: nothing of the quadrature is
// shared. Twice the error promised to each side.
TEST(Wrench, BalancesThatOnTheOtherBodyInRandomPoses) {
  random_pairs::Generator random(3);
  for (int i = 0; i < 150; ++i) {
    ThickCoil coil = random_pairs::coil(random, CurrentDistribution::uniform);
    const CylinderMagnet magnet = random_pairs::magnet(random);
    const double gap = random_pairs::log_uniform(random, 1e-3, 40e-3);
    const Pose pose = random_pairs::pose_at_clearance(random, coil, magnet, gap);
    const Eigen::Quaterniond to_second = Eigen::Quaterniond::FromTwoVectors(pose.axis, Eigen::Vector3d::UnitZ());
    const Pose back = seen_from_second(pose, to_second);
    // A coil of one shell where the magnet was: a sheet that may stand in either place.
    const ThickCoil sheet({.inner_radius = 0.9 * magnet.radius(),
                           .outer_radius = 1.1 * magnet.radius(),
                           .length = magnet.length(),
                           .turns_radial = 1,
                           .turns_axial = 35,
                           .winding = CurrentDistribution::paper_shells});
    const double size = magnet.radius() + 0.5 * magnet.length();
    EXPECT_LT(
        imbalance(pose, wrench(coil, 1.0, sheet, 1.5, pose), wrench(sheet, 1.5, coil, 1.0, back), to_second, size),
        2e-7)
        << i << " gap " << gap;
    const CylinderMagnet first({.radius = coil.outer_radius(), .length = coil.length(), .remanence = 1.1});
    EXPECT_LT(imbalance(pose, wrench(first, magnet, pose), wrench(magnet, first, back), to_second, size), 2e-7)
        << i << " gap " << gap;
  }
}

// Turning the whole scene about the first body's axis turns force and torque with it. To 1e-7: the points round the
// sheet fall elsewhere.
TEST(Wrench, TurnsWithTheScene) {
  const Pose pose{.position = {4e-3, 1e-3, 14e-3}, .axis = {0.3, -0.1, 0.9}};
  const Wrench before = wrench(prototype, 1.0, prototype_magnet, pose);
  for (const double angle : {0.4, 2.0, -1.1}) {
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
    const Wrench after =
        wrench(prototype, 1.0, prototype_magnet, {.position = turn * pose.position, .axis = turn * pose.axis});
    EXPECT_LT((after.force - turn * before.force).norm(), 1e-7 * before.force.norm());
    EXPECT_LT((after.torque - turn * before.torque).norm(), 1e-7 * 10e-3 * before.force.norm());
  }
}

// Two dipoles: F = 3 mu0 / (4 pi d^4) [(m1.u) m2 + (m2.u) m1 + (m1.m2) u - 5 (m1.u)(m2.u) u], T = m2 x B. Finite sizes
// add about (10 mm / 1.2 m)^2 = 7e-5 times a few.
TEST(Wrench, BecomesThatOfTwoDipolesFarAway) {
  const CylinderMagnet first({.radius = 10e-3, .length = 6e-3, .remanence = 1.44});
  const CylinderMagnet second({.radius = 4e-3, .length = 9e-3, .remanence = 1.2});
  const Pose pose{.position = {0.7, -0.4, 0.9}, .axis = {0.2, 0.7, -0.5}};
  const auto moment = [](const CylinderMagnet& m) {
    return m.remanence() / vacuum_permeability * std::numbers::pi * m.radius() * m.radius() * m.length();
  };
  const Eigen::Vector3d m1 = moment(first) * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d m2 = moment(second) * pose.axis.normalized();
  const double d = pose.position.norm();
  const Eigen::Vector3d u = pose.position / d;
  const Eigen::Vector3d force = 3.0 * vacuum_permeability / (4.0 * std::numbers::pi * std::pow(d, 4)) *
                                (m1.dot(u) * m2 + m2.dot(u) * m1 + m1.dot(m2) * u - 5.0 * m1.dot(u) * m2.dot(u) * u);
  const Eigen::Vector3d field =
      vacuum_permeability / (4.0 * std::numbers::pi * std::pow(d, 3)) * (3.0 * m1.dot(u) * u - m1);
  const Wrench result = wrench(first, second, pose);
  EXPECT_LT((result.force - force).norm(), 3e-4 * force.norm());
  EXPECT_LT((result.torque - m2.cross(field)).norm(), 3e-4 * (m2.cross(field)).norm());
}

/// Flux of one ampere in the prototype through the magnet's sheet current, V s A = J, by Boost's integrals: the
/// potential A_phi of its loops round the magnet.
double linked_energy(const Pose& pose) {
  const Eigen::Vector3d n = pose.axis.normalized();
  const Eigen::Vector3d e1 = n.unitOrthogonal();
  const Eigen::Vector3d e2 = n.cross(e1);
  using Rule = boost::math::quadrature::gauss<double, 10>;
  constexpr int round = 32;
  const double radius = prototype_magnet.radius();
  const double flux = Rule::integrate(
      [&](double along) {
        double sum = 0.0;
        for (int j = 0; j < round; ++j) {
          const double phi = 2.0 * std::numbers::pi * j / round;
          const Eigen::Vector3d p = pose.position + along * n + radius * (std::cos(phi) * e1 + std::sin(phi) * e2);
          const Eigen::Vector3d tangent = std::cos(phi) * e2 - std::sin(phi) * e1;
          const double rho = std::hypot(p.x(), p.y());
          const double inductance = Rule::integrate(
              [&](double r) {
                return Rule::integrate(
                    [&](double z) {
                      const double k = std::sqrt(4 * r * rho / ((r + rho) * (r + rho) + (p.z() - z) * (p.z() - z)));
                      return std::sqrt(r * rho) * ((2 / k - k) * std::comp_ellint_1(k) - 2 / k * std::comp_ellint_2(k));
                    },
                    -6e-3, 6e-3);
              },
              3e-3, 9.5e-3);
          // A_phi = M / (2 pi rho) along (-y, x) / rho.
          sum += inductance * (p.x() * tangent.y() - p.y() * tangent.x()) / (2.0 * std::numbers::pi * rho * rho);
        }
        return sum * 2.0 * std::numbers::pi * radius / round;
      },
      -0.5 * prototype_magnet.length(), 0.5 * prototype_magnet.length());
  const double density = prototype.turns() / (12e-3 * 6.5e-3);
  return flux * density * prototype_magnet.remanence();
}

/// Sixth-order central difference of f at 0.
template <class F>
double slope(F f, double h) {
  return (45.0 * (f(h) - f(-h)) - 9.0 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60.0 * h);
}

// Second route: force and torque are the derivatives of the linked energy with respect to displacement and turning,
// here from loops' potentials with Boost's integrals. Steps of 0.2 mm and 0.02 rad against lengths of 5 mm leave
// (0.04)^6 = 4e-9; ten nodes each way leave less than 1e-7 at this clearance of 4 mm.
TEST(Wrench, IsTheDerivativeOfTheLinkedEnergy) {
  const Pose pose{.position = {5e-3, -2e-3, 17e-3}, .axis = {0.3, 0.25, 0.9}};
  const Wrench result = wrench(prototype, 1.0, prototype_magnet, pose);
  const double scale = result.force.norm();
  for (int i = 0; i < 3; ++i) {
    const double force = slope(
        [&](double h) {
          Pose moved = pose;
          moved.position[i] += h;
          return linked_energy(moved);
        },
        0.2e-3);
    EXPECT_NEAR(result.force[i], force, 3e-7 * scale) << i;
    const double torque = slope(
        [&](double angle) {
          return linked_energy(
              {.position = pose.position, .axis = Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(i)) * pose.axis});
        },
        0.02);
    EXPECT_NEAR(result.torque[i], torque, 3e-7 * scale * 10e-3) << i;
  }
}

TEST(Wrench, IsFiniteWhateverThePoseOverlapsIncluded) {
  random_pairs::Generator random(5);
  for (int i = 0; i < 60; ++i) {
    const ThickCoil coil =
        random_pairs::coil(random, i % 2 == 0 ? CurrentDistribution::uniform : CurrentDistribution::paper_shells);
    const CylinderMagnet magnet = random_pairs::magnet(random);
    const Pose pose{.position = random_pairs::log_uniform(random, 1e-6, 3.0) * random_pairs::direction(random),
                    .axis = random_pairs::direction(random)};
    const Wrench result = wrench(coil, 1.0, magnet, pose);
    ASSERT_TRUE(result.force.allFinite() && result.torque.allFinite()) << i;
  }
}

// Lengths whose squares vanish made 0 / 0 of the number of nodes, which was cast to an int: the sanitizers' run sees
// it.
TEST(Wrench, EndsAlsoForLengthsWhoseSquaresVanish) {
  const CylinderMagnet mote({.radius = 1e-313, .length = 1e-313, .remanence = 1.3});
  EXPECT_NO_THROW((void)wrench(mote, mote, {.position = {1e-3, 0, 2e-3}, .axis = {0, 0.1, 1}}));
}

TEST(Wrench, RefusesAPoseThatIsNone) {
  using testing::ThrowsMessage;
  using Error = std::invalid_argument;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        (void)wrench(prototype, 1.0, prototype_magnet, {.position = {0, nan, 0}});
      },
      ThrowsMessage<Error>("pose position must be finite; got nan"));
  EXPECT_THAT(
      [&] {
        (void)wrench(prototype, 1.0, prototype_magnet, {.position = {0, 0, 0.02}, .axis = {0, 0, 0}});
      },
      ThrowsMessage<Error>("pose axis must be finite and not zero; got 0"));
  EXPECT_THAT(
      [&] {
        (void)wrench(prototype, nan, prototype_magnet, {.position = {0, 0, 0.02}});
      },
      ThrowsMessage<Error>("current must be finite; got nan"));
  EXPECT_THAT(
      [&] {
        (void)wrench(prototype, nan, prototype, 1.0, {.position = {0, 0, 0.02}});
      },
      ThrowsMessage<Error>("first_current must be finite; got nan"));
  EXPECT_THAT(
      [&] {
        (void)wrench(prototype, 1.0, prototype, nan, {.position = {0, 0, 0.02}});
      },
      ThrowsMessage<Error>("second_current must be finite; got nan"));
}

}  // namespace
}  // namespace coilwright::magnetics
