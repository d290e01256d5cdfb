#include "coilwright/magnetics/plate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "coilwright/magnetics/field.hpp"
#include "coilwright/magnetics/forces.hpp"

namespace coilwright::magnetics {
namespace {

using std::numbers::pi;

const Plate plate{.thickness = 3e-3};

// A disc of 12.7 by 3.175 mm and 1.32 T, `gap` above the face.
Body disc(double gap) {
  return {.part = Magnet{.shape = Ring{.inner_radius = 0.0, .outer_radius = 6.35e-3, .length = 3.175e-3},
                         .remanence = {0.0, 0.0, 1.32}},
          .pose = {.position = {0.0, 0.0, 0.5 * 3.175e-3 + gap}}};
}

std::vector<Body> with_images(const std::vector<Body>& bodies, const Plate& mirror) {
  std::vector<Body> all = bodies;
  for (const Body& body : bodies) all.push_back(image_of(body, mirror));
  return all;
}

TEST(Plate, PullsADiscAsItsMirrorImageDoes) {
  const Forces touching = forces(std::vector<Body>{disc(0.0)}, plate);
  EXPECT_NEAR(touching.on[0].force.z(), -34.078, 0.001);
  const CylinderMagnet magnet({.radius = 6.35e-3, .length = 3.175e-3, .remanence = 1.32});
  for (const double gap : {0.0, 0.05e-3, 2e-3})
    EXPECT_NEAR(forces(std::vector<Body>{disc(gap)}, plate).on[0].force.z(),
                axial_force(magnet, magnet, 3.175e-3 + 2.0 * gap), 1e-12);
  // Of iron that is no perfect mirror (mu - 1) / (mu + 1) of it.
  Plate mild = plate;
  mild.relative_permeability = 500.0;
  EXPECT_NEAR(forces(std::vector<Body>{disc(0.0)}, mild).on[0].force.z(), 499.0 / 501.0 * touching.on[0].force.z(),
              1e-9);
}

// The field of bodies and images is square to the face of a perfect mirror, whatever the bodies, and its pressure on
// the face, B^2 / (2 mu0), is what pulls.
TEST(Plate, HasAFieldSquareToItsFaceWhosePressureIsThePull) {
  const Plate aslant{.position = {1e-3, -2e-3, 0.5e-3}, .normal = {0.2, -0.3, 1.0}, .thickness = 3e-3};
  const ThickCoil coil(
      {.inner_radius = 3e-3, .outer_radius = 7e-3, .length = 6e-3, .turns_radial = 8, .turns_axial = 12});
  const std::vector<Body> bodies{
      {.part = Magnet{.shape = Cuboid{.size = {5e-3, 6e-3, 4e-3}}, .remanence = {0.6, 0.3, -0.9}},
       .pose = {.position = {4e-3, 0.0, 11e-3}, .axis = {0.3, 0.1, 1.0}, .x_axis = {1.0, 1.0, 0.0}}},
      {.part = DrivenCoil{.coil = coil, .current = 40.0},
       .pose = {.position = {-9e-3, 1e-3, 14e-3}, .axis = {1.0, 0.2, 0.4}}}};
  const std::vector<Body> all = with_images(bodies, aslant);
  const Eigen::Vector3d normal = aslant.normal.normalized();
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  const Eigen::Vector3d foot = aslant.position + 5e-3 * u;
  double pull = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  // Radius r = s t / (1 - t), midpoints; the pressure falls as 1 / r^6.
  constexpr int radii = 400;
  constexpr int angles = 96;
  for (int i = 0; i < radii; ++i) {
    const double t = (i + 0.5) / radii;
    const double r = 12e-3 * t / (1.0 - t);
    const double area = 12e-3 / ((1.0 - t) * (1.0 - t)) / radii * r * 2.0 * pi / angles;
    std::vector<Eigen::Vector3d> points;
    for (int j = 0; j < angles; ++j)
      points.push_back(foot + r * (std::cos(2.0 * pi * j / angles) * u + std::sin(2.0 * pi * j / angles) * v));
    const std::vector<Eigen::Vector3d> field = flux_density(all, points);
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double across = field[j].dot(normal);
      if (r < 0.1) {
        EXPECT_LT((field[j] - across * normal).norm(), 1e-5 * (field[j].norm() + 1e-4));
      }
      const double pressure = across * across / (2.0 * vacuum_permeability) * area;
      pull += pressure;
      moment += (points[j] - aslant.position).cross(pressure * normal);
    }
  }
  const Forces got = forces(bodies, aslant);
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    force += got.on[i].force;
    torque += got.on[i].torque + (bodies[i].pose.position - aslant.position).cross(got.on[i].force);
  }
  // What the bodies do to each other balances; what is left is the plate's, along its normal. Midpoints leave 1e-5.
  EXPECT_LT((force + pull * normal).norm(), 2e-5 * pull);
  EXPECT_LT((torque + moment).norm(), 2e-5 * 10e-3 * pull);
}

