#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/calibration_doubts.hpp"
#include "coilwright/report/simulation/document.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/part_limits.hpp"

namespace coilwright::report {

/// Returns the limit that a study sets to a quantity of that name, on that side; absent if it sets none.
using LimitInStudy = std::function<std::optional<double>(std::string_view quantity, bool at_most)>;

/// The cautions of limits that a design breaks, and of conditional ones, each with the constraint that the study lacks
/// to keep it; none if it keeps all. With `in_builds` the constraints are those by which 95 % of the builds of a
/// study's spread keep them.
[[nodiscard]] std::vector<std::string> cautions_of_parts(std::span<const simulation::PartLimit> broken, bool in_builds,
                                                         const LimitInStudy& limit_in_study);

/// A caution for each measured value that lies far from the one derived from the dimensions of the same file.
[[nodiscard]] std::vector<std::string> doubts_of(const actuator::Design& design);

/// Value, limit and margin of each limit of the parts, and the consequence of breaking it.
[[nodiscard]] Section limits_section(std::span<const simulation::PartLimit> limits);

/// The description of a subject of such a list: how it is taken, how well it is known and what settles it.
[[nodiscard]] std::string subject_text(const actuator::OtherChoice& choice);

/// The runs of entries of `effects` that have one subject; entries of a subject must follow each other.
template <class Effect>
[[nodiscard]] std::vector<std::span<const Effect>> by_subject(std::span<const Effect> effects) {
  std::vector<std::span<const Effect>> out;
  while (!effects.empty()) {
    const auto end = std::ranges::find_if(
        effects, [&](const Effect& each) { return each.choice.subject != effects.front().choice.subject; });
    out.emplace_back(effects.begin(), end);
    effects = std::span(end, effects.end());
  }
  return out;
}

/// The assumptions behind the figures of `taken`, in the order of simulation::choice_effects(): for each other choice
/// and number of a subject that matters the main figures that it changes, the limit of the parts with the least margin
/// (unless the same limits are broken without it), and what settles it; then the names of the subjects that do not
/// matter.
[[nodiscard]] Section assumptions_section(const simulation::DesignView& taken,
                                          std::span<const simulation::ChoiceEffect> effects);

}  // namespace coilwright::report
