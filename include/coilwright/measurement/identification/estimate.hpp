#pragma once

#include <optional>
#include <string>

namespace coilwright::measurement::identification {

/// A fitted number.
struct Estimate {
  std::string key{};       ///< with its unit, as the report writes it
  double value{};          ///< SI
  double lower{};          ///< lower end of the 95 % interval, SI; -infinity if the data set no bound
  double upper{};          ///< upper end, SI; infinity if the data set no bound
  bool determined = true;  ///< false if the interval reaches a physical bound on both sides, or there is no interval
  /// What the declared model has, SI, of a number that was fitted freely; nothing of others.
  std::optional<double> declared{};
  /// Whether other values of it, apart from each other, fit nearly as well: the value is the best of those that were
  /// looked at, and the interval, coarse by 4 %, contains those that the data cannot tell from it.
  bool has_many_optima = false;
  bool chosen = false;  ///< whether it is one of a few choices: each was tried, and the interval is the value alone
};

}  // namespace coilwright::measurement::identification
