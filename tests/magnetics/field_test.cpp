#include "coilwright/magnetics/field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "coilwright/magnetics/constants.hpp"
#include "random_draw.hpp"

namespace coilwright::magnetics {
namespace {

using random_draw::Generator;
using random_draw::uniform;
using std::numbers::pi;

constexpr double radius = 5e-3;
constexpr double half = 3e-3;
const Eigen::Vector3d oblique(0.7, -0.5, 0.9);  // T
const Pose tilted{.position = {1e-3, 2e-3, -1e-3}, .axis = {0.3, -0.4, 0.8}, .x_axis = {1.0, 2.0, 0.3}};

const ThickCoil small_coil(
    {.inner_radius = 2e-3, .outer_radius = 5e-3, .length = 6e-3, .turns_radial = 5, .turns_axial = 10});

Body disc(const Eigen::Vector3d& remanence) {
  return {.part = Magnet{.shape = Ring{.inner_radius = 0.0, .outer_radius = radius, .length = 2.0 * half},
                         .remanence = remanence}};
}

/// One body of each kind, magnetised obliquely and tilted.
std::vector<Body> each_kind() {
  return {{.part = Magnet{.shape = Ring{.inner_radius = 0.0, .outer_radius = radius, .length = 2.0 * half},
                          .remanence = oblique},
           .pose = tilted},
          {.part = Magnet{.shape = Ring{.inner_radius = 2e-3, .outer_radius = radius, .length = 2.0 * half},
                          .remanence = oblique},
           .pose = tilted},
          {.part = Magnet{.shape = Cuboid{.size = {6e-3, 8e-3, 10e-3}}, .remanence = oblique}, .pose = tilted},
          {.part = DrivenCoil{.coil = small_coil, .current = 1.3}, .pose = tilted}};
}

Eigen::Vector3d at(const Body& body, const Eigen::Vector3d& point) {
  return flux_density({&body, 1}, {&point, 1}).front();
}

FieldSample sample_at(const Body& body, const Eigen::Vector3d& point) {
  return field({&body, 1}, {&point, 1}).front();
}

// The textbook's disc and thick solenoid, at places on the axis inside, on the face and far away.
TEST(Field, OnTheAxisIsThatOfTheSolenoidAndTheDisc) {
  const auto sheet = [](double r, double l, double z) {
    return 0.5 * ((z + l) / std::hypot(z + l, r) - (z - l) / std::hypot(z - l, r));
  };
  for (const double z : {0.0, 1e-3, 3e-3, 3.1e-3, 8e-3, 0.1}) {
    const double magnet = at(disc({0.0, 0.0, 1.3}), {0.0, 0.0, z}).z();
    EXPECT_NEAR(magnet / (1.3 * sheet(radius, half, z)), 1.0, 1e-10) << z;
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    const double mean = Rule::integrate([&](double r) { return sheet(r, half, z); }, 2e-3, 5e-3, 6, 1e-13) / 3e-3;
    const double winding = at({.part = DrivenCoil{.coil = small_coil, .current = 1.3}}, {0.0, 0.0, z}).z();
    EXPECT_NEAR(winding / (vacuum_permeability * 50.0 * 1.3 / 6e-3 * mean), 1.0, 1e-10) << z;
  }
}

/// H over M of a cylinder magnetised along x, in cylindrical coordinates: Caciagli, Baars, Philipse and Kuipers,
/// J. Magn. Magn. Mater. 456, 423, 2018, (20) to (22), with the standard library's elliptic integrals.
Eigen::Vector3d caciagli(double rho, double phi, double z) {
  std::array<double, 3> sum{};
  for (const double end : {1.0, -1.0}) {
    const double xi = z + end * half;
    const double alpha = 1.0 / std::hypot(xi, rho + radius);
    const double gamma = (rho - radius) / (rho + radius);
    const double rest = 1.0 - gamma * gamma;
    const double m = 1.0 - (xi * xi + (rho - radius) * (rho - radius)) * alpha * alpha;
    const double first = std::comp_ellint_1(std::sqrt(m));
    const double second = std::comp_ellint_2(std::sqrt(m));
    const double third = std::comp_ellint_3(std::sqrt(m), rest);
    const double p1 = first - 2.0 / m * (first - second);
    const double p3 = (first - second) / m - gamma * gamma / rest * (third - first);
    const double p4 = gamma / rest * (third * (1.0 + gamma * gamma) - 2.0 * first) - p1;
    sum[0] += end * xi * alpha * p4;
    sum[1] += end * xi * alpha * p3;
    sum[2] += end * alpha * p1;
  }
  return {radius * std::cos(phi) / (2.0 * pi * rho) * sum[0], radius * std::sin(phi) / (pi * rho) * sum[1],
          radius * std::cos(phi) / pi * sum[2]};
}

TEST(Field, OfADiametrallyMagnetisedCylinderIsThatOfCaciagliAndOthers) {
  const Body magnet = disc({1.3, 0.0, 0.0});
  for (const double rho : {0.4e-3, 2e-3, 4.9e-3, 5.1e-3, 7e-3, 30e-3})
    for (const double z : {0.0, 1e-3, 2.9e-3, 3.5e-3, -8e-3})
      for (const double phi : {0.0, 0.7, 2.5}) {
        const Eigen::Vector3d cylindrical = caciagli(rho, phi, z);
        const Eigen::Vector3d out(std::cos(phi), std::sin(phi), 0.0);
        const Eigen::Vector3d round(-out.y(), out.x(), 0.0);
        Eigen::Vector3d expected = 1.3 * (cylindrical.x() * out + cylindrical.y() * round);
        expected.z() = 1.3 * cylindrical.z();
        if (rho < radius && std::abs(z) < half) expected.x() += 1.3;
        EXPECT_LT((at(magnet, rho * out + z * Eigen::Vector3d::UnitZ()) - expected).norm(), 1e-9)
            << rho << ' ' << phi << ' ' << z;
      }
}

// The charge on the faces of a block, integrated adaptively: no formula in common with the corners' sum.
TEST(Field, OfABlockIsThatOfTheChargeOnItsFaces) {
  const Eigen::Vector3d sides(3e-3, 4e-3, 5e-3);  // halves
  const Body block{.part = Magnet{.shape = Cuboid{.size = 2.0 * sides}, .remanence = oblique}};
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  for (const Eigen::Vector3d& point : {Eigen::Vector3d(5e-3, 1e-3, -2e-3), Eigen::Vector3d(-1e-3, 9e-3, 7e-3),
                                       Eigen::Vector3d(1e-3, -2e-3, 3e-3), Eigen::Vector3d(0.0, 0.0, 6e-3)}) {
    Eigen::Vector3d expected = (point.cwiseAbs().array() < sides.array()).all() ? oblique : Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis)
      for (const double end : {-1.0, 1.0})
        for (int k = 0; k < 3; ++k) {
          const int u = (axis + 1) % 3;
          const int v = (axis + 2) % 3;
          expected[k] += end * oblique[axis] / (4.0 * pi) *
                         Rule::integrate(
                             [&](double p) {
                               return Rule::integrate(
                                   [&](double q) {
                                     Eigen::Vector3d from;
                                     from[axis] = end * sides[axis];
                                     from[u] = p;
                                     from[v] = q;
                                     const Eigen::Vector3d arm = point - from;
                                     return arm[k] / std::pow(arm.norm(), 3);
                                   },
                                   -sides[v], sides[v], 8, 1e-11);
                             },
                             -sides[u], sides[u], 8, 1e-11);
        }
    EXPECT_LT((at(block, point) - expected).norm(), 1e-9) << point.transpose();
  }
  // What makers print for the middle of a face's axis, a distance x from it.
  const Body magnet{.part = Magnet{.shape = Cuboid{.size = {10e-3, 20e-3, 5e-3}}, .remanence = {0.0, 0.0, 1.3}}};
  for (const double x : {0.7e-3, 4e-3}) {
    const auto angle = [](double d) { return std::atan(10e-3 * 20e-3 / (2.0 * d * std::sqrt(4.0 * d * d + 5e-4))); };
    EXPECT_NEAR(at(magnet, {0.0, 0.0, 2.5e-3 + x}).z(), 1.3 / pi * (angle(x) - angle(x + 5e-3)), 1e-12);
  }
}

/// dB_i / dx_j by sixth-order central differences.
Eigen::Matrix3d differences(const Body& body, const Eigen::Vector3d& point, double step) {
  Eigen::Matrix3d out;
  for (int j = 0; j < 3; ++j) {
    const auto apart = [&](double steps) {
      const Eigen::Vector3d move = steps * step * Eigen::Vector3d::Unit(j);
      return Eigen::Vector3d(at(body, point + move) - at(body, point - move));
    };
    out.col(j) = (45.0 * apart(1.0) - 9.0 * apart(2.0) + apart(3.0)) / (60.0 * step);
  }
  return out;
}

// Steps of 10 um, three times to either side, of points 0.2 mm and more from every surface: (0.03 / 0.2)^6 = 1e-5 of
// the seventh's share near an edge, and less than 1e-6 of a gradient over the body's radius at most points.
TEST(Field, HasNoSourcesAndNoCurlOutsideOfCopperAndItsGradientIsItsSlope) {
  Generator random(11);
  for (const Body& body : each_kind()) {
    const bool is_coil = std::holds_alternative<DrivenCoil>(body.part);
    int compared = 0;
    while (compared < 60) {
      const Eigen::Vector3d point =
          tilted.position +
          12e-3 * Eigen::Vector3d(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
      bool clear = true;
      for (int k = 0; k < 26 && clear; ++k) {
        const Eigen::Vector3d way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        clear = is_inside(body, point) == is_inside(body, point + 0.2e-3 * way);
      }
      if (!clear) continue;
      ++compared;
      const Eigen::Matrix3d slopes = differences(body, point, 10e-6);
      const Eigen::Matrix3d gradient = sample_at(body, point).gradient;
      const double scale = std::max(gradient.norm(), at(body, point).norm() / radius);
      EXPECT_LT(std::abs(gradient.trace()), 1e-8 * scale);
      EXPECT_LT((slopes - gradient).norm(), 2e-6 * scale) << point.transpose();
      if (!is_coil || !is_inside(body, point)) {
        EXPECT_LT((gradient - gradient.transpose()).norm(), 1e-8 * scale);
      }
    }
  }
}

// On the axis and next to it the formulas divide nothing by nothing.
TEST(Field, HasTheSameGradientOnTheAxisAsNextToIt) {
  for (const Eigen::Vector3d& remanence : {Eigen::Vector3d(1.3, 0.0, 0.0), Eigen::Vector3d(0.0, 0.0, 1.3), oblique})
    for (const double z : {0.5e-3, 4e-3}) {
      const Body magnet = disc(remanence);
      const Eigen::Matrix3d on = sample_at(magnet, {0.0, 0.0, z}).gradient;
      // It changes by some of itself in a radius.
      for (const double aside : {1e-12, 1e-8, 1e-6})
        EXPECT_LT((sample_at(magnet, {0.6 * aside, 0.8 * aside, z}).gradient - on).norm(),
                  (10.0 * aside / radius + 1e-8) * on.norm())
            << aside;
      EXPECT_LT((differences(magnet, {0.0, 0.0, z}, 20e-6) - on).norm(), 1e-6 * on.norm());
    }
}

// Ampere's law round the copper of one side of a coil, over a rectangle that no formula knows of: 4 sides of 32 nodes.
TEST(Field, RoundACoilAddsUpToItsAmpereTurns) {
  const Body body{.part = DrivenCoil{.coil = small_coil, .current = 1.3}};
  const std::array<Eigen::Vector3d, 5> corners{Eigen::Vector3d(0.5e-3, 0, -6e-3), Eigen::Vector3d(9e-3, 0, -6e-3),
                                               Eigen::Vector3d(9e-3, 0, 6e-3), Eigen::Vector3d(0.5e-3, 0, 6e-3),
                                               Eigen::Vector3d(0.5e-3, 0, -6e-3)};
  double round = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d side = corners[i + 1] - corners[i];
    round += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        [&](double t) { return at(body, corners[i] + t * side).dot(side); }, 0.0, 1.0, 4, 1e-11);
  }
  EXPECT_NEAR(-round / (vacuum_permeability * 50.0 * 1.3), 1.0, 1e-9);
}

