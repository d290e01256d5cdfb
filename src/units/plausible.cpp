#include "coilwright/units/plausible.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "coilwright/units/angle.hpp"

namespace coilwright::units {
namespace {

// By dimension, in SI. An angle may count some turns of an encoder; joints may be linear axes, a metre for a radian: a
// membrane that rings at 250 Hz has 26 kN/m.
constexpr std::array<std::pair<std::string_view, double>, 13> greatest = {{{"angle", 3600 * degree},
                                                                           {"length", 1e6},
                                                                           {"mass", 1e3},
                                                                           {"moment of inertia", 1e3},
                                                                           {"force", 1e6},
                                                                           {"torque", 1e4},
                                                                           {"torque per current", 1e4},
                                                                           {"angular stiffness", 1e6},
                                                                           {"angular damping", 1e3},
                                                                           {"current", 1e6},
                                                                           {"voltage", 1e6},
                                                                           {"flux density", 1e3},
                                                                           {"time", 1e9}}};
constexpr double greatest_of_others = 1e15;

}  // namespace

double greatest_plausible(const Unit& unit) noexcept {
  const auto* row = std::ranges::find(greatest, unit.dimension, &std::pair<std::string_view, double>::first);
  const Unit difference{unit.suffix, unit.dimension, unit.numerator, unit.denominator};  // degC has K's
  return from_si(row == greatest.end() ? greatest_of_others : row->second, difference);
}

}  // namespace coilwright::units
