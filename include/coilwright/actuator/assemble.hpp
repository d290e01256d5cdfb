#pragma once

#include <variant>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/dimensions.hpp"
#include "coilwright/actuator/design/segments.hpp"
#include "coilwright/actuator/model/model.hpp"

namespace coilwright::actuator {

/// Wire data of one coil.
struct CoilElectrics {
  double resistance{};     ///< at 20 degC, ohm, calibrated
  double inductance{};     ///< H
  double current_limit{};  ///< ampacity of the gauge by the design's choice, A: current_limit()
  double table_limit{};    ///< ampacity of its gauge in the chassis-wiring table, A
  double wire_length{};    ///< m
  double copper_mass{};    ///< kg
};

/// A design that can be built, with all that follows from its geometry.
struct Assembly {
  Model model;
  Dimensions dimensions;
  std::vector<Segment> segments;  ///< base first
  CoilElectrics coil;             ///< every coil alike
  int coils{};
  int magnets{};
  double
      rest_force_per_ampere{};  ///< of the first coil and its magnet, coaxial, at angle 0, N/A, positive for repulsion

  /// All segments with the rear part, kg; wires not counted.
  [[nodiscard]] double mass() const;
};

/// Assembles the model of a design. The same design gives the same bits.
///
/// Every joint between a coil and a magnet gets the torque curve of the chosen fidelity. Magnets act on each other and
/// on further coils along the chain as DistantPair describes. Forces between coils are left out (1.2 % of the
/// coil-magnet force in the prototype, by the paper's figure and by ours).
[[nodiscard]] std::variant<Assembly, ConstructionFaults> assemble(const Design& design);

/// Assembles a design that must be buildable. Throws std::invalid_argument with the first fault.
[[nodiscard]] Assembly assemble_or_throw(const Design& design);

}  // namespace coilwright::actuator
