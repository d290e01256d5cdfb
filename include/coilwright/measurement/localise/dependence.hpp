#pragma once

#include <string>
#include <vector>

namespace coilwright::measurement::localise {

/// How much of the residual torque's variance one variable explains by itself (binned means, against chance).
struct Dependence {
  std::string variable{};          ///< "angle", "rate", "sign of rate", "current", "current history", "time", ...
  double explained{};              ///< 0 to 1, on samples that the bins were not made from
  std::vector<double> at{};        ///< centres of the bins, SI
  std::vector<double> residual{};  ///< mean residual torque there, N m
};

}  // namespace coilwright::measurement::localise
