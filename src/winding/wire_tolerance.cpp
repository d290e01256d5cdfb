#include "coilwright/winding/wire_tolerance.hpp"

#include <array>
#include <cstddef>

#include "coilwright/winding/wire_gauge.hpp"
#include "winding/mil.hpp"

namespace coilwright::winding {
namespace {

// In mils. AWG 20 to 36: "Copper Magnet Wire Data" of a US maker's handbook; 37 to 40: Centelsa's catalogue of magnet
// wire. Both say the same from 23 to 36. See tests/data/winding_SOURCES.md.
constexpr std::array<BareDiameters, thinnest_gauge - thickest_gauge + 1> bare_rows{{
    {31.7, 32.3}, {28.2, 28.8}, {25.0, 25.6}, {22.4, 22.8}, {19.9, 20.3},  // 20 to 24
    {17.7, 18.1}, {15.7, 16.1}, {14.1, 14.3}, {12.5, 12.7}, {11.2, 11.4},  // 25 to 29
    {9.9, 10.1},  {8.8, 9.0},   {7.9, 8.1},   {7.0, 7.2},   {6.2, 6.4},    // 30 to 34
    {5.5, 5.7},   {4.9, 5.1},   {4.4, 4.6},   {3.9, 4.1},   {3.4, 3.6},    // 35 to 39
    {3.0, 3.2},                                                            // 40
}};

}  // namespace

BareDiameters bare_diameters(int awg) {
  static_cast<void>(gauge(awg));  // throws where there is none
  const BareDiameters& row = bare_rows[static_cast<std::size_t>(awg - thickest_gauge)];
  return {.least = row.least * mil, .largest = row.largest * mil};
}

ResistanceRange resistance_range(int awg) {
  const double bare = gauge(awg).bare_diameter;
  const BareDiameters sold = bare_diameters(awg);
  const auto over = [&](double diameter) { return (bare / diameter) * (bare / diameter); };
  return {.least = over(sold.largest), .largest = over(sold.least)};
}

}  // namespace coilwright::winding
