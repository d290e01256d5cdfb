#include "coilwright/winding/wire.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "coilwright/winding/copper.hpp"

namespace coilwright::winding {
namespace {

constexpr double mil = 25.4e-6;  // a thousandth of an inch, m: the unit of American wire tables
constexpr double micron = 1e-6;  // m
constexpr double millimetre = 1e-3;

// A gauge in the American tables, diameters in mils; 0: no such film in the standard, or no source for it. Largest
// overall diameters of NEMA MW 1000: single film AWG 14 to 40 by Centelsa's catalogue of magnet wire, AWG 24 to 40 by
// Elektrisola too; heavy film AWG 24 to 40 by Elektrisola. Copper, NEMA's limits of today: Centelsa, AWG 24 to 40
// Elektrisola too. An older handbook has 1 % above the nominal up to AWG 26, where NEMA now has half of that. Ampacity:
// chassis wiring, Handbook of Electronic Tables and Formulas (as printed by PowerStream). See
// tests/data/winding_SOURCES.md.
struct GaugeRow {
  double single;
  double heavy;
  double least_bare;
  double largest_bare;
  double ampacity;
};

constexpr int last_in_tables = 40;
constexpr std::array<GaugeRow, last_in_tables - thickest_gauge + 1> gauge_rows{{
    {0.0, 0.0, 100.9, 102.4, 55.0}, {0.0, 0.0, 89.8, 91.2, 47.0},  {0.0, 0.0, 80.0, 81.2, 41.0},   // 10
    {0.0, 0.0, 71.3, 72.4, 35.0},   {66.6, 0.0, 63.5, 64.4, 32.0}, {59.4, 0.0, 56.5, 57.4, 28.0},  // 13
    {53.1, 0.0, 50.3, 51.1, 22.0},  {47.5, 0.0, 44.8, 45.5, 19.0}, {42.4, 0.0, 39.9, 40.5, 16.0},  // 16
    {37.9, 0.0, 35.5, 36.1, 14.0},  {33.9, 0.0, 31.7, 32.2, 11.0}, {30.3, 0.0, 28.2, 28.6, 9.0},   // 19
    {27.0, 0.0, 25.0, 25.4, 7.0},   {24.3, 0.0, 22.4, 22.7, 4.7},  {21.7, 22.7, 19.9, 20.2, 3.5},  // 22
    {19.4, 20.3, 17.7, 18.0, 2.7},  {17.3, 18.2, 15.7, 16.0, 2.2}, {15.6, 16.4, 14.1, 14.3, 1.7},  // 25
    {14.0, 14.7, 12.5, 12.7, 1.4},  {12.6, 13.3, 11.2, 11.4, 1.2}, {11.2, 11.9, 9.9, 10.1, 0.86},  // 28
    {10.0, 10.8, 8.8, 9.0, 0.7},    {9.1, 9.8, 7.9, 8.1, 0.53},    {8.1, 8.8, 7.0, 7.2, 0.43},     // 31
    {7.2, 7.8, 6.2, 6.4, 0.33},     {6.4, 7.0, 5.5, 5.7, 0.27},    {5.8, 6.3, 4.9, 5.1, 0.21},     // 34
    {5.2, 5.7, 4.4, 4.6, 0.17},     {4.7, 5.1, 3.9, 4.1, 0.13},    {4.1, 4.5, 3.4, 3.6, 0.11},     // 37
    {3.7, 4.0, 3.0, 3.2, 0.09},                                                                    // 40
}};

// A nominal size of IEC 60317-0-1: bare diameter, by how much the largest overall diameter exceeds it in either grade,
// and the tolerance of the copper; in um. Makers print each (0.18 mm grade 1 was not read); tolerances by Trans Wire,
// which has 50 um at 4.5 mm. The standard limits the resistance of those below 67 um, to 10 % or less either way: 5 %
// of the diameter. Row by row in tests/data/winding_SOURCES.md.
struct NominalSize {
  double bare;
  double grade_1;
  double grade_2;
  double tolerance;
};
constexpr std::array nominal_sizes{
    NominalSize{18, 4, 6, 0.9},       NominalSize{20, 4, 7, 1.0},       NominalSize{22, 5, 8, 1.1},
    NominalSize{25, 6, 9, 1.25},      NominalSize{28, 6, 10, 1.4},      NominalSize{32, 7, 11, 1.6},
    NominalSize{36, 8, 13, 1.8},      NominalSize{40, 9, 14, 2.0},      NominalSize{45, 10, 16, 2.25},
    NominalSize{50, 10, 16, 2.5},     NominalSize{56, 11, 18, 2.8},     NominalSize{63, 13, 20, 3.0},
    NominalSize{71, 13, 20, 3.0},     NominalSize{80, 14, 21, 3.0},     NominalSize{90, 15, 23, 3.0},
    NominalSize{100, 17, 25, 3.0},    NominalSize{112, 18, 27, 3.0},    NominalSize{125, 19, 29, 3.0},
    NominalSize{140, 20, 31, 3.0},    NominalSize{160, 22, 34, 3.0},    NominalSize{180, 24, 37, 3.0},
    NominalSize{200, 26, 39, 3.0},    NominalSize{224, 28, 42, 3.0},    NominalSize{250, 31, 47, 4.0},
    NominalSize{280, 32, 49, 4.0},    NominalSize{315, 34, 52, 4.0},    NominalSize{355, 37, 56, 4.0},
    NominalSize{400, 39, 59, 5.0},    NominalSize{450, 41, 63, 5.0},    NominalSize{500, 44, 66, 5.0},
    NominalSize{560, 46, 70, 6.0},    NominalSize{630, 49, 74, 6.0},    NominalSize{710, 52, 79, 7.0},
    NominalSize{800, 55, 84, 8.0},    NominalSize{900, 59, 89, 9.0},    NominalSize{1000, 62, 94, 10.0},
    NominalSize{1120, 64, 97, 11.0},  NominalSize{1250, 66, 99, 13.0},  NominalSize{1400, 68, 102, 14.0},
    NominalSize{1600, 70, 106, 16.0}, NominalSize{1800, 72, 109, 18.0}, NominalSize{2000, 74, 112, 20.0},
    NominalSize{2240, 76, 115, 22.0}, NominalSize{2500, 78, 118, 25.0}, NominalSize{2800, 80, 122, 28.0},
    NominalSize{3150, 83, 126, 32.0}, NominalSize{3550, 85, 129, 36.0}, NominalSize{4000, 88, 133, 40.0},
    NominalSize{4500, 91, 137, 45.0}, NominalSize{5000, 93, 141, 50.0}};

// ASTM B258, m.
double bare_diameter_of(int awg) {
  return 0.127e-3 * std::pow(92.0, (36.0 - awg) / 39.0);
}

double circle(double diameter) {
  return 0.25 * std::numbers::pi * diameter * diameter;
}

const GaugeRow* row_of(int awg) {
  return awg > last_in_tables ? nullptr : &gauge_rows[static_cast<std::size_t>(awg - thickest_gauge)];
}

// The power law through two points.
double between(double at, double low, double at_low, double high, double at_high) {
  const double share = std::log(at / low) / std::log(high / low);
  return at_low * std::pow(at_high / at_low, share);
}

// A column of the nominal sizes at a bare diameter, m.
double at_size(double bare, double NominalSize::*column) {
  const double microns = bare / micron;
  const auto above = std::ranges::lower_bound(nominal_sizes, microns, {}, &NominalSize::bare);
  const auto upper = std::clamp(above, nominal_sizes.begin() + 1, nominal_sizes.end() - 1);
  const NominalSize& low = *(upper - 1);
  return micron * between(microns, low.bare, low.*column, upper->bare, (*upper).*column);
}

// The smooth laws through the table's ampacities.
double smooth_ampacity_of(double bare) {
  constexpr double of_28 = 1.4;
  constexpr double exponent = 2.0601;
  constexpr double thick_exponent = 1.6254;
  static const double at_28 = bare_diameter_of(28);
  static const double at_20 = bare_diameter_of(20);
  if (bare <= at_20) return of_28 * std::pow(bare / at_28, exponent);
  return of_28 * std::pow(at_20 / at_28, exponent) * std::pow(bare / at_20, thick_exponent);
}

// By the slope of the table's logarithms between the gauges on either side, and that of its ends beyond.
double chassis_ampacity_of(double bare) {
  int thin = thickest_gauge + 1;
  while (thin < last_in_tables && bare_diameter_of(thin) > bare) ++thin;
  return between(bare, bare_diameter_of(thin), row_of(thin)->ampacity, bare_diameter_of(thin - 1),
                 row_of(thin - 1)->ampacity);
}

// Without an enamel and limits of its copper.
Wire bare_wire(double bare, Enamel enamel) {
  return {.enamel = enamel,
          .bare_diameter = bare,
          .resistance_per_length = copper_resistivity / circle(bare),
          .chassis_ampacity = chassis_ampacity_of(bare),
          .smooth_ampacity = smooth_ampacity_of(bare)};
}

Wire by_sizes(double bare, Enamel enamel) {
  Wire wire = bare_wire(bare, enamel);
  const double tolerance = at_size(bare, &NominalSize::tolerance);
  wire.insulated_diameter =
      bare + at_size(bare, enamel == Enamel::grade_1 ? &NominalSize::grade_1 : &NominalSize::grade_2);
  wire.least_bare = bare - tolerance;
  wire.largest_bare = bare + tolerance;
  return wire;
}

}  // namespace

double Wire::copper_section() const noexcept {
  return circle(bare_diameter);
}

std::string Wire::name() const {
  return awg ? fmt::format("AWG {}", *awg) : fmt::format("{:.4g} mm", bare_diameter / millimetre);
}

std::string Wire::enamel_name() const {
  if (!enamel) return fmt::format("{:.4g} mm over the enamel", insulated_diameter / millimetre);
  const bool thin = enamel == Enamel::grade_1;
  if (awg) return thin ? "single build" : "heavy build";
  return thin ? "grade 1" : "grade 2";
}

Wire gauge(int awg, Enamel enamel) {
  if (awg < thickest_gauge || awg > thinnest_gauge) {
    throw std::invalid_argument(
        fmt::format("awg: must be a whole number from {} to {}; got {}", thickest_gauge, thinnest_gauge, awg));
  }
  Wire wire = by_sizes(bare_diameter_of(awg), enamel);
  wire.awg = awg;
  if (const GaugeRow* row = row_of(awg)) {
    const double overall = enamel == Enamel::grade_1 ? row->single : row->heavy;
    if (overall > 0.0) wire.insulated_diameter = overall * mil;
    wire.least_bare = row->least_bare * mil;
    wire.largest_bare = row->largest_bare * mil;
    wire.chassis_ampacity = row->ampacity;
  }
  return wire;
}

Wire round_wire(double bare_diameter, Enamel enamel) {
  // A file's 0.018 mm is a rounding below.
  if (!(bare_diameter >= least_bare_diameter * (1.0 - 1e-12) && bare_diameter <= largest_bare_diameter)) {
    throw std::invalid_argument(fmt::format("bare_diameter: must be from {:.4g} to {:.4g} m; got {:.6g}",
                                            least_bare_diameter, largest_bare_diameter, bare_diameter));
  }
  return by_sizes(bare_diameter, enamel);
}

Wire with_overall_diameter(Wire wire, double insulated_diameter) {
  if (!(std::isfinite(insulated_diameter) && insulated_diameter > wire.largest_bare)) {
    throw std::invalid_argument(
        fmt::format("insulated_diameter: must be finite and above the largest copper of {} ({:.6g} m); got {:.6g}",
                    wire.name(), wire.largest_bare, insulated_diameter));
  }
  wire.enamel.reset();
  wire.insulated_diameter = insulated_diameter;
  return wire;
}

ResistanceRange resistance_range(const Wire& wire) noexcept {
  const auto over = [&wire](double diameter) {
    return (wire.bare_diameter / diameter) * (wire.bare_diameter / diameter);
  };
  return {.least = over(wire.largest_bare), .largest = over(wire.least_bare)};
}

}  // namespace coilwright::winding
