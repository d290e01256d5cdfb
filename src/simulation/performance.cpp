#include "coilwright/simulation/performance.hpp"

#include <cmath>
#include <utility>

#include "coilwright/actuator/cost.hpp"
#include "heat_state.hpp"
#include "motion.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Assembly;
using actuator::Design;

// Current by which the first coil's force is worked out, A.
double force_current(const actuator::Model& model, const mechanics::JointVector& rest, double current) {
  if (!model.has_terms()) return current;
  return held_at_rest(model, rest).strength(rest, model.all_coils(current))[0];
}

}  // namespace

std::variant<Performance, NoPerformance> performance_of(const Design& design, const Assembly& assembly,
                                                        const OperatingPoint& point) {
  std::variant<MotionSummary, NoPerformance> motion = motion_of(assembly.model, point.current, point.grasp);
  if (const auto* reason = std::get_if<NoPerformance>(&motion)) return *reason;
  Performance out;
  out.cold = std::get<MotionSummary>(std::move(motion));
  out.free = {.heat = heat_of(design, assembly, point, out.cold.steady_angles), .motion = out.cold};
  out.gripping = {.heat = heat_of(design, assembly, point, out.cold.grasp_angles), .grasp = out.cold};
  out.axial_force = force_current(assembly.model, out.cold.rest_angles, point.current) * assembly.rest_force_per_ampere;
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
