#include "coilwright/magnetics/forces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "coilwright/magnetics/field.hpp"

namespace coilwright::magnetics {
namespace {

using std::numbers::pi;
using Rule = boost::math::quadrature::gauss<double, 20>;

const ThickCoil flat_coil(
    {.inner_radius = 3e-3, .outer_radius = 7e-3, .length = 6e-3, .turns_radial = 8, .turns_axial = 12});
const CylinderMagnet cylinder({.radius = 5e-3, .length = 4e-3, .remanence = 1.3});

Body block(const Eigen::Vector3d& size, const Eigen::Vector3d& remanence, const Pose& pose = {}) {
  return {.part = Magnet{.shape = Cuboid{.size = size}, .remanence = remanence}, .pose = pose};
}

Body ring(double inner, double outer, double length, const Eigen::Vector3d& remanence, const Pose& pose = {}) {
  return {.part = Magnet{.shape = Ring{.inner_radius = inner, .outer_radius = outer, .length = length},
                         .remanence = remanence},
          .pose = pose};
}

Wrench on_second(const Body& first, const Body& second) {
  return forces(std::vector<Body>{first, second}).on[1];
}

void expect_near(const Wrench& got, const Wrench& expected, double relative, double size = 5e-3) {
  EXPECT_LT((got.force - expected.force).norm(), relative * expected.force.norm());
  EXPECT_LT((got.torque - expected.torque).norm(),
            relative * std::max(expected.torque.norm(), size * expected.force.norm()));
}

TEST(Forces, OfCoilsAndCylindersAreTheWrenchToTheBit) {
  const Pose pose{.position = {1e-3, 2e-3, 9e-3}, .axis = {0.1, -0.2, 1.0}};
  const Body first{.part = DrivenCoil{.coil = flat_coil, .current = 1.4}};
  const Body second{.part = magnet_of(cylinder), .pose = pose};
  const Wrench expected = wrench(flat_coil, 1.4, cylinder, pose);
  EXPECT_EQ(on_second(first, second).force, expected.force);
  EXPECT_EQ(on_second(first, second).torque, expected.torque);
  const Wrench magnets = wrench(cylinder, cylinder, pose);
  EXPECT_EQ(on_second({.part = magnet_of(cylinder)}, second).force, magnets.force);
  const Wrench coils = wrench(flat_coil, 1.4, flat_coil, -0.7, pose);
  EXPECT_EQ(on_second(first, {.part = DrivenCoil{.coil = flat_coil, .current = -0.7}, .pose = pose}).torque,
            coils.torque);
}

// The magnet first or second, magnetised along or against its axis, and the whole scene turned: one force.
TEST(Forces, DoNotDependOnOrderAxesOrNames) {
  const Pose pose{.position = {1e-3, 2e-3, 9e-3}, .axis = {0.1, -0.2, 1.0}, .x_axis = {0.0, 1.0, 0.3}};
  const Body source{.part = DrivenCoil{.coil = flat_coil, .current = 1.4}};
  const Body target{.part = magnet_of(cylinder), .pose = pose};
  const Wrench expected = on_second(source, target);
  const Forces swapped = forces(std::vector<Body>{target, source});
  expect_near(swapped.on[0], expected, 1e-12);
  Body against = target;
  std::get<Magnet>(against.part).remanence *= -1.0;
  against.pose.axis *= -1.0;
  expect_near(on_second(source, against), expected, 1e-7);  // the points fall elsewhere
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.8, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()));
  const auto turned = [&](Body body) {
    body.pose = {.position = turn * body.pose.position + Eigen::Vector3d(4e-3, 5e-3, 6e-3),
                 .axis = turn * body.pose.axis,
                 .x_axis = turn * body.pose.x_axis};
    return body;
  };
  const Wrench elsewhere = on_second(turned(source), turned(target));
  expect_near({.force = turn.inverse() * elsewhere.force, .torque = turn.inverse() * elsewhere.torque}, expected, 1e-7);
}

