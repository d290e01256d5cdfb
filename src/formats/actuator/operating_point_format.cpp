#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/actuator_reader.hpp"

namespace coilwright::formats {

using namespace text;

void read_operating_conditions(ObjectReader& in, actuator::OperatingPoint& point) {
  point = read_rows(in, std::span(operating_rows).subspan(1), point);
}

actuator::OperatingPoint read_operating_point(const Node& node) {
  return read_object(node, [](ObjectReader& in) { return read_rows(in, operating_rows, actuator::OperatingPoint{}); });
}

actuator::OperatingPoint operating_point_of(const ActuatorFile& file, const OperatingWords& said,
                                            const std::string& who, const std::string& cure) {
  const auto refuse = [&](std::string rule) { return InputError({.file = who, .rule = std::move(rule)}); };
  actuator::OperatingPoint point = file.operating_point.value_or(actuator::OperatingPoint{});
  // A word of Python has the unit of the key where that is no plain one of SI.
  const auto take = [&](std::string_view word, std::string_view key, const std::optional<double>& value) {
    if (!value) return;
    const auto& row = *std::ranges::find(operating_rows, key, &RowFacts::key);
    if (!row.rule.allows(*value))
      throw InputError(
          {.file = who, .place = std::string(word), .rule = row.rule.text(), .value = fmt::format("{}", *value)});
    row.set(point, units::to_memory(*value, key));
  };
  if (!said.current && !file.operating_point) throw refuse("has no operating_point: " + cure);
  take("current", "current_A", said.current);
  take("duty", "duty", said.duty);
  take("grasp_opening_deg", "grasp_opening_deg", said.grasp_opening);
  take("grasp_height_mm", "grasp_height_mm", said.grasp_height);
  take("supply_resistance", "supply_resistance_Ohm", said.supply_resistance);
  take("supply_voltage", "supply_voltage_V", said.supply_voltage);
  point.supply.wiring = said.wiring.value_or(point.supply.wiring);
  const auto* design = std::get_if<actuator::Design>(&file.content);
  if (point.supply.voltage && design == nullptr)
    throw refuse("is a lumped model, whose coils have no resistance: leave the voltage of the supply out");
  if (point.supply.wiring == actuator::Wiring::series && design != nullptr && !has_one_current(*design))
    throw refuse("wiring must be parallel: the coils have shares of the current, and in series there is one");
  return point;
}

Json to_json(const actuator::OperatingPoint& point) {
  return rows_json(point, operating_rows);
}

}  // namespace coilwright::formats
