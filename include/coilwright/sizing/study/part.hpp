#pragma once

#include <cstddef>

namespace coilwright::sizing {

/// One of `of` parts of a run, each of which may be computed on another machine.
struct Part {
  std::size_t number = 1;  ///< from 1 to `of`
  std::size_t of = 1;      ///< at most most_parts_of_a_run

  friend bool operator==(const Part&, const Part&) = default;
};

/// The largest number of parts of a run.
inline constexpr std::size_t most_parts_of_a_run = 1'000'000;

/// Indices from `first` up to, but not including, `end`.
struct IndexRange {
  std::size_t first{};
  std::size_t end{};
};

/// The indices of a part among `count` <= 10^12: all parts together have each index once, in order, and equally many to
/// within one.
[[nodiscard]] constexpr IndexRange range_of(const Part& part, std::size_t count) {
  return {.first = count * (part.number - 1) / part.of, .end = count * part.number / part.of};
}

}  // namespace coilwright::sizing
