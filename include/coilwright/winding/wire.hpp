#pragma once

#include <optional>
#include <string>

namespace coilwright::winding {

/// The gauges that name a wire: AWG 10 (thickest) to AWG 50 (thinnest), every whole number.
inline constexpr int thickest_gauge = 10;
inline constexpr int thinnest_gauge = 50;

/// Bare diameters within IEC 60317-0-1, m, and every diameter between.
inline constexpr double least_bare_diameter = 0.018e-3;
inline constexpr double largest_bare_diameter = 5e-3;

/// Thickness of the enamel: the grades of IEC 60317-0-1; for a gauge the single and heavy builds of NEMA MW 1000, which
/// are about as thick.
enum class Enamel { grade_1, grade_2 };

/// A round enamelled copper wire, SI: a bare diameter, an overall diameter, and what follows from them.
struct Wire {
  std::optional<int> awg{};        ///< the American gauge, if the wire was named by it
  std::optional<Enamel> enamel{};  ///< absent if the overall diameter was given by itself
  double bare_diameter{};          ///< of the copper, nominal, m
  /// Largest diameter over the enamel that the standard allows, m. A winding designed for it is never too large for its
  /// mould; the nominal wire is 1.5 to 5 % thinner.
  double insulated_diameter{};
  double least_bare{};             ///< least diameter of the copper as it is sold, m
  double largest_bare{};           ///< largest diameter of the copper as it is sold, m
  double resistance_per_length{};  ///< at 20 degC, ohm/m: copper_resistivity over the bare section
  /// Chassis-wiring current, A: a rule of thumb for single wires in free air (Handbook of Electronic Tables and
  /// Formulas, AWG 10 to 40); between two gauges and beyond AWG 40 by the slope of the table's logarithms. A coil runs
  /// hotter; `thermal` computes by how much.
  double chassis_ampacity{};
  /// A law through that table, A: 1.4 A (bare diameter / that of AWG 28)^2.06 up to AWG 20, whose exponent is the
  /// least-squares fit of the logarithms of its 21 rows through AWG 28 with the source paper's 1.4 A; beyond AWG 20
  /// with the exponent 1.63, fitted likewise to the rows of AWG 10 to 19 through the first law's end. The table lies
  /// within 6 % of it from AWG 23 to 28 and from 30 to 38, 9 % above at 29 and 39, 13 % at 40, 9 to 23 % above from 14
  /// to 22, and 1 to 12 % below from 10 to 13.
  double smooth_ampacity{};

  /// Section of the copper, m2.
  [[nodiscard]] double copper_section() const noexcept;
  /// The name under which a person orders the wire: "AWG 28", "0.25 mm".
  [[nodiscard]] std::string name() const;
  /// The name of its enamel: "single build" for a gauge, "grade 1" for a diameter, "0.3 mm over the enamel" for
  /// neither.
  [[nodiscard]] std::string enamel_name() const;
};

/// The wire of an American gauge: bare 0.127 mm * 92^((36 - awg) / 39) (ASTM B258; magnet wire is sold to 0.1 mil steps
/// of this, at most 1.3 % away, AWG 40). The largest overall diameter and the limits of the copper are those of NEMA MW
/// 1000 as makers print them: single build AWG 14 to 40, heavy build AWG 24 to 40, copper AWG 10 to 40. For other
/// gauges they are those of round_wire() of that diameter. Where both exist, these are within 1.4 % of NEMA's single
/// build, and compared with the heavy build 0.5 % above to 0.7 % below it from AWG 24 to 30, and up to 3.3 % below it
/// from AWG 31 to 40; so a heavy build beyond AWG 40 may be as much too thin. Throws std::invalid_argument unless
/// thickest_gauge <= awg <= thinnest_gauge.
[[nodiscard]] Wire gauge(int awg, Enamel enamel = Enamel::grade_1);

/// The wire of a bare diameter, m. The largest overall diameter is that of IEC 60317-0-1, whose increase over the
/// copper is taken as a power of the diameter between two nominal sizes (within 1 um of the table's steps). The copper
/// is within the standard's limits: 1 % from 0.56 mm on, 3 um at 0.1 mm, and below 0.063 mm the 5 % that correspond to
/// 10 % of resistance (the standard has 8 % of resistance at 0.063 mm, 9 % at 0.05, 10 % at 0.04, as makers print it).
/// Throws std::invalid_argument unless least_bare_diameter <= bare_diameter <= largest_bare_diameter.
[[nodiscard]] Wire round_wire(double bare_diameter, Enamel enamel = Enamel::grade_1);

/// The same wire under an enamel of another grade, with the largest overall diameter `insulated_diameter`, m:
/// self-bonding or measured wire. Throws std::invalid_argument unless that is finite and above the largest copper.
[[nodiscard]] Wire with_overall_diameter(Wire wire, double insulated_diameter);

/// Range of a wire's resistance over that of its nominal diameter, from the tolerance of the wire alone.
struct ResistanceRange {
  double least{};    ///< < 1, of the thickest wire
  double largest{};  ///< > 1, of the thinnest
};

/// Computes the range by the inverse squares of the bare diameters as sold.
[[nodiscard]] ResistanceRange resistance_range(const Wire& wire) noexcept;

}  // namespace coilwright::winding
