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

/// What an actuator file describes.
struct ActuatorFile {
  std::string name;
  std::variant<actuator::Design, actuator::Model> content;    ///< `actuator/1` or `lumped-model/1`
  std::optional<actuator::OperatingPoint> operating_point{};  ///< of a design: for which it was sized
};

/// Reads an actuator: a design (`"format": "actuator/1"`) or a lumped model (`"format": "lumped-model/1"`). Keys, units
/// and defaults are in docs/formats.md. Measured values become calibration factors here. Its effects are of
/// `effects`, whose kinds the result refers to. Throws InputError.
[[nodiscard]] ActuatorFile read_actuator(const std::filesystem::path& path,
                                         const actuator::EffectCatalogue& effects = actuator::standard_effects());

/// The same for a text in memory; `file` is the name its errors carry.
[[nodiscard]] ActuatorFile parse_actuator(std::string_view text, std::string file,
                                          const actuator::EffectCatalogue& effects = actuator::standard_effects());

}  // namespace coilwright::formats
