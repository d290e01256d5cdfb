#include "coilwright/simulation/supply.hpp"

#include <fmt/format.h>

#include <cmath>

#include "electrics.hpp"

namespace coilwright::simulation {

const ResultQuantity& supply_load() {
  static const ResultQuantity load{
      .name = "supply_load",
      .meaning = "voltage that the supply needs, coils hot, over the voltage that it has",
      .scale = 1.0,
      .value = [](const DesignView& design) -> std::optional<double> {
        static const ResultQuantity needed = standard_quantities().at("supply_voltage_V");
        const std::optional<double> voltage = needed.value(design);
        if (!voltage || !design.point.supply.voltage) return std::nullopt;
        return *voltage / *design.point.supply.voltage;
      },
      .absence = "the operating point states no supply voltage, or is beyond the current that has a steady temperature",
      .in_every_use = true};
  return load;
}

std::optional<double> driven_cold(const actuator::Assembly& assembly, const actuator::Supply& supply) {
  return electrics_at(assembly, {.supply = supply}, thermal::NodeVector::Constant(assembly.coils, 20.0)).driven_current;
}

std::string supply_text(const std::optional<double>& most, double current) {
  if (!most || std::abs(current) <= *most) return {};
  return fmt::format(
      "the supply of the actuator's operating_point drives {:.4g} A in every coil at most, coils at 20 degC, and not "
      "{:.4g} A: "
      "what is computed is not reached with it",
      *most, std::abs(current));
}

}  // namespace coilwright::simulation
