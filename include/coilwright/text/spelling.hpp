#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

/// Number of letters to insert, delete, replace or swap with their neighbour to turn `a` into `b` (the optimal
/// string alignment distance).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that `word` was most likely meant to be: at most a third of its letters (at least one) away.
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> candidates);

/// The candidates that begin with `word`, in their order: at least two letters or digits of it are needed, and nothing
/// is returned where more than four begin so.
[[nodiscard]] std::vector<std::string> words_beginning_with(std::string_view word,
                                                            std::span<const std::string> candidates);

/// The same of those whose last words are `word`: "angle_deg" for "bending_angle_deg".
[[nodiscard]] std::vector<std::string> words_ending_with(std::string_view word,
                                                         std::span<const std::string> candidates);

/// `; did you mean "evaluate"?`: the candidates that begin with `word` ("mass" for "mass_g", "eval" for "evaluate"), or
/// else those that end with it, or else the nearest one. Nothing when no candidate is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace coilwright::text
