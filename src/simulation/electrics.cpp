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
  // Shares of the operating current: 1 each on one driver, otherwise each coil has a driver of its own.
  const thermal::NodeVector shares = assembly.model.current_shares().cwiseAbs();
  const double hottest = resistances.maxCoeff();
  const double largest = shares.cwiseProduct(resistances).maxCoeff();
  const double all = shares.cwiseAbs2().cwiseProduct(resistances).sum();
  const bool series = supply.wiring == actuator::Wiring::series;
  // Ohm's law of the circuit per operating current: in parallel the supply carries that of every coil.
  const double circuit = series ? all + supply.resistance : largest + shares.sum() * supply.resistance;
  Electrics out{.resistance = hottest,
                .voltage = current * largest,
                .power = current * current * all,
                .supply_voltage = current * circuit,
                .supply_current = series ? current : current * shares.sum()};
  if (supply.voltage) out.driven_current = *supply.voltage / circuit;
  return out;
}

}  // namespace coilwright::simulation