// Above the plate a loop attracts it whatever the sense of its current, and a magnet whatever its direction.
TEST(Plate, AttractsEveryBody) {
  const ThickCoil coil(
      {.inner_radius = 3e-3, .outer_radius = 7e-3, .length = 6e-3, .turns_radial = 8, .turns_axial = 12});
  for (const double current : {5.0, -5.0})
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 0, 1)}) {
      const Body body{.part = DrivenCoil{.coil = coil, .current = current},
                      .pose = {.position = {0, 0, 12e-3}, .axis = axis}};
      EXPECT_LT(forces(std::vector<Body>{body}, plate).on[0].force.z(), 0.0);
    }
}

// Round about the axis of a disc the flux through a circle of the face leaves it along the plate: its largest share of
// the circumference is what the plate carries.
TEST(Plate, CarriesTheFluxThatEntersItsFace) {
  for (const double gap : {0.0, 2e-3}) {
    const std::vector<Body> all = with_images({disc(gap)}, plate);
    double flux = 0.0;
    double most = 0.0;
    constexpr int steps = 4000;
    constexpr double width = 20e-3 / steps;
    for (int i = 0; i < steps; ++i) {
      const double r = (i + 0.5) * width;
      const Eigen::Vector3d point(r, 0.0, 0.0);
      flux += 2.0 * pi * r * width * flux_density(all, {&point, 1}).front().z();
      most = std::max(most, std::abs(flux) / (2.0 * pi * (r + 0.5 * width)));
    }
    const PlateLoad load = plate_load(std::vector<Body>{disc(gap)}, plate);
    EXPECT_NEAR(load.flux_density / (most / plate.thickness), 1.0, 0.01);  // as promised
    EXPECT_NEAR(load.least_thickness * steel_saturation, load.flux_density * plate.thickness, 1e-12);
  }
}

TEST(Plate, ReachesAsFarAsThePull) {
  const double reach = plate_load(std::vector<Body>{disc(0.0)}, plate).reach;
  EXPECT_GT(reach, 6.35e-3);
  EXPECT_LT(reach, 15e-3);
  // Farther away it is all larger.
  EXPECT_GT(plate_load(std::vector<Body>{disc(20e-3)}, plate).reach, 20e-3);
}

TEST(Plate, RefusesBodiesBehindItsFaceAndNumbersThatNoPlateHas) {
  EXPECT_THAT([] { (void)forces(std::vector<Body>{disc(-1e-3)}, plate); },
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::HasSubstr("distance of a body from the plate's face must be >= 0 m; got -0.001")));
  const auto refused = [](const Plate& wrong, const char* why) {
    EXPECT_THAT([&] { check(wrong); }, testing::ThrowsMessage<std::invalid_argument>(why));
  };
  refused({.thickness = 0.0}, "plate thickness must be finite and > 0; got 0");
  refused({.normal = {0, 0, 0}, .thickness = 1e-3}, "plate normal must be finite and not zero; got 0");
  refused({.thickness = 1e-3, .relative_permeability = 0.5}, "plate relative permeability must be >= 1; got 0.5");
}

}  // namespace
}  // namespace coilwright::magnetics
