#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// Price of what one actuator is made of, US$: the paper's Table III, which lists one gripper of two fingers.
struct Cost {
  double silicone_and_moulds{};  ///< 5 a gripper: 2.50 a finger; not scaled, the moulds dominate
  double coils{};                ///< 4 a gripper of four coils: 1.00 each, scaled with copper mass
  double magnets{};  ///< 6 a gripper of two magnets: 3.00 each (N52), scaled with volume and the grade's price
  double wires{};    ///< 1 a gripper: 0.50 a finger

  /// Sum of all parts, US$.
  [[nodiscard]] double total() const { return silicone_and_moulds + coils + magnets + wires; }
};

/// Driver board (8) and power supply (20), US$, bought once for all fingers.
inline constexpr double driver_and_supply_cost = 28.0;

/// Price of the pneumatic gripper of two fingers with which the paper compares its own, US$: the other column of its
/// Table III. It does not depend on the design. A compressor and a regulator can serve more fingers, too.
struct PneumaticGripperCost {
  double silicone_and_moulds = 5.0;
  double hoses = 2.0;
  double pressure_regulator = 450.0;  ///< FESTO VEAB
  double compressor = 150.0;          ///< 4 l

  /// Sum of all parts, US$.
  [[nodiscard]] double total() const { return silicone_and_moulds + hoses + pressure_regulator + compressor; }
};

/// Price of a gripper of `fingers` such fingers with driver and supply, US$.
[[nodiscard]] double gripper_cost(double finger_cost, int fingers = 2);

[[nodiscard]] Cost cost_of(const Design& design, const Assembly& assembly);

}  // namespace coilwright::actuator
