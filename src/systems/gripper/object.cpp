#include "coilwright/systems/gripper/object.hpp"

#include "systems/check.hpp"

namespace coilwright::systems::gripper {

double Object::inertia() const {
  const double radius = 0.5 * width;
  switch (shape) {
    case ObjectShape::sphere:
      return 0.4 * mass * radius * radius;
    case ObjectShape::cylinder:
      return 0.5 * mass * radius * radius;
    case ObjectShape::box:
      return mass * (width * width + height * height) / 12.0;
    case ObjectShape::upright_cylinder:
      return mass * (3.0 * radius * radius + height * height) / 12.0;
  }
  return 0.0;
}

void check(const Object& object) {
  require(object.width > 0.0, "object.width", "finite and > 0", object.width, "m");
  if (object.has_flat_sides()) require(object.height > 0.0, "object.height", "finite and > 0", object.height, "m");
  require(object.mass > 0.0, "object.mass", "finite and > 0", object.mass, "kg");
  require(object.friction >= 0.0, "object.friction", "finite and >= 0", object.friction);
  for (int axis = 0; axis < 2; ++axis) require(true, "object.centre", "finite", object.centre[axis], "m");
}

}  // namespace coilwright::systems::gripper
