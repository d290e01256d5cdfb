#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/model/model.hpp"
#include "coilwright/actuator/operating_point.hpp"

namespace coilwright::formats {

/// The content of an actuator file.
struct ActuatorFile {
  std::string name;
  std::variant<actuator::Design, actuator::Model> content;    ///< `actuator/1` or `lumped-model/1`
  std::optional<actuator::OperatingPoint> operating_point{};  ///< for which a design was sized
};

/// Reads an actuator: a design (`"format": "actuator/1"`) or a lumped model (`"format": "lumped-model/1"`). Keys, units
/// and defaults are in docs/formats.md. Measured values become calibration factors. Its effects must be among
/// `effects`, to whose kinds the result refers. Throws InputError.
[[nodiscard]] ActuatorFile read_actuator(const std::filesystem::path& path,
                                         const actuator::EffectCatalogue& effects = actuator::standard_effects());

/// Parses an actuator from a text in memory; errors call it `file`.
[[nodiscard]] ActuatorFile parse_actuator(std::string_view text, std::string file,
                                          const actuator::EffectCatalogue& effects = actuator::standard_effects());

/// The design of `file`. Throws InputError with `reason` if it is a lumped model; `who` names it.
[[nodiscard]] const actuator::Design& design_of(const ActuatorFile& file, const std::string& who,
                                                std::string_view reason);

/// The parts of an operating point that a caller states; absent ones are those of the actuator's file.
struct OperatingWords {
  std::optional<double> current{}, duty{};    ///< A; 1
  std::optional<double> grasp_opening{};      ///< degrees
  std::optional<double> grasp_height{};       ///< mm
  std::optional<actuator::Wiring> wiring{};   ///< of the coils
  std::optional<double> supply_resistance{};  ///< ohm
  std::optional<double> supply_voltage{};     ///< V
};

/// The operating point of `file`, called `who`, with the stated parts. Throws InputError if a number breaks its rule,
/// if neither has a current (`cure` tells how to give one), and if coils with shares of the current are in series.
[[nodiscard]] actuator::OperatingPoint operating_point_of(const ActuatorFile& file, const OperatingWords& said,
                                                          const std::string& who, const std::string& cure);

}  // namespace coilwright::formats
