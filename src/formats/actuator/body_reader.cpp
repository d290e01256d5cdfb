#include "formats/actuator/body_reader.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string_view>

#include "coilwright/units/unit.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using magnetics::Body;
using magnetics::Cuboid;
using magnetics::DrivenCoil;
using magnetics::Magnet;
using magnetics::Plate;
using magnetics::Pose;
using magnetics::Ring;

// Bounds far beyond any hardware, and near enough that nothing computed from the numbers overflows.
constexpr Rule coordinate = Rule::between(-1e6, 1e6);  // mm
constexpr Rule component = Rule::between(-1e6, 1e6);   // of a direction
constexpr double shortest_direction = 1e-6;
// As far as a part may be from the plate's face by rounding, m.
constexpr double touching = 1e-9;

Eigen::Vector3d vector_of(const std::array<double, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

Eigen::Vector3d read_direction(const Node& node) {
  Eigen::Vector3d direction = vector_of(node.vector(component));
  if (direction.norm() < shortest_direction)
    throw node.error_without_value(fmt::format("must be at least {} long, to give a direction", shortest_direction));
  return direction;
}

Eigen::Vector3d direction_or(ObjectReader& in, std::string_view key, const Eigen::Vector3d& otherwise) {
  const auto node = in.find(key);
  return node ? read_direction(*node) : otherwise;
}

Eigen::Vector3d position_or_origin(ObjectReader& in) {
  return in.find("position_mm") ? vector_of(in.vector("position_mm", coordinate)) : Eigen::Vector3d::Zero();
}

void read_x_axis(ObjectReader& in, Pose& pose) {
  const auto node = in.find("x_axis");
  if (!node) return;
  pose.x_axis = read_direction(*node);
  // Of the axis' own direction it has no part across.
  if (pose.axis.normalized().cross(pose.x_axis.normalized()).norm() < shortest_direction)
    throw node->error_without_value("must not lie along \"axis\"");
}

double read_ring_radius(ObjectReader& in, double inner) {
  const double outer = in.quantity("outer_radius_mm", outer_dimension);
  if (is_thinner_than_any(outer - inner))
    throw in.at("outer_radius_mm")
        .error(fmt::format("must exceed inner_radius_mm ({}) by at least {}", in.number("inner_radius_mm"),
                           part_dimension.lower()));
  return outer;
}

magnetics::Shape read_shape(ObjectReader& in) {
  if (in.find_in_any_unit("size_mm")) return Cuboid{.size = vector_of(in.vector("size_mm", part_dimension))};
  if (in.find_in_any_unit("inner_radius_mm") || in.find_in_any_unit("outer_radius_mm")) {
    const double inner = in.quantity("inner_radius_mm", part_dimension);
    return Ring{.inner_radius = inner,
                .outer_radius = read_ring_radius(in, inner),
                .length = in.quantity("length_mm", part_dimension)};
  }
  return Ring{.inner_radius = 0.0,
              .outer_radius = in.quantity("radius_mm", part_dimension),
              .length = in.quantity("length_mm", part_dimension)};
}

}  // namespace

Magnet read_magnet(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    Magnet magnet{.shape = read_shape(in)};
    const double remanence = in.quantity("remanence_T", design_remanence);
    magnet.remanence = remanence * direction_or(in, "magnetised_along", Eigen::Vector3d::UnitZ()).normalized();
    magnet.recoil_permeability = in.number_or("recoil_permeability", 1.0, recoil_rule);
    return magnet;
  });
}

Pose read_pose(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    Pose pose{.position = vector_of(in.vector("position_mm", coordinate))};
    pose.axis = direction_or(in, "axis", pose.axis);
    read_x_axis(in, pose);
    return pose;
  });
}

NamedBody read_body(const Node& node, bool posed_here) {
  return read_object(node, [posed_here](ObjectReader& in) {
    const std::string name = in.name();
    const Pose unmoved;
    const bool is_coil = in.one_of({"coil", "magnet"}) == "coil";
    Body body = is_coil
                    ? Body{.part = DrivenCoil{.coil = magnetics::ThickCoil(read_coil(in.at("coil"), read_winding(in))),
                                              .current = in.quantity("current_A", current_rule)}}
                    : Body{.part = read_magnet(in.at("magnet"))};
    if (posed_here) {
      body.pose.position = position_or_origin(in);
      body.pose.axis = direction_or(in, "axis", unmoved.axis);
      read_x_axis(in, body.pose);
    }
    return NamedBody{.name = name, .body = body};
  });
}

std::string usual_name(const Body& body, std::size_t index) {
  return fmt::format("{} {}", std::holds_alternative<DrivenCoil>(body.part) ? "coil" : "magnet", index + 1);
}

PlateContent read_plate(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    constexpr double least_permeability = 50.0;  // below it a mirror is 4 % weaker than iron's, and no soft iron is
    PlateContent content;
    Plate& plate = content.plate;
    plate.position = position_or_origin(in);
    plate.normal = direction_or(in, "normal", plate.normal);
    plate.thickness = in.quantity("thickness_mm", part_dimension);
    if (const auto permeability = in.optional_number("relative_permeability", Rule::between(least_permeability, 1e6)))
      plate.relative_permeability = *permeability;
    content.radius = in.optional_quantity("radius_mm", part_dimension);
    return content;
  });
}

void require_in_front(const Node& node, const Plate& plate, std::span<const Body> bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (const double distance = magnetics::distance_from(plate, bodies[i]); distance < -touching)
      throw node.error_without_value(
          fmt::format("must have every body in front of its face, on the side to which \"normal\" points; {} reaches "
                      "{:.6g} mm behind it",
                      usual_name(bodies[i], i), units::from_si(-distance, "distance_mm")));
}

}  // namespace coilwright::formats
