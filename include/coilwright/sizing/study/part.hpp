#pragma once

#include <cstddef>

namespace coilwright::sizing {

/// One of `of` parts of a run, each of which another machine may make.
struct Part {
  std::size_t number = 1;  ///< from 1 to `of`
  std::size_t of = 1;      ///< at most most_parts_of_a_run

  friend bool operator==(const Part&, const Part&) = default;
};

/// The most parts that a run may be cut into.
inline constexpr std::size_t most_parts_of_a_run = 1'000'000;

/// Indices from `first` on, without `end`.
struct IndexRange {
  std::size_t first{};
  std::size_t end{};
};

/// Which of `count` <= 10^12 indices belong to a part: those of all parts are each of them once, in order, and as many
/// in every part, to within one.
[[nodiscard]] constexpr IndexRange range_of(const Part& part, std::size_t count) {
  return {.first = count * (part.number - 1) / part.of, .end = count * part.number / part.of};
}

}  // namespace coilwright::sizing
