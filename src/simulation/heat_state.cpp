#include "heat_state.hpp"

#include <algorithm>

#include "coilwright/actuator/heat.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::simulation {

namespace {

// Every case takes its heat paths from here.
thermal::Network network_of(const actuator::Design& design, const actuator::Assembly& assembly,
                            const mechanics::JointVector& /*angles*/) {
  return actuator::heat_network(design, assembly);
}

thermal::SteadyState steady_state_of(const thermal::Network& network, const OperatingPoint& point) {
  const double mean_square = thermal::mean_square({.current = point.current, .duty = point.duty});
  return thermal::steady_state(network, thermal::same_in_every_coil(network, mean_square));
}

}  // namespace

thermal::NodeVector steady_temperatures(const actuator::Design& design, const actuator::Assembly& assembly,
                                        const OperatingPoint& point, const mechanics::JointVector& angles) {
  return steady_state_of(network_of(design, assembly, angles), point).temperatures;
}

Heat heat_of(const actuator::Design& design, const actuator::Assembly& assembly, const OperatingPoint& point,
             const mechanics::JointVector& angles) {
  const thermal::Network network = network_of(design, assembly, angles);
  Heat heat;
  heat.continuous_current = thermal::continuous_current(network, thermal::LimitedParts::coils).current;
  heat.magnet_continuous_current = thermal::continuous_current(network, thermal::LimitedParts::magnets).current;
  heat.runaway_current = thermal::runaway_current(network);
  const thermal::SteadyState state = steady_state_of(network, point);
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
