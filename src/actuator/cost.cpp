#include "coilwright/actuator/cost.hpp"

#include <numbers>

#include "coilwright/winding/winding.hpp"

namespace coilwright::actuator {
namespace {

// What the paper's coil (Table I: 15 layers of 30 turns of AWG 28 on a bore of 3 mm) and magnet are made of, by which
// its prices scale.
double prototype_copper_mass() {
  return winding::Winding({.inner_radius = 3e-3, .turns_radial = 15, .turns_axial = 30, .wire = winding::gauge(28)})
      .copper_mass();
}
constexpr double prototype_magnet_volume = std::numbers::pi * 10e-3 * 10e-3 * 6e-3;  // m^3

}  // namespace

Cost cost_of(const Design& design, const Assembly& assembly) {
  const double magnet_volume = std::numbers::pi * design.magnet.radius * design.magnet.radius * design.magnet.length;
  // The prototype's magnets are N52, which the table's prices are over.
  const double price_ratio = design.magnet.grade == nullptr ? 1.0 : design.magnet.grade->price_ratio;
  return {.silicone_and_moulds = 2.5,
          .coils = 1.0 * assembly.coils * assembly.coil.copper_mass / prototype_copper_mass(),
          .magnets = 3.0 * assembly.magnets * price_ratio * magnet_volume / prototype_magnet_volume,
          .wires = 0.5};
}

double gripper_cost(double finger_cost, int fingers) {
  return fingers * finger_cost + driver_and_supply_cost;
}

}  // namespace coilwright::actuator
