#include "coilwright/simulation/performance.hpp"

#include <algorithm>
#include <cmath>

#include "coilwright/actuator/cost.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/simulation/blocked_grasp.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/step_response.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Assembly;
using actuator::Design;

Heat heat_of(const Design& design, const Assembly& assembly, const OperatingPoint& point) {
  const thermal::Network network = actuator::heat_network(design, assembly);
  Heat heat;
  heat.continuous_current = thermal::continuous_current(network, thermal::LimitedParts::coils).current;
  heat.magnet_continuous_current = thermal::continuous_current(network, thermal::LimitedParts::magnets).current;
  heat.runaway_current = thermal::runaway_current(network);
  const double mean_square = thermal::mean_square({.current = point.current, .duty = point.duty});
  const thermal::SteadyState state = thermal::steady_state(network, thermal::same_in_every_coil(network, mean_square));
  if (state.outcome == thermal::Outcome::runaway) return heat;
  const auto hottest = [&](thermal::NodeKind kind) {
    double temperature = network.ambient();
    for (Eigen::Index i = 0; i < network.size(); ++i)
      if (network.nodes()[i].kind == kind) temperature = std::max(temperature, state.temperatures[i]);
    return temperature;
  };
  heat.coil_temperature = hottest(thermal::NodeKind::coil);
  heat.magnet_temperature = hottest(thermal::NodeKind::magnet);
  return heat;
}

// As it hangs at rest, for good.
actuator::Model cold(const actuator::Model& model, const mechanics::JointVector& rest) {
  return model.with_slow_states_held(model.settled(rest, model.all_coils(0.0)));
}

// Current by which the first coil's force is worked out, A.
double force_current(const actuator::Model& model, const mechanics::JointVector& rest, double current) {
  if (!model.has_terms()) return current;
  return cold(model, rest).strength(rest, model.all_coils(current))[0];
}

// What a model does from `motion.rest_angles` on. Slow effects are held: a cold actuator's step.
std::variant<MotionSummary, NoPerformance> driven(const actuator::Model& model, double current, MotionSummary out) {
  const actuator::CoilCurrents off = model.all_coils(0.0);
  const actuator::CoilCurrents on = model.all_coils(current);
  const auto step = step_response(model, on, out.rest_angles);
  if (!step) return NoPerformance{"the step from rest does not settle: a joint folds, or it rings beyond 60 s"};
  out.steady_angles = step->steady_angles;
  out.peak_bending_speed = step->peak_speed;
  out.peak_speed_time = step->peak_speed_time;
  out.overshoot = step->overshoot;
  out.rise_time = step->rise_time;
  out.settling_time = step->settling_time;
  out.modes = modes(model, out.steady_angles, on);

  const auto grasp = blocked_grasp(model, on);
  const auto idle = blocked_grasp(model, off);
  if (!grasp || !idle) return NoPerformance{"no equilibrium with the tip against a wall"};
  out.grasp_force = grasp->force;
  out.grasp_angles = grasp->angles;
  out.contact_force_no_current = idle->force;
  return out;
}

}  // namespace

std::variant<MotionSummary, NoPerformance> motion_of(const actuator::Model& model, double current) {
  if (!std::isfinite(current)) return NoPerformance{"the current is not finite"};
  const actuator::CoilCurrents off = model.all_coils(0.0);
  MotionSummary out;

  const auto rest = find_equilibrium(model, off, mechanics::JointVector::Zero(model.joints()));
  if (!rest) return NoPerformance{"no stable rest pose: a joint folds without current"};
  out.rest_angles = *rest;
  if (!model.has_slow_states()) return driven(model, current, std::move(out));
  return driven(cold(model, *rest), current, std::move(out));
}

std::variant<Performance, NoPerformance> performance_of(const Design& design, const Assembly& assembly,
                                                        const OperatingPoint& point) {
  std::variant<MotionSummary, NoPerformance> motion = motion_of(assembly.model, point.current);
  if (const auto* reason = std::get_if<NoPerformance>(&motion)) return *reason;
  Performance out;
  out.motion = std::get<MotionSummary>(std::move(motion));
  out.heat = heat_of(design, assembly, point);
  out.axial_force =
      force_current(assembly.model, out.motion.rest_angles, point.current) * assembly.rest_force_per_ampere;
  out.mass = assembly.mass();
  out.coil_resistance = assembly.coil.resistance;
  out.inductance = assembly.coil.inductance;
  out.voltage = std::abs(point.current) * out.coil_resistance;
  out.power = assembly.coils * point.current * point.current * out.coil_resistance;
  out.current_limit = assembly.coil.current_limit;
  out.cost = actuator::cost_of(design, assembly).total();
  return out;
}

}  // namespace coilwright::simulation