// A ring's sheets against its faces' charge, and a cylinder's: two integrals with no surface in common.
TEST(Forces, OfSheetsAreThoseOfTheFacesCharge) {
  for (const Body& source :
       {Body{.part = magnet_of(cylinder)}, Body{.part = DrivenCoil{.coil = flat_coil, .current = 3.0}},
        ring(2e-3, 6e-3, 5e-3, {0.0, 0.0, -1.1})})
    for (const Pose& pose :
         {Pose{.position = {0.0, 0.0, 9e-3}}, Pose{.position = {3e-3, -1e-3, 8e-3}, .axis = {0.3, 0.1, 1.0}}}) {
      const Body target = ring(1.5e-3, 4e-3, 5e-3, {0.0, 0.0, 1.2}, pose);
      // With a hair of magnetisation across the axis it is computed by its faces.
      const Body oblique = ring(1.5e-3, 4e-3, 5e-3, {1e-30, 0.0, 1.2}, pose);
      ASSERT_FALSE(is_axial(oblique));
      const Forces faces = forces(std::vector<Body>{source, oblique});
      expect_near(on_second(source, target), faces.on[1], 2e-7);
      EXPECT_GT(faces.error, 0.0);
      EXPECT_LT(faces.error, 1e-7 * faces.on[1].force.norm());
    }
}

/// Force on the second of two blocks with parallel edges, both magnetised along z, `apart` their centres: Akoun and
/// Yonnet, IEEE Trans. Magn. 20, 1962, 1984. Halves of the sides are `a` and `b`.
Eigen::Vector3d akoun(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& apart,
                      double product) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int bits = 0; bits < 64; ++bits) {
    Eigen::Vector3d place;
    double sign = 1.0;
    for (int i = 0; i < 3; ++i) {
      const double first = (bits >> (2 * i)) % 2 == 0 ? 1.0 : -1.0;
      const double second = (bits >> (2 * i + 1)) % 2 == 0 ? 1.0 : -1.0;
      place[i] = apart[i] + second * b[i] - first * a[i];
      sign *= first * second;
    }
    const double u = place.x();
    const double v = place.y();
    const double w = place.z();
    const double r = place.norm();
    const double angle = w == 0.0 ? 0.0 : std::atan(u * v / (r * w));
    const auto product_log = [](double factor, double argument) {
      return factor == 0.0 ? 0.0 : factor * std::log(argument);
    };
    sum +=
        sign * Eigen::Vector3d(
                   product_log(0.5 * (v * v - w * w), r - u) + product_log(u * v, r - v) + v * w * angle + 0.5 * r * u,
                   product_log(0.5 * (u * u - w * w), r - v) + product_log(u * v, r - u) + u * w * angle + 0.5 * r * v,
                   -product_log(u * w, r - u) - product_log(v * w, r - v) + u * v * angle - r * w);
  }
  return product / (4.0 * pi * vacuum_permeability) * sum;
}

TEST(Forces, OfParallelBlocksAreThoseOfAkounAndYonnet) {
  const Eigen::Vector3d a(10e-3, 12e-3, 5e-3);
  const Eigen::Vector3d b(6e-3, 8e-3, 7e-3);
  for (const Eigen::Vector3d& apart :
       {Eigen::Vector3d(1e-3, 2e-3, 8e-3), Eigen::Vector3d(9e-3, -3e-3, 6.5e-3),
        Eigen::Vector3d(1e-3, 2e-3, 6e-3 + 1e-9), Eigen::Vector3d(30e-3, 20e-3, 40e-3)}) {
    const Wrench got = on_second(block(a, {0.0, 0.0, 1.3}), block(b, {0.0, 0.0, 1.2}, {.position = apart}));
    const Eigen::Vector3d expected = akoun(0.5 * a, 0.5 * b, apart, 1.3 * 1.2);
    // The third touches, but for a nanometre that keeps the closed form's logarithms finite.
    EXPECT_LT((got.force - expected).norm(), 1e-6 * expected.norm()) << apart.transpose();
  }
}

/// Energy of a magnet in the field of another body, J: -J . B / mu0 over its volume, by Gauss-Legendre.
double energy(const Body& source, const Body& target) {
  const auto& magnet = std::get<Magnet>(target.part);
  const Eigen::Matrix3d axes = rotation_of(target.pose);
  const Eigen::Vector3d polarisation = axes * magnet.remanence;
  const auto density = [&](const Eigen::Vector3d& local) {
    const Eigen::Vector3d point = target.pose.position + axes * local;
    return -polarisation.dot(flux_density({&source, 1}, {&point, 1}).front()) / vacuum_permeability;
  };
  if (const auto* cuboid = std::get_if<Cuboid>(&magnet.shape)) {
    const Eigen::Vector3d half = 0.5 * cuboid->size;
    using Side = boost::math::quadrature::gauss<double, 10>;
    return Side::integrate(
        [&](double x) {
          return Side::integrate(
              [&](double y) {
                return Side::integrate([&](double z) { return density({x, y, z}); }, -half.z(), half.z());
              },
              -half.y(), half.y());
        },
        -half.x(), half.x());
  }
  const auto& shape = std::get<Ring>(magnet.shape);
  constexpr int round = 24;
  using Side = boost::math::quadrature::gauss<double, 10>;
  double sum = 0.0;
  for (int j = 0; j < round; ++j) {
    const double phi = 2.0 * pi * j / round;
    sum += Side::integrate(
        [&](double r) {
          return r * Side::integrate(
                         [&](double z) {
                           return density({r * std::cos(phi), r * std::sin(phi), z});
                         },
                         -0.5 * shape.length, 0.5 * shape.length);
        },
        shape.inner_radius, shape.outer_radius);
  }
  return sum * 2.0 * pi / round;
}

