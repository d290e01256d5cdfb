#include "formats/actuator/operating_point_reader.hpp"

namespace coilwright::formats {

using namespace text;

namespace {

void read_heat_and_supply(ObjectReader& in, actuator::OperatingPoint& point) {
  if (const auto period = in.find("period_s")) point.period = period->number(positive);
  if (const auto cases = in.find("cases"))
    point.cases = cases->choice<actuator::HeldCases>({{"both", actuator::HeldCases::both},
                                                      {"free", actuator::HeldCases::free},
                                                      {"gripping", actuator::HeldCases::gripping}});
  if (const auto wiring = in.find("wiring"))
    point.supply.wiring = wiring->choice<actuator::Wiring>(
        {{"parallel", actuator::Wiring::parallel}, {"series", actuator::Wiring::series}});
  point.supply.resistance = in.number_or("supply_resistance_Ohm", point.supply.resistance, non_negative);
  if (const auto voltage = in.find("supply_voltage_V")) point.supply.voltage = voltage->number(positive);
}

}  // namespace

Rule current_rule() {
  return Rule::between(-1e6, 1e6);
}

void read_operating_conditions(ObjectReader& in, actuator::OperatingPoint& point) {
  point.duty = in.number_or("duty", point.duty, Rule::between(0.0, 1.0));
  point.grasp.opening = in.quantity_or("grasp_opening_deg", point.grasp.opening, Rule::between(0.0, 360.0));
  if (const auto height = in.optional_quantity("grasp_height_mm", Rule::between(0.0, 1e6))) point.grasp.height = height;
  read_heat_and_supply(in, point);
}

actuator::OperatingPoint read_operating_point(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    actuator::OperatingPoint point{.current = in.number("current_A", current_rule())};
    read_operating_conditions(in, point);
    return point;
  });
}

}  // namespace coilwright::formats
