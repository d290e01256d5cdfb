#pragma once

namespace coilwright::mechanics {

/// The bottom layer of silicone that joins two segments.
struct HingeStrip {
  double width{};   ///< across the finger, m; > 0
  double height{};  ///< thickness of the bottom layer h_b, m; > 0
  double length{};  ///< length that bends, along the finger, m; > 0
};

/// Young's modulus of a rubber of Shore A hardness, Pa, for 20 <= shore_a <= 80.
/// Source: A. N. Gent, Rubber Chem. Technol. 31 (1958) 896; about 10 to 20 % from measured moduli of silicones.
/// Throws std::invalid_argument outside that range.
[[nodiscard]] double young_modulus_from_shore_a(double shore_a);

/// Bending stiffness E w h^3 / (12 L) of the strip as one rotary joint, N m/rad: a beam of constant curvature.
/// Holds while L bends uniformly and the strain h theta / (2 L) stays small (a few tenths for silicone): the
/// prototype's strip reaches 0.5 at 1 rad, which is why its L and not its E is calibrated. Throws std::invalid_argument
/// naming field, rule and value.
[[nodiscard]] double hinge_stiffness(const HingeStrip& strip, double young_modulus);

}  // namespace coilwright::mechanics
