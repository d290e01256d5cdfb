#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::formats {

/// Reads a study (`"format": "study/1"`) and the actuator it names, whose path counts from the study's folder. Keys are
/// in docs/formats.md. Throws InputError, also for what contradicts itself: a bound that crosses another, a limit that
/// no value can meet together with another one, a current that is both fixed and varied.
///
/// Objectives and constraints name rows of `quantities`, which the study keeps as the table of its results. The
/// actuator's effects are of `effects`.
[[nodiscard]] sizing::Study read_study(const std::filesystem::path& path,
                                       const simulation::QuantityTable& quantities = simulation::standard_quantities(),
                                       const actuator::EffectCatalogue& effects = actuator::standard_effects());

/// The same for a text in memory; `file` is the name its errors carry, and the actuator's path counts from its folder.
[[nodiscard]] sizing::Study parse_study(std::string_view text, std::string file,
                                        const simulation::QuantityTable& quantities = simulation::standard_quantities(),
                                        const actuator::EffectCatalogue& effects = actuator::standard_effects());

}  // namespace coilwright::formats
