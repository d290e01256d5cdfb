#include "coilwright/winding/wire_gauge.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "coilwright/winding/copper.hpp"
#include "winding/mil.hpp"

namespace coilwright::winding {
namespace {

struct Row {
  double insulated_mils;  // NEMA MW 1000 single film, maximum overall diameter (Centelsa's catalogue of magnet wire)
  double ampacity;        // chassis wiring, Handbook of Electronic Tables and Formulas (as printed by PowerStream)
};

constexpr std::array<Row, thinnest_gauge - thickest_gauge + 1> rows{{
    {33.9, 11.0}, {30.3, 9.0}, {27.0, 7.0}, {24.3, 4.7}, {21.7, 3.5},  // 20 to 24
    {19.4, 2.7},  {17.3, 2.2}, {15.6, 1.7}, {14.0, 1.4}, {12.6, 1.2},  // 25 to 29
    {11.2, 0.86}, {10.0, 0.7}, {9.1, 0.53}, {8.1, 0.43}, {7.2, 0.33},  // 30 to 34
    {6.4, 0.27},  {5.8, 0.21}, {5.2, 0.17}, {4.7, 0.13}, {4.1, 0.11},  // 35 to 39
    {3.7, 0.09},                                                       // 40
}};

// The smooth law through the table's ampacities.
constexpr double ampacity_of_28 = 1.4;
constexpr double ampacity_exponent = 2.0601;

// ASTM B258, m.
double bare_diameter_of(int awg) {
  return 0.127e-3 * std::pow(92.0, (36.0 - awg) / 39.0);
}

double circle(double diameter) {
  return 0.25 * std::numbers::pi * diameter * diameter;
}

}  // namespace

double WireGauge::copper_section() const noexcept {
  return circle(bare_diameter);
}

WireGauge gauge(int awg) {
  if (awg < thickest_gauge || awg > thinnest_gauge) {
    throw std::invalid_argument(
        fmt::format("awg: must be a whole number from {} to {}; got {}", thickest_gauge, thinnest_gauge, awg));
  }
  const Row& row = rows[static_cast<std::size_t>(awg - thickest_gauge)];
  const double bare = bare_diameter_of(awg);
  return {.awg = awg,
          .bare_diameter = bare,
          .insulated_diameter = row.insulated_mils * mil,
          .resistance_per_length = copper_resistivity / circle(bare),
          .chassis_ampacity = row.ampacity,
          .smooth_ampacity = ampacity_of_28 * std::pow(bare / bare_diameter_of(28), ampacity_exponent)};
}

}  // namespace coilwright::winding
