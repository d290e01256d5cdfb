#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/actuator/calibration_doubts.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/part_limits.hpp"

namespace coilwright::report {

/// The limit that a study sets to a quantity of that name, on that side; nothing where it sets none.
using LimitInStudy = std::function<std::optional<double>(std::string_view quantity, bool at_most)>;

/// A warning of limits that a design breaks, then of conditional ones, each with what the study would have to say to
/// keep them and does not say yet; empty where there are none. `in_builds`: they are to be kept by 95 % of the builds
/// of a study's spread.
[[nodiscard]] std::string warning_of_parts(std::span<const simulation::PartLimit> broken, bool in_builds,
                                           const LimitInStudy& limit_in_study);

/// Measured values that lie far from what the dimensions of the same file give; empty where none does.
[[nodiscard]] std::string doubts_text(const actuator::Design& design);

/// One line for each limit of the parts: value, limit, and what happens where it is broken.
[[nodiscard]] std::string to_text(std::span<const simulation::PartLimit> limits);

/// What one subject of such a list is, how it is taken, how well it is known and what settles it.
[[nodiscard]] std::string subject_text(const actuator::OtherChoice& choice);

/// What the figures of `taken` rest on, in the order of simulation::choice_effects(): for each other choice and number
/// of a subject that matters the main figures that it changes, the limit of the parts with the least margin unless the
/// same limits are broken without it, and what settles it; the subjects that do not matter by name.
[[nodiscard]] std::string to_text(const simulation::DesignView& taken,
                                  std::span<const simulation::ChoiceEffect> effects);

}  // namespace coilwright::report
