#pragma once

namespace coilwright::winding {

/// The bare copper that is sold as one gauge of magnet wire, m.
struct BareDiameters {
  double least{};
  double largest{};
};

/// Limits of NEMA MW 1000 for the bare diameter of a gauge: 1 % either way of AWG 20 and 28, 3 % of AWG 40. The
/// diameter of ASTM B258 (WireGauge::bare_diameter) lies between them. Throws std::invalid_argument unless
/// thickest_gauge <= awg
/// <= thinnest_gauge.
[[nodiscard]] BareDiameters bare_diameters(int awg);

/// What a resistance of wire of this gauge may be over that of its WireGauge::bare_diameter, by the wire alone.
struct ResistanceRange {
  double least{};    ///< < 1, of the thickest wire
  double largest{};  ///< > 1, of the thinnest
};

/// By the inverse squares of bare_diameters(). Throws as that.
[[nodiscard]] ResistanceRange resistance_range(int awg);

}  // namespace coilwright::winding