TEST(Field, BecomesThatOfADipoleFarAway) {
  const auto check = [](const Body& body, const Eigen::Vector3d& moment) {
    for (const double distance : {0.4, 4.0, 40.0}) {
      const Eigen::Vector3d u = Eigen::Vector3d(0.5, -0.3, 0.7).normalized();
      const Eigen::Vector3d dipole =
          vacuum_permeability / (4.0 * pi * std::pow(distance, 3)) * (3.0 * moment.dot(u) * u - moment);
      // Finite sizes add some (5 mm / 0.4 m)^2 = 2e-4.
      EXPECT_LT((at(body, tilted.position + distance * u) - dipole).norm(),
                (3e-4 * std::pow(0.4 / distance, 2) + 1e-8) * dipole.norm());
    }
  };
  const Eigen::Matrix3d axes = rotation_of(tilted);
  const Eigen::Vector3d magnetisation = axes * oblique / vacuum_permeability;
  const std::vector<Body> bodies = each_kind();
  check(bodies[0], magnetisation * pi * radius * radius * 2.0 * half);
  check(bodies[1], magnetisation * pi * (radius * radius - 4e-6) * 2.0 * half);
  check(bodies[2], magnetisation * 480e-9);
  double area = 0.0;  // mean over the winding's radii
  area = pi * (std::pow(5e-3, 3) - std::pow(2e-3, 3)) / (3.0 * 3e-3);
  check(bodies[3], axes.col(2) * 50.0 * 1.3 * area);
}

