#pragma once

#include <string>
#include <vector>

#include "attribution/score.hpp"

namespace attribution {

/// One aim of the benchmark: a fraction of a kind of sets that should be at least, or at most, a given value.
struct Aim {
  std::string text;
  Count count;
  double share{};  ///< the value to be reached
  bool at_most = false;
  [[nodiscard]] bool reached() const {
    const auto hits = static_cast<double>(count.hits);
    return at_most ? hits <= share * count.of : hits >= share * count.of;
  }
};

[[nodiscard]] std::vector<Aim> aims(const std::vector<Outcome>& outcomes);

/// One line about one set.
[[nodiscard]] std::string set_line(const Outcome& outcome);

/// One line per aim, and one line per set in which something went wrong.
[[nodiscard]] std::string summary(const std::vector<Outcome>& outcomes);

/// One line per set.
[[nodiscard]] std::string sets_csv(const std::vector<Outcome>& outcomes);

/// Counts of the hidden effect (rows; sets with at most one) and the first reported effect (columns; the verdict if
/// none is reported).
[[nodiscard]] std::string confusion_csv(const std::vector<Outcome>& outcomes);

}  // namespace attribution
