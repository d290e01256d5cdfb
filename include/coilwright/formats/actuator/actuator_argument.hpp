#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::formats {

/// Returns `design` with one number or the configuration changed as an argument says: "gap_mm=1.2", "configuration=C"
/// or, for an effect that it has, "dry_friction.torque_Nmm=0.5". Names and units are those of a study's variables and
/// spread; calibration factors stay. Throws InputError whose file is the assignment: `gap_mm=-1: must be > 0 and <=
/// 1000000`.
[[nodiscard]] actuator::Design with_assignment(actuator::Design design, std::string_view assignment);

/// Parses an effect from an argument: its id, then its parameters in the unit of their keys,
/// "dry_friction:torque_Nmm=0.6" or "viscoelastic_creep:stiffness_ratio=0.2,time_constant_s=0.5"; the id alone for an
/// effect without parameters. The id must be among `known`. Throws InputError whose file is the argument:
/// `dry_friction:torque_Nmm=-1: must be >= 0`.
[[nodiscard]] actuator::Effect parse_effect(std::string_view argument,
                                            const actuator::EffectCatalogue& known = actuator::standard_effects());

/// Parses effects that `nominal`, of the actuator called `who`, is to have without declaring them. Throws InputError
/// also if one is given twice, is declared already, or cannot be in that model.
[[nodiscard]] std::vector<actuator::Effect> parse_hidden_effects(
    std::span<const std::string> arguments, const actuator::ModelSpec& nominal, const std::string& who,
    const actuator::EffectCatalogue& known = actuator::standard_effects());

}  // namespace coilwright::formats
