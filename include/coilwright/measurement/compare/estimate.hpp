#pragma once

#include <string>

namespace coilwright::measurement::compare {

/// A fitted number.
struct Estimate {
  std::string key{};         ///< with its unit, as the report writes it
  double denominator = 1.0;  ///< SI value = value in the key's unit / denominator
  double value{};            ///< SI
  double lower{};            ///< of the 95 % interval, SI; -infinity where the data set no bound
  double upper{};
  bool determined = true;  ///< false: the interval reaches a physical bound on both sides, or there is none
  bool chosen = false;     ///< one of a few choices: each was tried, and the interval is the value alone
};

}  // namespace coilwright::measurement::compare
