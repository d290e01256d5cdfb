#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace coilwright::formats {

/// What a column may be of.
enum class Quantity { time, current, voltage, torque, angle, rate, force, temperature, duty, position, other, none };

/// What the name of a column says.
struct ColumnWords {
  Quantity quantity{Quantity::none};
  bool by_unit{false};          ///< the unit alone says so
  std::string unit{};           ///< as our names end in it: "mA"; empty: none is named
  std::string strange_unit{};   ///< what stands in brackets like a unit and is none that we know: "gon"
  std::optional<int> number{};  ///< the last number in the name: 2 in "theta2"
  bool commanded{false};        ///< a setpoint, which need not be what acted or was measured
};

/// Reads the name of a column as people and instruments write it: "Time [s]", "Strom / mA", "CH1 (V)", "theta_2 (deg)".
[[nodiscard]] ColumnWords words_of(std::string_view name);

}  // namespace coilwright::formats
