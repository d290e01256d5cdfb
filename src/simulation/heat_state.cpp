#include "heat_state.hpp"

#include <algorithm>

#include "coilwright/actuator/heat.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::simulation {

Heat heat_of(const actuator::Design& design, const actuator::Assembly& assembly, const OperatingPoint& point,
             const mechanics::JointVector&) {
  const thermal::Network network = actuator::heat_network(design, assembly);
  Heat heat;
  heat.continuous_current = thermal::continuous_current(network, thermal::LimitedParts::coils).current;
  heat.magnet_continuous_current = thermal::continuous_current(network, thermal::LimitedParts::magnets).current;
  heat.runaway_current = thermal::runaway_current(network);
  const double mean_square = thermal::mean_square({.current = point.current, .duty = point.duty});
  thermal::SteadyState state = thermal::steady_state(network, thermal::same_in_every_coil(network, mean_square));
  if (state.outcome == thermal::Outcome::runaway) return heat;
  const auto hottest = [&](thermal::NodeKind kind) {
    double temperature = network.ambient();
    for (Eigen::Index i = 0; i < network.size(); ++i)
      if (network.nodes()[i].kind == kind) temperature = std::max(temperature, state.temperatures[i]);
    return temperature;
  };
  heat.coil_temperature = hottest(thermal::NodeKind::coil);
  heat.magnet_temperature = hottest(thermal::NodeKind::magnet);
  heat.temperatures = state.temperatures;
  return heat;
}

}  // namespace coilwright::simulation
