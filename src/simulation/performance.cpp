#include "coilwright/simulation/performance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "coilwright/actuator/cost.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "electrics.hpp"
#include "motion.hpp"
#include "warm_state.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Assembly;
using actuator::Design;

// Current by which the force of the coil that carries most is worked out, A; of like ones the first.
double force_current(const actuator::Model& model, const mechanics::JointVector& rest, double current) {
  Eigen::Index most = 0;
  (void)model.current_shares().cwiseAbs().maxCoeff(&most);
  const actuator::CoilCurrents currents = model.all_coils(current);
  return model.has_terms() ? held_at_rest(model, rest).strength(rest, currents)[most] : currents[most];
}

// The worse of the two cases; nothing where one runs away, or where the magnets' coercivity is not known.
std::optional<actuator::Demagnetisation> demagnetisation_of(const Design& design, const Assembly& assembly,
                                                            const OperatingPoint& point, const Performance& cases) {
  const thermal::NodeVector& free = cases.free.heat.temperatures;
  const thermal::NodeVector& gripping = cases.gripping.heat.temperatures;
  if (!design.magnet.has_coercivity() || free.size() == 0 || gripping.size() == 0) return std::nullopt;
  const actuator::InnerFields fields(design, assembly);
  const auto at = [&](const thermal::NodeVector& temperatures) {
    return fields.demagnetisation({temperatures.data(), static_cast<std::size_t>(temperatures.size())}, point.current);
  };
  const actuator::Demagnetisation one = at(free);
  const actuator::Demagnetisation other = at(gripping);
  return actuator::Demagnetisation{.margin = std::min(one.margin, other.margin),
                                   .margin_worst_point = std::min(one.margin_worst_point, other.margin_worst_point),
                                   .irreversible_loss = std::max(one.irreversible_loss, other.irreversible_loss)};
}

// Why there is no motion, and that heat forbids the current anyway where it does: who asks for milliamperes in amperes
// is told what the actuator can bear.
NoPerformance with_heat(NoPerformance reason, const Design& design, const Assembly& assembly,
                        const OperatingPoint& point) {
  const auto straight = mechanics::JointVector::Zero(assembly.model.joints());
  const double bearable = thermal::runaway_current(actuator::heat_network(design, assembly, straight));
  const double current = std::abs(point.current) * std::sqrt(point.duty);
  if (!std::isfinite(current) || current <= bearable) return reason;
  return {fmt::format("{}; beyond {:.3g} A there is no steady temperature either", reason.reason, bearable)};
}

}  // namespace

std::variant<Performance, NoPerformance> performance_of(const Design& design, const Assembly& assembly,
                                                        const OperatingPoint& point) {
  if (point.supply.wiring == actuator::Wiring::series && !has_one_current(design))
    return NoPerformance{
        "coils in series carry one current: shares of it need a driver for each coil (wiring parallel)"};
  std::variant<MotionSummary, NoPerformance> motion = motion_of(assembly.model, point.current, point.grasp);
  if (const auto* reason = std::get_if<NoPerformance>(&motion)) return with_heat(*reason, design, assembly, point);
  Performance out;
  out.cold = std::get<MotionSummary>(std::move(motion));
  std::variant<FreeCase, NoPerformance> free = free_case(design, assembly, point, out.cold);
  if (const auto* reason = std::get_if<NoPerformance>(&free)) return *reason;
  out.free = std::get<FreeCase>(std::move(free));
  std::variant<GrippingCase, NoPerformance> gripping = gripping_case(design, assembly, point, out.cold);
  if (const auto* reason = std::get_if<NoPerformance>(&gripping)) return *reason;
  out.gripping = std::get<GrippingCase>(std::move(gripping));
  out.demagnetisation = demagnetisation_of(design, assembly, point, out);
  out.axial_force = force_current(assembly.model, out.cold.rest_angles, point.current) * assembly.rest_force_per_ampere;
  out.mass = assembly.mass();
  out.coil_resistance = assembly.coil.resistance;
  out.inductance = assembly.coil.inductance;
  out.electrics_cold = electrics_at(assembly, point, thermal::NodeVector::Constant(assembly.coils, 20.0));
  out.current_limit = assembly.coil.current_limit;
  out.table_limit = assembly.coil.table_limit;
  out.cost = actuator::cost_of(design, assembly).total();
  return out;
}

}  // namespace coilwright::simulation
