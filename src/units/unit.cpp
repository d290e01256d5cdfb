#include "coilwright/units/unit.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace coilwright::units {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double gravity = 9.80665;                   // m/s^2, by which kilograms-force are defined (CGPM 1901)
constexpr double pound_force = 0.45359237 * gravity;  // N; the pound and the inch by the agreement of 1959
constexpr double pound_force_inch = pound_force * 0.0254;

// One row a unit. Each factor is exact as numerator / denominator (but for pi and what is of pounds), so a conversion
// rounds once.
constexpr std::array table = {
    Unit{"s", "time"},
    Unit{"ms", "time", 1, 1e3},
    Unit{"us", "time", 1, 1e6},
    Unit{"ns", "time", 1, 1e9},
    Unit{"min", "time", 60},
    Unit{"h", "time", 3600},
    Unit{"day", "time", 86400},
    Unit{"Hz", "frequency"},
    Unit{"kHz", "frequency", 1e3},

    Unit{"m", "length"},
    Unit{"cm", "length", 1, 1e2},
    Unit{"mm", "length", 1, 1e3},
    Unit{"um", "length", 1, 1e6},
    Unit{"mm2", "area", 1, 1e6},
    Unit{"m2", "area"},
    Unit{"mm3", "volume", 1, 1e9},
    Unit{"m3", "volume"},
    Unit{"m_s", "speed"},
    Unit{"mm_s", "speed", 1, 1e3},
    Unit{"m_s2", "acceleration"},
    Unit{"mm_s2", "acceleration", 1, 1e3},

    Unit{"rad", "angle"},
    Unit{"mrad", "angle", 1, 1e3},
    Unit{"deg", "angle", pi, 180},
    Unit{"1_rad", "per angle"},
    Unit{"1_rad2", "per square angle"},
    Unit{"rad_s", "angular rate"},
    Unit{"deg_s", "angular rate", pi, 180},
    Unit{"rad_s2", "angular acceleration"},
    Unit{"deg_s2", "angular acceleration", pi, 180},

    Unit{"kg", "mass"},
    Unit{"g", "mass", 1, 1e3},
    Unit{"mg", "mass", 1, 1e6},
    Unit{"kg_m3", "density"},
    Unit{"g_cm3", "density", 1e3},
    Unit{"kgm2", "moment of inertia"},
    Unit{"gmm2", "moment of inertia", 1, 1e9},

    Unit{"N", "force"},
    Unit{"mN", "force", 1, 1e3},
    Unit{"gf", "force", gravity, 1e3},
    Unit{"kgf", "force", gravity},
    Unit{"ozf", "force", pound_force, 16},
    Unit{"lbf", "force", pound_force},
    Unit{"N_m", "linear stiffness"},
    Unit{"N_mm", "linear stiffness", 1e3},
    Unit{"Nm", "torque"},
    Unit{"Nmm", "torque", 1, 1e3},
    Unit{"mNm", "torque", 1, 1e3},
    Unit{"Ncm", "torque", 1, 1e2},
    Unit{"gfcm", "torque", gravity, 1e5},
    Unit{"kgfcm", "torque", gravity, 1e2},
    Unit{"ozfin", "torque", pound_force_inch, 16},
    Unit{"lbfin", "torque", pound_force_inch},
    Unit{"lbfft", "torque", 12 * pound_force_inch},
    Unit{"Nm_A", "torque per current"},
    Unit{"Nmm_A", "torque per current", 1, 1e3},
    Unit{"N_A", "force per current"},
    Unit{"N_kg", "force per mass"},
    Unit{"Nm_rad", "angular stiffness"},
    Unit{"Nmm_rad", "angular stiffness", 1, 1e3},
    Unit{"Nm_deg", "angular stiffness", 180, pi},
    Unit{"Nmm_deg", "angular stiffness", 180, pi * 1e3},
    Unit{"Nms_rad", "angular damping"},
    Unit{"Nmms_rad", "angular damping", 1, 1e3},
    Unit{"Nms2_rad2", "angular drag"},
    Unit{"Nmms2_rad2", "angular drag", 1, 1e3},
    Unit{"Pa", "pressure"},
    Unit{"kPa", "pressure", 1e3},
    Unit{"MPa", "pressure", 1e6},
    Unit{"GPa", "pressure", 1e9},
    Unit{"J", "energy"},
    Unit{"mJ", "energy", 1, 1e3},

    Unit{"A", "current"},
    Unit{"mA", "current", 1, 1e3},
    Unit{"A_mm2", "current density", 1e6},
    Unit{"1_A2", "per square current"},
    Unit{"As", "charge"},
    Unit{"mAh", "charge", 36, 10},
    Unit{"V", "voltage"},
    Unit{"mV", "voltage", 1, 1e3},
    Unit{"W", "power"},
    Unit{"mW", "power", 1, 1e3},
    Unit{"Ohm", "resistance"},
    Unit{"mOhm", "resistance", 1, 1e3},
    Unit{"1_Ohm", "conductance"},
    Unit{"Ohmm", "resistivity"},
    Unit{"Ohm_m", "resistance per length"},
    Unit{"Ohm_km", "resistance per length", 1, 1e3},
    Unit{"H", "inductance"},
    Unit{"mH", "inductance", 1, 1e3},
    Unit{"uH", "inductance", 1, 1e6},
    Unit{"T", "flux density"},
    Unit{"mT", "flux density", 1, 1e3},
    Unit{"kA_m", "magnetic field strength", 1e3},
    Unit{"T_m", "gradient of a flux density"},

    Unit{"K", "temperature"},
    Unit{"degC", "temperature", 1, 1, 273.15},
    Unit{"degF", "temperature", 5, 9, 459.67 * 5 / 9},
    Unit{"per_K", "per temperature"},
    Unit{"pct_K", "per temperature", 1, 1e2},
    Unit{"K_W", "thermal resistance"},
    Unit{"W_K", "thermal conductance"},
    Unit{"J_K", "heat capacity"},
    Unit{"J_kgK", "specific heat"},
    Unit{"W_mK", "thermal conductivity"},
    Unit{"W_m2K", "heat transfer coefficient"},

    Unit{"pct", "ratio", 1, 1e2},
    Unit{"USD", "cost"},
    Unit{"USD_m", "cost per length"},
    Unit{"USD_kg", "cost per mass"},
    Unit{"USD_g", "cost per mass", 1e3},
};

