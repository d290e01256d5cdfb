#include "coilwright/systems/gripper/object.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace coilwright::systems::gripper {
namespace {

void require(bool holds, const char* field, const char* rule, double value, const char* unit) {
  if (!holds) throw std::invalid_argument(fmt::format("object.{} must be {}; got {:.6g}{}", field, rule, value, unit));
}

}  // namespace

std::string_view name_of(ObjectShape shape) {
  switch (shape) {
    case ObjectShape::sphere:
      return "sphere";
    case ObjectShape::cylinder:
      return "cylinder";
    case ObjectShape::box:
      return "box";
  }
  return "";
}

double Object::inertia() const {
  const double radius = 0.5 * width;
  switch (shape) {
    case ObjectShape::sphere:
      return 0.4 * mass * radius * radius;
    case ObjectShape::cylinder:
      return 0.5 * mass * radius * radius;
    case ObjectShape::box:
      return mass * (width * width + height * height) / 12.0;
  }
  return 0.0;
}

void check(const Object& object) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  require(positive(object.width), "width", "finite and > 0", object.width, " m");
  if (object.shape == ObjectShape::box)
    require(positive(object.height), "height", "finite and > 0", object.height, " m");
  require(positive(object.mass), "mass", "finite and > 0", object.mass, " kg");
  require(std::isfinite(object.friction) && object.friction >= 0.0, "friction", "finite and >= 0", object.friction, "");
  for (int axis = 0; axis < 2; ++axis)
    require(std::isfinite(object.centre[axis]), "centre", "finite", object.centre[axis], " m");
}

}  // namespace coilwright::systems::gripper
