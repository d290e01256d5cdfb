#include "coilwright/actuator/cost.hpp"

#include <numbers>

namespace coilwright::actuator {
namespace {

// What the paper's coil and magnet are made of, by which its prices scale.
constexpr double prototype_copper_mass = 12.82e-3;                                   // kg
constexpr double prototype_magnet_volume = std::numbers::pi * 10e-3 * 10e-3 * 6e-3;  // m^3

}  // namespace

Cost cost_of(const Design& design, const Assembly& assembly) {
  const double magnet_volume = std::numbers::pi * design.magnet.radius * design.magnet.radius * design.magnet.length;
  return {.silicone_and_moulds = 2.5,
          .coils = 1.0 * assembly.coils * assembly.coil.copper_mass / prototype_copper_mass,
          .magnets = 3.0 * assembly.magnets * magnet_volume / prototype_magnet_volume,
          .wires = 0.5};
}

}  // namespace coilwright::actuator
