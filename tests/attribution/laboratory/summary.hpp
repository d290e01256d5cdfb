#pragma once

#include <string>
#include <vector>

#include "attribution/laboratory/outcome.hpp"

namespace attribution::laboratory {

/// One figure of the benchmark: a fraction of a kind of sets that should be at least, or at most, a given value.
struct Figure {
  std::string text;
  std::string column;  ///< its short name in the table of conditions
  Count count{};
  double share{};  ///< the value to be reached
  bool at_most = false;
  [[nodiscard]] bool reached() const {
    const auto hits = static_cast<double>(count.hits);
    return at_most ? hits <= share * count.of : hits >= share * count.of;
  }
};

/// All figures, over these sets.
[[nodiscard]] std::vector<Figure> figures(const std::vector<Outcome>& outcomes);

/// What went wrong with a set; empty if nothing did.
[[nodiscard]] std::string fault_of(const Outcome& outcome);

/// One line about one set, without times.
[[nodiscard]] std::string set_line(const Outcome& outcome);

/// The figures over all sets, each with its count; a table of them by condition; a line per set in which something went
/// wrong. No times: the same outcomes give the same bytes.
[[nodiscard]] std::string summary(const std::vector<Outcome>& outcomes);

/// Median and longest time of a diagnosis, and the sets that took longest.
[[nodiscard]] std::string times(const std::vector<Outcome>& outcomes);

}  // namespace attribution::laboratory