// Virtual work: force and torque are the slopes of the energy, here over the volume, there over the faces. Central
// differences of fourth order over 0.2 mm and 0.02 rad of bodies 4 mm apart leave some 1e-6.
TEST(Forces, AreTheSlopesOfTheEnergyOverTheVolume) {
  const Pose pose{.position = {4e-3, -2e-3, 12e-3}, .axis = {0.3, 0.25, 0.9}, .x_axis = {1.0, 0.4, 0.0}};
  const std::vector<Body> sources{block({8e-3, 6e-3, 5e-3}, {0.4, -0.3, 1.1}),
                                  ring(1e-3, 5e-3, 5e-3, {1.2, 0.0, 0.3}),
                                  {.part = DrivenCoil{.coil = flat_coil, .current = 3.0}}};
  const std::vector<Body> targets{block({4e-3, 5e-3, 6e-3}, {0.2, 1.0, -0.6}, pose),
                                  ring(1e-3, 3e-3, 6e-3, {1.1, 0.3, 0.2}, pose)};
  for (const Body& source : sources)
    for (const Body& target : targets) {
      const Wrench got = on_second(source, target);
      const auto slope = [](const auto& f, double h) {
        return (8.0 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12.0 * h);
      };
      for (int i = 0; i < 3; ++i) {
        const double force = -slope(
            [&](double h) {
              Body moved = target;
              moved.pose.position[i] += h;
              return energy(source, moved);
            },
            0.2e-3);
        EXPECT_NEAR(got.force[i], force, 5e-6 * got.force.norm());
        const double torque = -slope(
            [&](double angle) {
              const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::Unit(i));
              Body turned = target;
              turned.pose.axis = turn * target.pose.axis;
              turned.pose.x_axis = turn * target.pose.x_axis;
              return energy(source, turned);
            },
            0.02);
        EXPECT_NEAR(got.torque[i], torque, 5e-6 * (got.torque.norm() + 5e-3 * got.force.norm()));
      }
    }
}

// What acts on a coil beside a block is taken from what acts on the block; here it is J x B over the copper.
TEST(Forces, OnACoilBesideABlockAreThoseOnItsCurrent) {
  const Body magnet = block({8e-3, 6e-3, 5e-3}, {0.4, -0.3, 1.1});
  const Pose pose{.position = {3e-3, -2e-3, 12e-3}, .axis = {0.3, 0.25, 0.9}};
  const Body winding{.part = DrivenCoil{.coil = flat_coil, .current = 3.0}, .pose = pose};
  const Eigen::Matrix3d axes = rotation_of(pose);
  const double density = 96.0 * 3.0 / (4e-3 * 6e-3);
  Wrench expected;
  constexpr int round = 48;
  const auto& nodes = Rule::abscissa();
  const auto& weights = Rule::weights();
  for (int j = 0; j < round; ++j) {
    const double phi = 2.0 * pi * j / round;
    const Eigen::Vector3d out(std::cos(phi), std::sin(phi), 0.0);
    const Eigen::Vector3d along(-out.y(), out.x(), 0.0);
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t b = 0; b < nodes.size(); ++b)
        for (const double s : {-1.0, 1.0})
          for (const double t : {-1.0, 1.0}) {
            const double r = 5e-3 + 2e-3 * s * nodes[a];
            const double z = 3e-3 * t * nodes[b];
            const Eigen::Vector3d arm = axes * (r * out + z * Eigen::Vector3d::UnitZ());
            const Eigen::Vector3d point = pose.position + arm;
            const Eigen::Vector3d force = density * (2.0 * pi / round) * r * 2e-3 * weights[a] * 3e-3 * weights[b] *
                                          (axes * along).cross(flux_density({&magnet, 1}, {&point, 1}).front());
            expected.force += force;
            expected.torque += arm.cross(force);
          }
  }
  expect_near(on_second(magnet, winding), expected, 1e-7);
}

