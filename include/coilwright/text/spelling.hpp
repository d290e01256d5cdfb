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

/// Whether a word is one of `words`, which | parts.
[[nodiscard]] bool is_one_of(std::string_view word, std::string_view words);

/// The candidates that `word` was most likely meant to be, in their order: those nearest to it, at most a third of its
/// letters (at least one) away.
[[nodiscard]] std::vector<std::string> nearest_words(std::string_view word, std::span<const std::string> candidates);

/// `must be "fit"`, `must be one of "fit", "validate"`: the rule of a text that is one of `legal` words.
[[nodiscard]] std::string must_be_one_of(std::span<const std::string> legal);

/// `; did you mean "evaluate"?`: the candidates that have `word` among their words ("mass" for "mass_g") or, where that
/// is too many, those that begin with it, or else the nearest ones. Nothing when no candidate is near, or more than
/// four are.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace coilwright::text
