#include "coilwright/magnetics/forces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>

#include "coilwright/magnetics/constants.hpp"
#include "magnetics/charged_faces.hpp"
#include "magnetics/parallel_cuboids.hpp"
#include "magnetics/require.hpp"
#include "magnetics/sheet_wrench.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {
namespace {

void add_to(Wrench& total, const Wrench& part) {
  total.force += part.force;
  total.torque += part.torque;
}

/// What acts back about the centre of the body that the wrench comes from, `arm` away from the one it acts on.
Wrench reaction(const Wrench& wrench, const Eigen::Vector3d& arm) {
  return {.force = -wrench.force, .torque = -wrench.torque - arm.cross(wrench.force)};
}

/// A coil or a full cylinder with its magnetisation along its axis, as wrench() takes them.
struct Cylinder {
  CylinderMagnet magnet;
  double sense;  // -1 where it is magnetised against its axis
};
using Plain = std::variant<std::monostate, DrivenCoil, Cylinder>;

Plain plain(const Body& body) {
  if (const auto* coil = std::get_if<DrivenCoil>(&body.part)) return *coil;
  const auto& magnet = std::get<Magnet>(body.part);
  const auto* ring = std::get_if<Ring>(&magnet.shape);
  const double remanence = magnet.remanence.z();
  if (ring == nullptr || ring->inner_radius > 0.0 || remanence == 0.0 || !is_axial(body)) return {};
  return Cylinder{.magnet = CylinderMagnet({.radius = ring->outer_radius,
                                            .length = ring->length,
                                            .remanence = std::abs(remanence),
                                            .recoil_permeability = magnet.recoil_permeability}),
                  .sense = std::copysign(1.0, remanence)};
}

/// An axial body as sheets: those of a ring are its outer and its inner side.
std::vector<SheetBody> sheets_of(const Body& body) {
  if (const auto* coil = std::get_if<DrivenCoil>(&body.part)) return {sheets_of(coil->coil, coil->current)};
  const auto& magnet = std::get<Magnet>(body.part);
  const auto& ring = std::get<Ring>(magnet.shape);
  const double current = polarisation_of(magnet).z() / vacuum_permeability;
  std::vector<SheetBody> out;
  for (const double radius : {ring.outer_radius, ring.inner_radius})
    if (radius > 0.0)
      out.push_back({.inner_radius = radius,
                     .outer_radius = radius,
                     .half_length = 0.5 * ring.length,
                     .surface_current = radius == ring.outer_radius ? current : -current,
                     .shells = 1,
                     .spread = Spread::shells});
  return out;
}

/// On the second body, in the first one's axes.
Wrench wrench_of_axial(const Body& first, const Body& second, const Pose& pose) {
  const Plain one = plain(first);
  const Plain other = plain(second);
  if (const auto* coil = std::get_if<DrivenCoil>(&one)) {
    if (const auto* next = std::get_if<DrivenCoil>(&other))
      return wrench(coil->coil, coil->current, next->coil, next->current, pose);
    if (const auto* magnet = std::get_if<Cylinder>(&other))
      return wrench(coil->coil, magnet->sense * coil->current, magnet->magnet, pose);
  }
  Wrench total;
  if (const auto* magnet = std::get_if<Cylinder>(&one))
    if (const auto* next = std::get_if<Cylinder>(&other)) {
      total = wrench(magnet->magnet, next->magnet, pose);
      total.force *= magnet->sense * next->sense;
      total.torque *= magnet->sense * next->sense;
      return total;
    }
  for (const SheetBody& from : sheets_of(first))
    for (const SheetBody& to : sheets_of(second)) add_to(total, wrench_of_sheets(from, to, pose));
  return total;
}

/// Half a diagonal of a magnet; of a coil, which has no faces to integrate over, more than any.
double half_diagonal(const Body& body) {
  if (std::holds_alternative<DrivenCoil>(body.part)) return std::numeric_limits<double>::infinity();
  const Shape shape = shape_of(body);
  return Eigen::Vector3d(half_extent(shape, Eigen::Vector3d::UnitX()), half_extent(shape, Eigen::Vector3d::UnitY()),
                         half_extent(shape, Eigen::Vector3d::UnitZ()))
      .norm();
}

/// On the second body about its centre, in the axes of both poses.
EstimatedWrench action(const Body& first, const Body& second) {
  const Eigen::Vector3d arm = second.pose.position - first.pose.position;
  if (is_axial(first) && is_axial(second)) {
    // wrench() has the coil first.
    if (std::holds_alternative<DrivenCoil>(second.part) && !std::holds_alternative<DrivenCoil>(first.part))
      return {.wrench = reaction(action(second, first).wrench, -arm)};
    const Wrench seen = wrench_of_axial(first, second, seen_from(first.pose, second.pose));
    const Eigen::Matrix3d axes = rotation_of(first.pose);
    // Also the sign of a zero stays where nothing is turned.
    if (axes == Eigen::Matrix3d::Identity()) return {.wrench = seen};
    return {.wrench = {.force = axes * seen.force, .torque = axes * seen.torque}};
  }
  if (const auto closed = wrench_of_parallel_cuboids(first, second)) return *closed;
  // The smaller magnet's faces: where bodies touch, fewer edges of the other one lie in them.
  if (half_diagonal(first) < half_diagonal(second)) {
    EstimatedWrench back = wrench_on_faces(second, std::get<Magnet>(first.part), first.pose);
    back.wrench = reaction(back.wrench, -arm);
    return back;
  }
  return wrench_on_faces(first, std::get<Magnet>(second.part), second.pose);
}

}  // namespace

bool is_axial(const Body& body) {
  const auto* magnet = std::get_if<Magnet>(&body.part);
  return magnet == nullptr ||
         (std::holds_alternative<Ring>(magnet->shape) && magnet->remanence.x() == 0.0 && magnet->remanence.y() == 0.0);
}

Forces forces(std::span<const Body> bodies, const std::optional<Plate>& plate) {
  for (const Body& body : bodies) check(body);
  const std::size_t count = bodies.size();
  Forces out{.on = std::vector<Wrench>(count), .by = {count, std::vector<Wrench>(count)}, .by_plate = {}, .error = 0.0};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      const EstimatedWrench on_second = action(bodies[i], bodies[j]);
      out.by[j][i] = on_second.wrench;
      out.by[i][j] = reaction(on_second.wrench, bodies[j].pose.position - bodies[i].pose.position);
      out.error = std::max(out.error, on_second.error);
    }
  for (std::size_t i = 0; i < count; ++i) {
    // From the first one on, and not from 0, so that the sign of a zero stays.
    for (std::size_t j = 0, parts = 0; j < count; ++j) {
      if (j == i) continue;
      if (parts++ == 0)
        out.on[i] = out.by[i][j];
      else
        add_to(out.on[i], out.by[i][j]);
    }
  }
  if (!plate) return out;
  out.by_plate.resize(count);
  for (const Body& body : bodies) {
    require(distance_from(*plate, body) >= -1e-9, "distance of a body from the plate's face", ">= 0 m",
            distance_from(*plate, body));
    const Body image = image_of(body, *plate);
    for (std::size_t i = 0; i < count; ++i) {
      const EstimatedWrench part = action(image, bodies[i]);
      add_to(out.by_plate[i], part.wrench);
      out.error = std::max(out.error, part.error);
    }
  }
  for (std::size_t i = 0; i < count; ++i) add_to(out.on[i], out.by_plate[i]);
  return out;
}

}  // namespace coilwright::magnetics