// Of many bodies nothing is left over, and each row of the matrix adds up.
TEST(Forces, OfManyBodiesBalance) {
  const std::vector<Body> bodies{
      block({8e-3, 6e-3, 5e-3}, {0.4, -0.3, 1.1}),
      ring(1e-3, 5e-3, 5e-3, {1.2, 0.0, 0.3}, {.position = {2e-3, 0.0, 9e-3}, .axis = {0.1, 0.3, 1.0}}),
      {.part = DrivenCoil{.coil = flat_coil, .current = 3.0},
       .pose = {.position = {18e-3, 0.0, 2e-3}, .axis = {1.0, 0.0, 0.4}}},
      {.part = magnet_of(cylinder), .pose = {.position = {-14e-3, 3e-3, 5e-3}, .axis = {0.0, 1.0, 0.4}}}};
  const Forces all = forces(bodies);
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double size = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    force += all.on[i].force;
    moment += all.on[i].torque + bodies[i].pose.position.cross(all.on[i].force);
    size += all.on[i].force.norm();
    Wrench row;
    for (const Wrench& part : all.by[i]) {
      row.force += part.force;
      row.torque += part.torque;
    }
    EXPECT_LT((row.force - all.on[i].force).norm(), 1e-14);
    EXPECT_LT((row.torque - all.on[i].torque).norm(), 1e-14);
    EXPECT_EQ(all.by[i][i].force.norm(), 0.0);
    // Alone with each other two bodies feel the same.
    for (std::size_t j = 0; j < bodies.size(); ++j)
      if (j != i) expect_near(on_second(bodies[j], bodies[i]), all.by[i][j], 2e-7);
  }
  EXPECT_LT(force.norm(), 1e-13 * size);
  EXPECT_LT(moment.norm(), 1e-13 * size);
}

TEST(Forces, OfABlockBecomeThoseOfDipolesFarAway) {
  const Pose pose{.position = {0.7, -0.4, 0.9}, .axis = {0.2, 0.7, -0.5}, .x_axis = {1.0, 0.0, 0.5}};
  const Body first = block({8e-3, 6e-3, 5e-3}, {0.4, -0.3, 1.1});
  const Body second = ring(1e-3, 5e-3, 5e-3, {1.2, 0.0, 0.3}, pose);
  const Eigen::Vector3d m1 = Eigen::Vector3d(0.4, -0.3, 1.1) / vacuum_permeability * 240e-9;
  const Eigen::Vector3d m2 =
      rotation_of(pose) * Eigen::Vector3d(1.2, 0.0, 0.3) / vacuum_permeability * pi * 24e-6 * 5e-3;
  const double d = pose.position.norm();
  const Eigen::Vector3d u = pose.position / d;
  const Eigen::Vector3d force = 3.0 * vacuum_permeability / (4.0 * pi * std::pow(d, 4)) *
                                (m1.dot(u) * m2 + m2.dot(u) * m1 + m1.dot(m2) * u - 5.0 * m1.dot(u) * m2.dot(u) * u);
  EXPECT_LT((on_second(first, second).force - force).norm(), 1e-4 * force.norm());
}

// Edges of one in the face of the other: the estimate is honest, and the number good to 1e-4.
TEST(Forces, SayHowWellTheyAreKnownWhereBodiesTouch) {
  const Body plate = block({10e-3, 10e-3, 5e-3}, {0.0, 0.0, 1.3});
  const Pose pose{.position = {0.5e-3, 0.0, 5.5e-3}};
  const Forces round = forces(std::vector<Body>{plate, ring(0.0, 4e-3, 6e-3, {0.0, 0.0, 1.3}, pose)});
  const Pose turned{.position = {0.5e-3, 0.0, 5e-3}, .axis = {0.0, 0.0, 1.0}, .x_axis = {1.0, 1.0, 0.0}};
  const Forces square = forces(std::vector<Body>{plate, block({6e-3, 6e-3, 5e-3}, {0.0, 0.0, 1.3}, turned)});
  for (const Forces& each : {round, square}) {
    EXPECT_LT(each.error, 1e-3 * each.on[1].force.norm());
    EXPECT_LT(std::abs(each.on[1].force.y()), each.error + 1e-6);  // by symmetry it is none
  }
}

}  // namespace
}  // namespace coilwright::magnetics