double with_digits(double value, int digits) {
  std::array<char, 32> text{};
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
  double rounded{};
  std::from_chars(text.data(), written.ptr, rounded);
  return rounded;
}

}  // namespace

std::span<const Unit> all_units() noexcept {
  return table;
}

std::optional<NameWithUnit> split_unit(std::string_view name) noexcept {
  const Unit* longest = nullptr;
  for (const Unit& unit : table) {
    const bool fits = name.size() > unit.suffix.size() + 1 && name.ends_with(unit.suffix) &&
                      name[name.size() - unit.suffix.size() - 1] == '_';
    if (fits && (longest == nullptr || unit.suffix.size() > longest->suffix.size())) longest = &unit;
  }
  if (longest == nullptr) return std::nullopt;
  return NameWithUnit{name.substr(0, name.size() - longest->suffix.size() - 1), *longest};
}

std::string_view quantity_of(std::string_view name) noexcept {
  const auto split = split_unit(name);
  return split ? split->quantity : name;
}

Unit difference_unit(std::string_view name) noexcept {
  const auto split = split_unit(name);
  if (!split) return {.suffix = "", .dimension = ""};
  Unit unit = split->unit;
  if (unit.suffix == "degC") unit.suffix = "K";
  unit.offset = 0.0;
  return unit;
}

double to_si(double value, const Unit& unit) noexcept {
  return value * unit.numerator / unit.denominator + unit.offset;
}

double from_si(double value, const Unit& unit) noexcept {
  const double quotient = (value - unit.offset) * unit.denominator / unit.numerator;
  if (!std::isfinite(quotient)) return quotient;
  for (int digits = 15; digits <= 17; ++digits) {
    const double candidate = with_digits(quotient, digits);
    if (to_si(candidate, unit) == value) return candidate;
  }
  return quotient;
}

double from_si(double value, std::string_view name) noexcept {
  const auto split = split_unit(name);
  return split ? from_si(value, split->unit) : value;
}

std::string_view key_with_unit(std::string_view name) noexcept {
  const std::size_t slash = name.rfind('/');
  const bool is_element = slash != std::string_view::npos && slash + 1 < name.size() &&
                          name.find_first_not_of("0123456789", slash + 1) == std::string_view::npos;
  return is_element ? name.substr(0, slash) : name;
}

double to_memory(double value, std::string_view name) noexcept {
  return to_si(value, difference_unit(name));
}

double from_memory(double value, std::string_view name) noexcept {
  const Unit unit = difference_unit(name);
  const double nearest = from_si(value, unit);
  if (to_si(nearest, unit) == value) return nearest;
  // A factor such as pi/180 rounds twice on the way to SI: the number that was read may lie right beside the quotient.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double beside : {std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity)})
    if (to_si(beside, unit) == value) return beside;
  return nearest;
}

}  // namespace coilwright::units
