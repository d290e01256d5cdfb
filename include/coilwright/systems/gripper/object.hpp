#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

namespace coilwright::systems::gripper {

/// Shape of an object in the plane in which two fingers close.
enum class ObjectShape {
  sphere,
  cylinder,  ///< a cylinder whose axis lies across the plane
  box,
  upright_cylinder  ///< a cup: its axis is that of the gripper
};

/// The words of the shapes.
inline constexpr std::array<std::string_view, 4> shape_words{"sphere", "cylinder", "box", "upright_cylinder"};
/// The word of a shape.
[[nodiscard]] constexpr std::string_view name_of(ObjectShape shape) {
  return shape_words[static_cast<std::size_t>(shape)];
}

/// An object for a gripper: rigid, and moved only in the plane of the fingers.
struct Object {
  ObjectShape shape = ObjectShape::sphere;
  double width{};     ///< between the fingers: diameter, or width of a box, m; finite, > 0
  double height{};    ///< of a box or an upright cylinder, m; finite, > 0; not read for the other shapes
  double mass{};      ///< kg; finite, > 0
  double friction{};  ///< coefficient against the fingers' silicone; finite, >= 0
  /// Centre in the gripper's frame, m: x from the middle between the fingers, y upwards from the line through both base
  /// joints, below zero for an object below the palm.
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();

  /// Whether its section in the plane is a rectangle instead of a circle.
  [[nodiscard]] bool has_flat_sides() const {
    return shape == ObjectShape::box || shape == ObjectShape::upright_cylinder;
  }
  /// Whether it is rotationally symmetric about the gripper's axis, so that more than two fingers can hold it alike.
  [[nodiscard]] bool is_round_about_the_axis() const {
    return (shape == ObjectShape::sphere || shape == ObjectShape::upright_cylinder) && centre.x() == 0.0;
  }
  /// Half its height, m.
  [[nodiscard]] double half_height() const { return 0.5 * (has_flat_sides() ? height : width); }
  /// Moment of inertia about its centre in the plane, for a homogeneous body, kg m^2.
  [[nodiscard]] double inertia() const;
};

/// Throws std::invalid_argument naming the field, its rule and its value.
void check(const Object& object);

}  // namespace coilwright::systems::gripper
