#include "electrics.hpp"

#include <cmath>

#include "coilwright/winding/copper.hpp"

namespace coilwright::simulation {

Electrics electrics_at(const actuator::Assembly& assembly, const OperatingPoint& point,
                       const thermal::NodeVector& coil_temperatures) {
  const double current = std::abs(point.current);
  const actuator::Supply& supply = point.supply;
  const thermal::NodeVector resistances =
      (assembly.coil.resistance * (1.0 + winding::copper_temperature_coefficient * (coil_temperatures.array() - 20.0)))
          .matrix();
  const double hottest = resistances.maxCoeff();
  const double all = resistances.sum();
  const bool series = supply.wiring == actuator::Wiring::series;
  // Ohm's law of the circuit per current of one coil: in parallel the supply carries that of every coil.
  const double circuit =
      series ? all + supply.resistance : hottest + static_cast<double>(resistances.size()) * supply.resistance;
  Electrics out{.resistance = hottest,
                .voltage = current * hottest,
                .power = current * current * all,
                .supply_voltage = current * circuit,
                .supply_current = series ? current : current * static_cast<double>(resistances.size())};
  if (supply.voltage) out.driven_current = *supply.voltage / circuit;
  return out;
}

}  // namespace coilwright::simulation
