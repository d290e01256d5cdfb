#pragma once

namespace coilwright::measurement::whiteness {

/// Nominal probabilities with which white noise fails each kind of test, each divided among the tests of its kind
/// (Bonferroni). The tests of one kind overlap, so that fewer than one of two hundred sets fail in all.
namespace false_alarms {
inline constexpr double of_pooled_bands = 0.005;
inline constexpr double of_bands = 0.0015;
inline constexpr double of_pooled_lines = 0.001;
inline constexpr double of_lines = 0.001;
inline constexpr double of_blocks = 0.001;
}  // namespace false_alarms

}  // namespace coilwright::measurement::whiteness
