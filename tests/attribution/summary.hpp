#pragma once

#include <string>
#include <vector>

#include "attribution/score.hpp"

namespace attribution {

/// One aim of the benchmark: a share of a kind of sets, and the least (or most) that it is to be.
struct Aim {
  std::string text;
  Count count;
  double share{};  ///< that is to be reached
  bool at_most = false;
  [[nodiscard]] bool reached() const {
    const double is = static_cast<double>(count.hits);
    return at_most ? is <= share * count.of : is >= share * count.of;
  }
};

[[nodiscard]] std::vector<Aim> aims(const std::vector<Outcome>& outcomes);

/// One line on one set.
[[nodiscard]] std::string line(const Outcome& outcome);

/// The aims, a line each, and what was missed, a line a set.
[[nodiscard]] std::string summary(const std::vector<Outcome>& outcomes);

/// A line a set.
[[nodiscard]] std::string sets_csv(const std::vector<Outcome>& outcomes);

/// Hidden (rows; sets with at most one) against first reported (columns; the verdict where none is).
[[nodiscard]] std::string confusion_csv(const std::vector<Outcome>& outcomes);

}  // namespace attribution
