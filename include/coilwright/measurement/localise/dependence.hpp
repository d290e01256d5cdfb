#pragma once

#include <string>
#include <vector>

namespace coilwright::measurement::localise {

/// The fraction of the residual torque's variance that one variable explains by itself.
struct Dependence {
  std::string variable{};          ///< "angle", "rate", "sign of rate", "current", "current history", "time", ...
  double explained{};              ///< 0 to 1, on samples that the bins were not made from
  std::vector<double> at{};        ///< mean of the variable in each bin, SI
  std::vector<double> residual{};  ///< mean residual torque in each bin, N m
};

}  // namespace coilwright::measurement::localise
