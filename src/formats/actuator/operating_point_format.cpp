#include <fmt/format.h>

#include <string>
#include <utility>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/actuator/choice_words.hpp"

namespace coilwright::formats {

using namespace text;

namespace {

void read_heat_and_supply(ObjectReader& in, actuator::OperatingPoint& point) {
  if (const auto period = in.find("period_s")) point.period = period->number(positive);
  point.cases = choice_or(in, "cases", point.cases, cases_words);
  point.supply.wiring = choice_or(in, "wiring", point.supply.wiring, wiring_words);
  point.supply.resistance = in.number_or("supply_resistance_Ohm", point.supply.resistance, non_negative);
  if (const auto voltage = in.find("supply_voltage_V")) point.supply.voltage = voltage->number(positive);
}

}  // namespace

void read_operating_conditions(ObjectReader& in, actuator::OperatingPoint& point) {
  point.duty = in.number_or("duty", point.duty, Rule::between(0.0, 1.0));
  point.grasp.opening = in.quantity_or("grasp_opening_deg", point.grasp.opening, Rule::between(0.0, 360.0));
  if (const auto height = in.optional_quantity("grasp_height_mm", Rule::between(0.0, 1e6))) point.grasp.height = height;
  read_heat_and_supply(in, point);
}

actuator::OperatingPoint read_operating_point(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    actuator::OperatingPoint point{.current = in.number("current_A", current_rule)};
    read_operating_conditions(in, point);
    return point;
  });
}

actuator::OperatingPoint operating_point_of(const ActuatorFile& file, const OperatingWords& said,
                                            const std::string& who, const std::string& cure) {
  const auto refuse = [&](std::string rule) { return InputError({.file = who, .rule = std::move(rule)}); };
  const auto take = [&](auto& place, std::string_view name, const std::optional<double>& value, const Rule& rule) {
    if (!value) return;
    if (!rule.allows(*value))
      throw InputError(
          {.file = who, .place = std::string(name), .rule = rule.text(), .value = fmt::format("{}", *value)});
    place = units::to_memory(*value, name);
  };
  if (!said.current && !file.operating_point) throw refuse("has no operating_point: " + cure);
  actuator::OperatingPoint point = file.operating_point.value_or(actuator::OperatingPoint{});
  take(point.current, "current", said.current, current_rule);
  take(point.duty, "duty", said.duty, Rule::between(0.0, 1.0));
  take(point.grasp.opening, "grasp_opening_deg", said.grasp_opening, Rule::between(0.0, 360.0));
  take(point.grasp.height, "grasp_height_mm", said.grasp_height, Rule::between(0.0, 1e6));
  take(point.supply.resistance, "supply_resistance", said.supply_resistance, non_negative);
  take(point.supply.voltage, "supply_voltage", said.supply_voltage, positive);
  point.supply.wiring = said.wiring.value_or(point.supply.wiring);
  const auto* design = std::get_if<actuator::Design>(&file.content);
  if (point.supply.voltage && design == nullptr)
    throw refuse("is a lumped model, whose coils have no resistance: leave the voltage of the supply out");
  if (point.supply.wiring == actuator::Wiring::series && design != nullptr && !has_one_current(*design))
    throw refuse("wiring must be parallel: the coils have shares of the current, and in series there is one");
  return point;
}

Json to_json(const actuator::OperatingPoint& point) {
  Json out = Json::object({{"current_A", point.current}, {"duty", point.duty}});
  if (point.period) out.set("period_s", *point.period);
  out.set("cases", word_for(cases_words, point.cases));
  out.set("wiring", word_for(wiring_words, point.supply.wiring));
  out.set("supply_resistance_Ohm", point.supply.resistance);
  if (point.supply.voltage) out.set("supply_voltage_V", *point.supply.voltage);
  out.set(Json::quantity("grasp_opening_deg", point.grasp.opening));
  if (point.grasp.height) out.set(Json::quantity("grasp_height_mm", *point.grasp.height));
  return out;
}

}  // namespace coilwright::formats