// Just outside on a face the normal part of B is continuous and the part along it that of the outside.
TEST(Field, OnASurfaceIsThatJustOutside) {
  for (const Body& body :
       {disc(oblique),
        Body{.part = Magnet{.shape = Ring{.inner_radius = 2e-3, .outer_radius = radius, .length = 6e-3},
                     .remanence = oblique}},
        Body{.part = Magnet{.shape = Cuboid{.size = {8e-3, 8e-3, 6e-3}}, .remanence = oblique}}}) {
    const double side = std::holds_alternative<Cuboid>(shape_of(body)) ? 4e-3 : radius;
    for (const auto& [on, out] : {std::pair(Eigen::Vector3d(2.5e-3, 1e-3, 3e-3), Eigen::Vector3d(0, 0, 1)),
                                  std::pair(Eigen::Vector3d(2.5e-3, 1e-3, -3e-3), Eigen::Vector3d(0, 0, -1)),
                                  std::pair(Eigen::Vector3d(side, 0, 1e-3), Eigen::Vector3d(1, 0, 0)),
                                  std::pair(Eigen::Vector3d(0, -side, 1e-3), Eigen::Vector3d(0, -1, 0))}) {
      EXPECT_LT((at(body, on) - at(body, on + 1e-9 * out)).norm(), 1e-5);
      EXPECT_GT((at(body, on) - at(body, on - 1e-9 * out)).norm(), 0.1);
    }
  }
  const Body ring = each_kind()[1];
  EXPECT_TRUE(at(ring, tilted.position).allFinite());
}

