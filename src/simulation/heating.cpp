#include "coilwright/simulation/heating.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coilwright/actuator/heat.hpp"
#include "coilwright/thermal/transient.hpp"

namespace coilwright::simulation {
namespace {

constexpr double above_limit = 100.0;  // K: enough to see where it goes

// Whether a component is so far above its limit that nothing further is worth showing.
bool is_far_too_hot(const thermal::Network& network, const thermal::NodeVector& hot_spots, Eigen::Index components) {
  for (Eigen::Index i = 0; i < components; ++i)
    if (hot_spots[i] > network.nodes()[static_cast<std::size_t>(i)].temperature_limit + above_limit) return true;
  return false;
}

}  // namespace

Heating heating(const EvaluatedDesign& evaluated, std::size_t samples) {
  if (samples < 2) throw std::invalid_argument(fmt::format("samples must be at least 2; got {}", samples));
  const Performance& performance = evaluated.performance;
  const mechanics::JointVector& angles =
      performance.free.motion ? performance.free.motion->steady_angles : performance.cold.steady_angles;
  const thermal::Network network = actuator::heat_network(evaluated.design, evaluated.assembly, angles);
  const double mean_square = thermal::mean_square({.current = evaluated.point.current, .duty = evaluated.point.duty});
  const thermal::Transient transient(network,
                                     {.mean_square_currents = thermal::same_in_every_coil(network, mean_square),
                                      .initial = thermal::NodeVector::Constant(network.size(), network.ambient())});
  const double slowest = transient.rates()[0];
  const double fastest = transient.rates()[network.size() - 1];
  const auto components = static_cast<Eigen::Index>(evaluated.design.layout.size());
  const double first = 0.01 / fastest;
  const double last = slowest > 0.0 ? 5.0 / slowest : 1e3 / std::abs(slowest);
  Heating out{.runaway = !(slowest > 0.0)};
  for (std::size_t i = 0; i < samples; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(samples - 1);
    const double time = i == 0 ? 0.0 : first * std::pow(last / first, share);
    const thermal::NodeVector means = transient.temperatures(time);
    const thermal::NodeVector hot_spots = network.hot_spots(means);
    out.times.push_back(time);
    out.means.emplace_back(means.head(components));
    out.hot_spots.emplace_back(hot_spots.head(components));
    if (out.runaway && is_far_too_hot(network, hot_spots, components)) break;
  }
  return out;
}

}  // namespace coilwright::simulation
