#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

/// Number of letters to insert, delete, replace or swap with their neighbour to turn `a` into `b` (the optimal
/// string alignment distance).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// Whether a word is one of `words`, which are separated by |.
[[nodiscard]] bool is_one_of(std::string_view word, std::string_view words);

/// The candidates that `word` most likely stands for, in their order: the nearest ones that differ in at most a third
/// of its letters (at least one).
[[nodiscard]] std::vector<std::string> nearest_words(std::string_view word, std::span<const std::string> candidates);

/// The rule for a text that must be one of `legal` words: `must be "fit"`, `must be one of "fit", "validate"`.
[[nodiscard]] std::string must_be_one_of(std::span<const std::string> legal);

/// The candidate that gives the radius of what `word` gives the diameter of, or the reverse: `; did you mean
/// "magnet_radius_mm", half of the diameter?` for "magnet_diameter_mm". Empty if there is none.
[[nodiscard]] std::string radius_or_diameter(std::string_view word, std::span<const std::string> candidates);

/// A suggestion, `; did you mean "evaluate"?`: the candidates that have `word` among their words ("mass" for "mass_g")
/// or, if these are too many, those that begin with it, or else that of radius_or_diameter(), or else the nearest ones.
/// Empty if no candidate is near, or more than four are.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace coilwright::text