// The mean over the volume of a body's own H, by points of equal volume, is -N M; of a cube a third.
TEST(Field, InAMagnetIsInTheMeanThatOfItsDemagnetisationFactors) {
  const std::vector<std::pair<Shape, Eigen::Vector3d>> shapes{
      {Cuboid{.size = {4e-3, 6e-3, 9e-3}}, {4e-3, 6e-3, 9e-3}},
      {Ring{.inner_radius = 2e-3, .outer_radius = 5e-3, .length = 4e-3}, {10e-3, 10e-3, 4e-3}},
      {Ring{.inner_radius = 0.0, .outer_radius = 5e-3, .length = 4e-3}, {10e-3, 10e-3, 4e-3}}};
  for (const auto& [shape, box] : shapes) {
    const Body body{.part = Magnet{.shape = shape, .remanence = {1.0, 1.0, 1.0}}};
    constexpr int points = 40;
    std::vector<Eigen::Vector3d> inside;
    for (int i = 0; i < points; ++i)
      for (int j = 0; j < points; ++j)
        for (int k = 0; k < points; ++k) {
          const Eigen::Vector3d share((i + 0.5) / points - 0.5, (j + 0.5) / points - 0.5, (k + 0.5) / points - 0.5);
          const Eigen::Vector3d point = share.cwiseProduct(box);
          if (is_inside(body, point)) inside.push_back(point);
        }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& each : flux_density({&body, 1}, inside)) mean += each;
    mean /= static_cast<double>(inside.size());
    const Eigen::Vector3d factors = demagnetisation_factors(shape);
    EXPECT_NEAR(factors.sum(), 1.0, 1e-9);
    // 40 points along each side leave the logarithms at the edges and a staircase for a rim: 0.3 %.
    EXPECT_LT((Eigen::Vector3d::Ones() - mean - factors).cwiseAbs().maxCoeff(), 4e-3);
  }
  EXPECT_NEAR(demagnetisation_factors(Cuboid{.size = {1.0, 1.0, 1.0}}).z(), 1.0 / 3.0, 1e-14);
}

