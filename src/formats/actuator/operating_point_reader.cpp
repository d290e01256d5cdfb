#include "formats/actuator/operating_point_reader.hpp"

namespace coilwright::formats {

using namespace text;

Rule current_rule() {
  return Rule::between(-1e6, 1e6);
}

void read_operating_conditions(ObjectReader& in, actuator::OperatingPoint& point) {
  point.duty = in.number_or("duty", point.duty, Rule::between(0.0, 1.0));
  point.grasp.opening = in.quantity_or("grasp_opening_deg", point.grasp.opening, Rule::between(0.0, 360.0));
  if (const auto height = in.optional_quantity("grasp_height_mm", Rule::between(0.0, 1e6))) point.grasp.height = height;
}

actuator::OperatingPoint read_operating_point(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    actuator::OperatingPoint point{.current = in.number("current_A", current_rule())};
    read_operating_conditions(in, point);
    return point;
  });
}

}  // namespace coilwright::formats
