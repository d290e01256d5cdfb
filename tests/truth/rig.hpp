#pragma once

namespace truth {

/// What is connected to the coils while the command is zero: the driver, nothing, or a wire across each.
enum class CoilState { driven, open, shorted };

/// What is changed on the rig for one run.
struct Rig {
  double base_turn = 0.0;  ///< rad, towards opening
  double tip_mass = 0.0;   ///< kg, a point mass at the tip
  CoilState coil = CoilState::driven;
};

}  // namespace truth
