#include "heat_state.hpp"

#include <algorithm>
#include <cmath>

#include "coilwright/actuator/heat.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "coilwright/thermal/transient.hpp"
#include "electrics.hpp"

namespace coilwright::simulation {
namespace {

double hottest(const thermal::Network& network, const thermal::NodeVector& temperatures, thermal::NodeKind kind) {
  double temperature = network.ambient();
  for (Eigen::Index i = 0; i < network.size(); ++i)
    if (network.nodes()[static_cast<std::size_t>(i)].kind == kind) temperature = std::max(temperature, temperatures[i]);
  return temperature;
}

thermal::NodeVector of_coils(const thermal::Network& network, const thermal::NodeVector& temperatures) {
  thermal::NodeVector coils(network.size());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < network.size(); ++i)
    if (network.nodes()[static_cast<std::size_t>(i)].kind == thermal::NodeKind::coil) coils[count++] = temperatures[i];
  return coils.head(count);
}

// From the steady state of `holding` until a part is at its limit under `current`, A; nothing if it never is.
std::optional<double> time_until_limit(const thermal::Network& network, const thermal::CurrentLimits& limits,
                                       double holding, double current) {
  const double allowed = limits.for_good();
  if (current <= allowed) return std::nullopt;
  if (holding >= allowed) return 0.0;
  const auto reached = thermal::time_to_limit(network, {.holding_current = holding, .overload_current = current});
  return reached ? std::optional<double>(reached->time) : std::nullopt;
}

// On and off about the mean: what a coil on its own takes up in the time that it is on. An upper bound.
std::optional<double> ripple_of(const OperatingPoint& point, const thermal::Network& network, const Electrics& hot) {
  if (!point.period) return std::nullopt;
  // All coils store alike, and the one with the largest share is heated most.
  const auto& nodes = network.nodes();
  const auto coil = std::max_element(nodes.begin(), nodes.end(), [](const thermal::Node& a, const thermal::Node& b) {
    const auto heated = [](const thermal::Node& node) {
      return node.kind == thermal::NodeKind::coil ? std::abs(node.current_share) : -1.0;
    };
    return heated(a) < heated(b);
  });
  const double current = point.current * coil->current_share;
  const double power = current * current * *hot.resistance;
  return power * point.duty * (1.0 - point.duty) * *point.period / coil->heat_capacity;
}

thermal::SteadyState steady_state_of(const thermal::Network& network, const OperatingPoint& point) {
  const double mean_square = thermal::mean_square({.current = point.current, .duty = point.duty});
  return thermal::steady_state(network, thermal::same_in_every_coil(network, mean_square));
}

}  // namespace

thermal::NodeVector steady_temperatures(const actuator::Design& design, const actuator::Assembly& assembly,
                                        const OperatingPoint& point, const mechanics::JointVector& angles) {
  const thermal::NodeVector all = steady_state_of(actuator::heat_network(design, assembly, angles), point).temperatures;
  return all.size() == 0 ? all : thermal::NodeVector(all.head(static_cast<Eigen::Index>(design.layout.size())));
}

Heat heat_of(const actuator::Design& design, const actuator::Assembly& assembly, const OperatingPoint& point,
             const mechanics::JointVector& joint_angles) {
  const thermal::Network network = actuator::heat_network(design, assembly, joint_angles);
  const thermal::CurrentLimits limits = thermal::current_limits(network);
  const thermal::CurrentLimits still =
      design.choices.film == actuator::FilmChoice::still_air
          ? limits
          : thermal::current_limits(actuator::still_air_network(design, assembly, joint_angles));
  const double mean_square = thermal::mean_square({.current = point.current, .duty = point.duty});
  Heat heat{.continuous_current = limits.coils,
            .magnet_continuous_current = limits.magnets,
            .runaway_current = limits.runaway,
            .still_air_current = still.for_good()};
  const double current = std::abs(point.current);
  heat.time_to_limit = time_until_limit(network, limits, 0.0, current);
  heat.time_to_limit_warm = time_until_limit(network, limits, std::sqrt(mean_square), current);
  const thermal::SteadyState state = steady_state_of(network, point);
  if (state.outcome == thermal::Outcome::runaway) return heat;
  heat.coil_temperature = hottest(network, state.temperatures, thermal::NodeKind::coil);
  heat.coil_hot_spot = hottest(network, state.hot_spots, thermal::NodeKind::coil);
  heat.magnet_temperature = hottest(network, state.temperatures, thermal::NodeKind::magnet);
  heat.skin_temperature = actuator::skin_temperature(design, assembly, joint_angles, state.temperatures);
  heat.temperatures = state.temperatures.head(static_cast<Eigen::Index>(design.layout.size()));
  heat.electrics = electrics_at(assembly, point, of_coils(network, state.temperatures));
  heat.ripple = ripple_of(point, network, heat.electrics);
  return heat;
}

}  // namespace coilwright::simulation
