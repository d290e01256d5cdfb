#include "coilwright/formats/actuator/operating_point_json.hpp"

#include <array>
#include <string>
#include <string_view>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

text::Json to_json(const actuator::OperatingPoint& point) {
  const std::array<std::string_view, 3> cases{"both", "free", "gripping"};
  text::Json out = text::Json::object({{"current_A", point.current}, {"duty", point.duty}});
  if (point.period) out.set("period_s", *point.period);
  out.set("cases", std::string(cases[static_cast<std::size_t>(point.cases)]));
  out.set("wiring", point.supply.wiring == actuator::Wiring::series ? "series" : "parallel");
  out.set("supply_resistance_Ohm", point.supply.resistance);
  if (point.supply.voltage) out.set("supply_voltage_V", *point.supply.voltage);
  out.set("grasp_opening_deg", units::from_memory(point.grasp.opening, "grasp_opening_deg"));
  if (point.grasp.height) out.set("grasp_height_mm", units::from_memory(*point.grasp.height, "grasp_height_mm"));
  return out;
}

}  // namespace coilwright::formats
