#include "coilwright/magnetics/plate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/magnetics/field.hpp"
#include "magnetics/gauss_legendre.hpp"
#include "magnetics/require.hpp"

namespace coilwright::magnetics {
namespace {

constexpr int depths = 24;   // points of an integral over the depth
constexpr int squares = 20;  // points along a side of the grid on which the worst is looked for
constexpr double little = 0.01;

using FloorPoints = std::vector<Eigen::Vector3d>;

double strength(const Plate& plate) {
  const double mu = plate.relative_permeability;
  return std::isinf(mu) ? 1.0 : (mu - 1.0) / (mu + 1.0);
}

// Half of what a body measures along a direction.
double reach_of(const Body& body, const Eigen::Vector3d& direction) {
  return half_extent(shape_of(body), rotation_of(body.pose).transpose() * direction);
}

/// The face with coordinates u and v, and the part of it that bodies are in front of.
struct Floor {
  Eigen::Vector3d origin;
  Eigen::Vector3d u;
  Eigen::Vector3d v;
  Eigen::Vector3d normal;
  double half{};  // m, of a square about the origin with the feet of all bodies

  Floor(std::span<const Body> bodies, const Plate& plate) : origin(0, 0, 0), normal(plate.normal.normalized()) {
    u = normal.unitOrthogonal();
    v = normal.cross(u);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Body& body : bodies) middle += body.pose.position / static_cast<double>(bodies.size());
    origin = middle - normal.dot(middle - plate.position) * normal;
    for (const Body& body : bodies)
      for (const Eigen::Vector3d& side : {u, v})
        half = std::max(half, std::abs(side.dot(body.pose.position - origin)) + reach_of(body, side) +
                                  std::max(distance_from(plate, body), 0.0));
  }
  [[nodiscard]] Eigen::Vector3d at(double x, double y) const { return origin + x * u + y * v; }
};

// Flux along the plate per width, T m, at each of some points of its face.
std::vector<double> carried(std::span<const Body> bodies, const Floor& floor, const FloorPoints& points) {
  const QuadratureRule rule = gauss_legendre(depths);
  FloorPoints below;
  below.reserve(points.size() * depths);
  std::array<double, depths> weight{};
  for (int k = 0; k < depths; ++k) {
    // z = s t / (1 - t), t from 0 to 1: at depth the field goes as 1 / z^3 or faster.
    const double t = 0.5 * (1.0 + rule.node[k]);
    weight[k] = rule.weight[k] * floor.half / ((1.0 - t) * (1.0 - t));
    for (const Eigen::Vector3d& point : points) below.push_back(point - floor.half * t / (1.0 - t) * floor.normal);
  }
  const FloorPoints field = flux_density(bodies, below);
  FloorPoints sum(points.size(), Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < depths; ++k)
    for (std::size_t i = 0; i < points.size(); ++i) sum[i] += 2.0 * weight[k] * field[k * points.size() + i];
  std::vector<double> out;
  out.reserve(points.size());
  for (const Eigen::Vector3d& each : sum) out.push_back((each - each.dot(floor.normal) * floor.normal).norm());
  return out;
}

double most_carried(std::span<const Body> bodies, const Floor& floor) {
  double x = 0.0;
  double y = 0.0;
  double most = 0.0;
  // The whole square, then twice the neighbourhood of the worst point.
  for (double half = floor.half; half > 0.02 * floor.half; half *= 2.0 / squares) {
    FloorPoints points;
    for (int i = 0; i <= squares; ++i)
      for (int j = 0; j <= squares; ++j)
        points.push_back(floor.at(x + half * (2.0 * i / squares - 1.0), y + half * (2.0 * j / squares - 1.0)));
    const std::vector<double> flux = carried(bodies, floor, points);
    const auto worst = std::ranges::max_element(flux);
    most = std::max(most, *worst);
    const Eigen::Vector3d place = points[static_cast<std::size_t>(worst - flux.begin())] - floor.origin;
    x = floor.u.dot(place);
    y = floor.v.dot(place);
  }
  return most;
}

// Radius about the origin that holds all but a hundredth of the pull, by the pressure B_n^2 / (2 mu0) on the face.
double reach_of_pull(std::span<const Body> bodies, const Floor& floor) {
  constexpr int radii = 120;
  constexpr int angles = 32;
  FloorPoints points;
  std::vector<double> radius;
  std::vector<double> width;
  for (int i = 0; i < radii; ++i) {
    const double t = (i + 0.5) / radii;
    radius.push_back(floor.half * t / (1.0 - t));
    width.push_back(floor.half / ((1.0 - t) * (1.0 - t)));
    for (int j = 0; j < angles; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / angles;
      points.push_back(floor.at(radius.back() * std::cos(angle), radius.back() * std::sin(angle)));
    }
  }
  const FloorPoints field = flux_density(bodies, points);
  std::vector<double> within;
  double sum = 0.0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    for (std::size_t j = 0; j < angles; ++j) {
      const double across = floor.normal.dot(field[angles * i + j]);
      sum += across * across * radius[i] * width[i];
    }
    within.push_back(sum);
  }
  const auto last = std::ranges::lower_bound(within, (1.0 - little) * sum);
  return radius[static_cast<std::size_t>(last - within.begin())];
}

}  // namespace

void check(const Plate& plate) {
  require(plate.position.allFinite(), "plate position", "finite", plate.position.norm());
  require(plate.normal.allFinite() && plate.normal.norm() > 0.0, "plate normal", "finite and not zero",
          plate.normal.norm());
  require_positive("plate thickness", plate.thickness);
  require(plate.relative_permeability >= 1.0, "plate relative permeability", ">= 1", plate.relative_permeability);
}

Body image_of(const Body& body, const Plate& plate) {
  check(plate);
  const Eigen::Vector3d normal = plate.normal.normalized();
  const auto turned = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(2.0 * normal.dot(v) * normal - v); };
  const Eigen::Matrix3d axes = rotation_of(body.pose);
  Body image = body;
  image.pose = {.position = body.pose.position - 2.0 * normal.dot(body.pose.position - plate.position) * normal,
                .axis = turned(axes.col(2)),
                .x_axis = turned(axes.col(0))};
  if (auto* coil = std::get_if<DrivenCoil>(&image.part))
    coil->current *= strength(plate);
  else
    std::get<Magnet>(image.part).remanence *= strength(plate);
  return image;
}

double distance_from(const Plate& plate, const Body& body) {
  const Eigen::Vector3d normal = plate.normal.normalized();
  return normal.dot(body.pose.position - plate.position) - reach_of(body, normal);
}

PlateLoad plate_load(std::span<const Body> bodies, const Plate& plate) {
  check(plate);
  const Floor floor(bodies, plate);
  const double most = most_carried(bodies, floor);
  return {.flux_density = most / plate.thickness,
          .least_thickness = most / steel_saturation,
          .reach = reach_of_pull(bodies, floor)};
}

}  // namespace coilwright::magnetics
