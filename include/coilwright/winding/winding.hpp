#pragma once

#include "coilwright/winding/packing.hpp"
#include "coilwright/winding/wire.hpp"

namespace coilwright::winding {

/// Smallest inner radius of a winding, in insulated wire diameters. The film of 0.14 to 1.6 mm wire must survive
/// winding on its own diameter (IEC 60317, mandrel test: radius 0.5 d); three times that is our margin for tension,
/// kinks at the crossovers and the finer gauges, whose test is wider. A choice, not a standard.
inline constexpr double smallest_mandrel_radius = 1.5;

/// A thick circular coil of round enamelled copper wire: its turns determine dimensions and electrical data. Immutable.
class Winding {
 public:
  /// Inputs of a Winding. Name every field at the call site.
  struct Spec {
    double inner_radius{};  ///< radius of the bore, m; finite, >= smallest_mandrel_radius insulated diameters
    int turns_radial{};     ///< number of layers; >= 1
    int turns_axial{};      ///< turns in a layer; >= 1
    Wire wire{};            ///< of gauge() or round_wire()
    Packing packing{};      ///< pitches; as the prototype's unless given
  };
  /// Makes the winding. Throws std::invalid_argument naming the field, the rule and the value received.
  explicit Winding(const Spec& spec);

  [[nodiscard]] const Spec& spec() const noexcept { return spec_; }
  [[nodiscard]] const Wire& wire() const noexcept { return spec_.wire; }
  [[nodiscard]] int turns() const noexcept;               ///< all turns
  [[nodiscard]] double axial_pitch() const noexcept;      ///< between turns of a layer, m
  [[nodiscard]] double radial_pitch() const noexcept;     ///< between layers, m
  [[nodiscard]] double inner_radius() const noexcept;     ///< m
  [[nodiscard]] double outer_radius() const noexcept;     ///< m; all wires lie inside it
  [[nodiscard]] double length() const noexcept;           ///< along the axis, m; all wires lie inside it
  [[nodiscard]] double mean_radius() const noexcept;      ///< mean of the inner and the outer radius, m
  [[nodiscard]] double wire_length() const noexcept;      ///< of all turns, m; leads not included
  [[nodiscard]] double copper_mass() const noexcept;      ///< kg; enamel (2 to 4 % more) not included
  [[nodiscard]] double copper_fraction() const noexcept;  ///< copper section of all turns over (outer - inner) * length

  /// Resistance of the whole wire at `temperature` (degC), ohm. See copper_resistance_ratio for range and throws.
  [[nodiscard]] double resistance(double temperature) const;
  /// Self-inductance, H: see `inductance()` of the same section with uniform current density.
  [[nodiscard]] double inductance() const;

 private:
  Spec spec_;
};

/// Space for a winding. Both are lengths in m, > 0; infinity means no limit.
struct Room {
  double outer_radius{};
  double length{};
};

/// Excess of a winding over its space, m: a positive value does not fit, a negative one is the space left.
struct Fit {
  double radial_excess{};
  double axial_excess{};
  /// Whether the winding fits. One that fills its space exactly does, so an excess below a picometre (rounding of the
  /// sums of pitches, far below any tolerance of manufacture) counts as none.
  [[nodiscard]] bool fits() const noexcept { return radial_excess <= 1e-12 && axial_excess <= 1e-12; }
};

/// Compares a winding with a space. It never changes the winding: one that does not fit is infeasible, and the answer
/// says by how much. Throws std::invalid_argument for a space that is not > 0 (infinity is legal).
[[nodiscard]] Fit fit(const Winding& winding, const Room& room);

/// Radius of the wire's centre in layer `layer` (0 is the innermost), m. Throws std::invalid_argument outside
/// 0 <= layer < turns_radial.
[[nodiscard]] double layer_radius(const Winding& winding, int layer);

}  // namespace coilwright::winding
