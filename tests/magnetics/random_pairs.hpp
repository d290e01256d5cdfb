#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "random_draw.hpp"

// Random coils, magnets and poses such as a geometry search meets, from a fixed seed.
namespace coilwright::magnetics::random_pairs {

using random_draw::Generator;
using random_draw::log_uniform;
using random_draw::uniform;

inline ThickCoil coil(Generator& random, CurrentDistribution winding) {
  const double inner = log_uniform(random, 0.5e-3, 15e-3);
  const int layers = 1 + static_cast<int>(random() % 40);
  return ThickCoil({.inner_radius = inner,
                    .outer_radius = inner + log_uniform(random, 0.2e-3, 15e-3),
                    .length = log_uniform(random, 1e-3, 40e-3),
                    .turns_radial = layers,
                    .turns_axial = 1 + static_cast<int>(random() % 60),
                    .winding = winding});
}

inline CylinderMagnet magnet(Generator& random) {
  return CylinderMagnet({.radius = log_uniform(random, 0.5e-3, 20e-3),
                         .length = log_uniform(random, 0.5e-3, 30e-3),
                         .remanence = uniform(random, 0.8, 1.5)});
}

inline Eigen::Vector3d direction(Generator& random) {
  const double z = uniform(random, -1.0, 1.0);
  const double phi = uniform(random, 0.0, 2.0 * std::numbers::pi);
  const double rho = std::sqrt(1.0 - z * z);
  return Eigen::Vector3d(rho * std::cos(phi), rho * std::sin(phi), z);
}

/// Distance from a point to the copper, 0 inside it.
inline double to_coil(const ThickCoil& c, const Eigen::Vector3d& p) {
  const double rho = std::hypot(p.x(), p.y());
  const double across = std::max({c.inner_radius() - rho, rho - c.outer_radius(), 0.0});
  const double along = std::max(std::abs(p.z()) - 0.5 * c.length(), 0.0);
  return std::hypot(across, along);
}

/// Distance of copper and magnet by sampling the magnet's surface, good to a few per cent of the magnet's size.
inline double clearance(const ThickCoil& c, const CylinderMagnet& m, const Pose& pose) {
  const Eigen::Vector3d n = pose.axis.normalized();
  const Eigen::Vector3d e1 = n.unitOrthogonal();
  const Eigen::Vector3d e2 = n.cross(e1);
  double least = 1e300;
  constexpr int round = 48;
  constexpr int along = 12;
  for (int j = 0; j < round; ++j) {
    const double phi = 2.0 * std::numbers::pi * j / round;
    const Eigen::Vector3d rim = std::cos(phi) * e1 + std::sin(phi) * e2;
    for (int i = 0; i <= along; ++i) {
      const double z = m.length() * (static_cast<double>(i) / along - 0.5);
      least = std::min(least, to_coil(c, pose.position + m.radius() * rim + z * n));
      const double rho = m.radius() * i / along;
      for (const double end : {-0.5, 0.5})
        least = std::min(least, to_coil(c, pose.position + rho * rim + end * m.length() * n));
    }
  }
  return least;
}

/// A pose at about the given clearance: the magnet comes from far away along a random line through a random point
/// near the coil's centre until it is that near.
inline Pose pose_at_clearance(Generator& random, const ThickCoil& c, const CylinderMagnet& m, double gap) {
  Pose pose;
  pose.axis = direction(random);
  const Eigen::Vector3d from = direction(random);
  const Eigen::Vector3d aim = 0.7 * c.outer_radius() * direction(random);
  double far = 2.0 * (c.outer_radius() + c.length() + m.radius() + m.length() + gap);
  const double step = 0.02 * far;
  const auto at = [&](double t) {
    pose.position = aim + t * from;
    return clearance(c, m, pose);
  };
  while (far > 0.0 && at(far - step) > gap) far -= step;
  double near = far - step;
  for (int i = 0; i < 40 && far > 0.0; ++i) {
    const double middle = 0.5 * (near + far);
    (at(middle) > gap ? far : near) = middle;
  }
  at(far);
  return pose;
}

}  // namespace coilwright::magnetics::random_pairs
