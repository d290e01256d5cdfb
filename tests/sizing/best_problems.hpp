#pragma once

#include <string>
#include <vector>

#include "coilwright/sizing/problem/problem.hpp"

namespace coilwright::sizing::testing {

/// A published problem with one objective and its best known value (all minimised).
struct BestProblem {
  std::string name;
  Problem problem;
  double best{};  ///< published
};

/// Spring, vessel, beam and reducer as in Coello Coello, Comput. Ind. 41 (2000) 113 and Mezura-Montes, Coello Coello,
/// Int. J. Gen. Syst. 37 (2008) 443, where the best values are; Hartmann's function in six variables as in
/// Dixon, Szegoe, "Towards Global Optimisation 2" (1978).
[[nodiscard]] std::vector<BestProblem> best_problems();

}  // namespace coilwright::sizing::testing
