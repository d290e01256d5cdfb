#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// Uncertainty of a number of a design that was not measured on the built actuator, and its scatter between builds.
struct NumberWidth {
  /// The unit of `least` and `greatest`.
  enum class In {
    deviations,  ///< relative to the design's value, in the unit of the name
    shares,      ///< deviations as shares of the design's value
    values       ///< values of the number itself, in the unit of the name
  };

  std::string_view name;        ///< of the parameter
  std::string_view subject;     ///< its meaning for people; empty if `source` says why it has no width of its own
  std::string_view source;      ///< source of the width, or that it is assumed
  std::string_view settled_by;  ///< the measurement or statement that settles it
  In in = In::shares;           ///< the meaning of the two ends
  double least{};               ///< lower end; both ends are 0 if `values` gives all
  double greatest{};            ///< upper end
  /// Scatter of one build about its design: the bound that makers and standards give, two standard deviations; 0 if all
  /// builds of a design have the same value. @{
  double printed{};  ///< a cast in printed moulds
  double by_hand{};  ///< moulds, cores and the cut made by hand
  ///@}
  bool decided = false;                   ///< whether the builder decides it and no measurement does
  bool (*open)(const Design&) = nullptr;  ///< whether a design leaves it open; nullptr: always
  /// Returns the other values if they are not the two ends, in the unit of the name. nullptr: they are the ends.
  std::vector<double> (*values)(const Design&) = nullptr;
};

/// One row for each of parameters(), except the counts of turns, the gauge and the grades, which are as ordered.
/// `coilwright list widths` prints them; docs/assumptions.md describes their use.
[[nodiscard]] std::span<const NumberWidth> number_widths();

/// The values of that number, in the unit of its name, at which a design is also to be evaluated. Empty if the design
/// states or measured the number, or if it has no effect there.
[[nodiscard]] std::vector<double> other_values(const NumberWidth& width, const Design& design);

}  // namespace coilwright::actuator
