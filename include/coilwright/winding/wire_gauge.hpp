#pragma once

namespace coilwright::winding {

/// The gauges in the table: AWG 20 (thickest) to AWG 40 (thinnest), every whole number.
inline constexpr int thickest_gauge = 20;
inline constexpr int thinnest_gauge = 40;

/// What a gauge of round enamelled copper wire is, SI.
struct WireGauge {
  /// American wire gauge, dimensionless; larger is thinner.
  int awg{};
  /// Diameter of the bare copper, m: 0.127 mm * 92^((36 - awg) / 39), ASTM B258. Magnet wire is sold to 0.1 mil steps
  /// of this (NEMA MW 1000), at most 1.3 % away (AWG 40).
  double bare_diameter{};
  /// Largest outer diameter over a single build of enamel, m: NEMA MW 1000, single film, maximum overall diameter. A
  /// winding laid out for it is never too large for its mould; the nominal wire is 1.5 to 5 % thinner.
  double insulated_diameter{};
  /// Resistance per length at 20 degC, ohm/m: copper_resistivity over the bare section.
  double resistance_per_length{};
  /// Chassis-wiring current, A: a rule of thumb for single wires in free air (Handbook of Electronic Tables and
  /// Formulas). A coil runs hotter; `thermal` says by how much.
  double chassis_ampacity{};
  /// A law through that table, A: 1.4 A (bare diameter / that of AWG 28)^2.06. The exponent is the least-squares fit of
  /// the logarithms of all 21 rows through AWG 28, whose 1.4 A is the source paper's. The table lies within 6 % of it
  /// from AWG 23 to 28 and from 30 to 38, 9 % above at 29 and 39, 13 % at 40, and 16 to 21 % above at 20 to 22.
  double smooth_ampacity{};

  /// Section of the copper, m2.
  [[nodiscard]] double copper_section() const noexcept;
};

/// The wire of one gauge. Throws std::invalid_argument unless thickest_gauge <= awg <= thinnest_gauge.
[[nodiscard]] WireGauge gauge(int awg);

}  // namespace coilwright::winding