// Those of the faces through which it is magnetised.
TEST(Field, IsInfiniteOnTheEdgesOfPolesAlone) {
  const auto block = [](const Eigen::Vector3d& remanence) {
    return Body{.part = Magnet{.shape = Cuboid{.size = {4e-3, 6e-3, 8e-3}}, .remanence = remanence},
                .pose = {.position = {1e-3, 2e-3, 3e-3}, .axis = {0.3, -0.2, 1.0}}};
  };
  const auto ring = [](const Eigen::Vector3d& remanence) {
    return Body{.part = Magnet{.shape = Ring{.inner_radius = 2e-3, .outer_radius = 5e-3, .length = 6e-3},
                               .remanence = remanence}};
  };
  const auto is_on = [](const Body& body, const Eigen::Vector3d& own) {
    return is_on_edge(body, body.pose.position + rotation_of(body.pose) * own);
  };
  const Eigen::Vector3d along(0.0, 0.0, 1.2), across(1.2, 0.0, 0.0);
  EXPECT_TRUE(is_on(block(along), {2e-3, 1e-3, -4e-3}));
  EXPECT_TRUE(is_on(block(along), {2e-3, 3e-3, 4e-3}));
  EXPECT_FALSE(is_on(block(along), {2e-3, 3e-3, 1e-3}));  // between two sides without a pole
  EXPECT_TRUE(is_on(block(across), {2e-3, 3e-3, 1e-3}));
  EXPECT_FALSE(is_on(block(along), {2e-3, 1e-3, 1e-3}));
  EXPECT_FALSE(is_on(block(along), {2.0001e-3, 1e-3, -4e-3}));
  for (const double edge : {2e-3, 5e-3}) {
    EXPECT_TRUE(is_on(ring(along), {0.6 * edge, 0.8 * edge, 3e-3}));
    EXPECT_TRUE(is_on(ring(across), {0.6 * edge, 0.8 * edge, -3e-3}));
    EXPECT_FALSE(is_on(ring(across), {0.0, edge, 3e-3}));  // there its side has no pole
  }
  EXPECT_FALSE(is_on(ring(along), {0.0, 3e-3, 3e-3}));
}

TEST(Field, OfSeveralBodiesIsTheirSum) {
  const std::vector<Body> bodies = each_kind();
  const Eigen::Vector3d point(9e-3, 7e-3, 12e-3);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Body& body : bodies) sum += at(body, point);
  EXPECT_LT((flux_density(bodies, {&point, 1}).front() - sum).norm(), 1e-15);
  EXPECT_EQ(field(bodies, {&point, 1}).front().flux_density, flux_density(bodies, {&point, 1}).front());
}

TEST(Field, RefusesBodiesAndPointsThatAreNone) {
  const auto refused = [](const Body& body, const Eigen::Vector3d& point, const std::string& why) {
    EXPECT_THAT([&] { (void)at(body, point); }, testing::ThrowsMessage<std::invalid_argument>(why));
  };
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  refused({.part = Magnet{.shape = Ring{.inner_radius = 2.0, .outer_radius = 1.0, .length = 1.0}}}, origin,
          "outer radius must be finite and beyond the inner radius; got 1");
  refused({.part = Magnet{.shape = Cuboid{.size = {1.0, 0.0, 1.0}}}}, origin, "side must be finite and > 0; got 0");
  Body body = disc(oblique);
  std::get<Magnet>(body.part).recoil_permeability = 1.5;
  refused(body, origin, "recoil permeability must be from 1 to 1.2; got 1.5");
  refused(disc(oblique), {0.0, 0.0, std::numeric_limits<double>::infinity()}, "point must be finite; got inf");
}

}  // namespace
}  // namespace coilwright::magnetics
