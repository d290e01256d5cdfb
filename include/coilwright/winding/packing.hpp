#pragma once

namespace coilwright::winding {

/// Density of the turns, as pitches in units of the insulated wire diameter; dimensionless.
///
/// Wires are circles in the winding's section: turns of a layer are `axial` diameters apart, layers `radial` diameters.
/// Below radial = 1 a layer sinks into the grooves of the one beneath, which moves it aside by half an axial pitch; the
/// winding is then longer by that half pitch.
class Packing {
 public:
  /// Inputs of a Packing.
  struct Spec {
    double axial{};   ///< pitch of turns in a layer, insulated diameters; finite, >= 1 (wires do not overlap)
    double radial{};  ///< pitch of layers, insulated diameters; finite, >= max(1/2, sqrt(1 - axial^2 / 4))
  };
  /// Makes the packing. Throws std::invalid_argument naming the field, the rule and the value received.
  explicit Packing(const Spec& spec);
  /// The prototype's packing: see `prototype()`.
  Packing();

  /// The packing of the prototype finger: 30 turns on 12 mm and 15 layers in 6.5 mm of AWG 28 wire, so 0.400 mm and
  /// 0.4333 mm against an insulated diameter of 0.3556 mm. It was measured on one hand-made coil, and is the default,
  /// because nobody has wound a tighter one.
  [[nodiscard]] static Packing prototype();
  /// The densest packing: turns touch and every layer lies in the grooves of the one below. Axial 1, radial sqrt(3)/2.
  [[nodiscard]] static Packing orthocyclic();
  /// Turns touch and lie on top of each other: axial 1, radial 1.
  [[nodiscard]] static Packing square();

  [[nodiscard]] double axial() const noexcept { return spec_.axial; }    ///< insulated diameters
  [[nodiscard]] double radial() const noexcept { return spec_.radial; }  ///< insulated diameters
  /// Whether layers sink into each other's grooves (radial < 1).
  [[nodiscard]] bool nested() const noexcept { return spec_.radial < 1.0; }

 private:
  Spec spec_;
};

}  // namespace coilwright::winding
