#include "coilwright/formats/actuator/operating_point_json.hpp"

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

text::Json to_json(const actuator::OperatingPoint& point) {
  text::Json out = text::Json::object({{"current_A", point.current}, {"duty", point.duty}});
  out.set("grasp_opening_deg", units::from_memory(point.grasp.opening, "grasp_opening_deg"));
  if (point.grasp.height) out.set("grasp_height_mm", units::from_memory(*point.grasp.height, "grasp_height_mm"));
  return out;
}

}  // namespace coilwright::formats
