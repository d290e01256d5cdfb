#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/sizing/problem/front.hpp"
#include "coilwright/sizing/problem/problem.hpp"

namespace coilwright::sizing::testing {

/// A published problem with its budget and the share of the true front's hypervolume to reach.
struct FrontProblem {
  std::string name;
  Problem problem;
  std::size_t budget{};  ///< evaluations
  double target{};       ///< hypervolume over the true front's, both normalised, reference 1.1
  FrontFrame frame;      ///< of the true front
  double hypervolume{};  ///< of the true front, normalised
};

/// Definitions: BNH, SRN, TNK, OSY as restated by Deb, Pratap, Meyarivan, "Constrained test problems for
/// multi-objective evolutionary optimization", EMO 2001; ZDT1, 2, 3 (30 variables) and 6 (10): Zitzler, Deb, Thiele,
/// Evol. Comput. 8 (2000) 173; DTLZ2 with two objectives and 12 variables: Deb, Thiele, Laumanns, Zitzler, CEC 2002,
/// 825; RE21 and CRE25: Tanabe, Ishibuchi, Appl. Soft Comput. 89 (2020) 106078. Constraints are scaled to order 1, <=
/// 0.
[[nodiscard]] Problem re21();
[[nodiscard]] Problem bnh();
[[nodiscard]] Problem srn();
[[nodiscard]] Problem tnk();
[[nodiscard]] Problem zdt1();
[[nodiscard]] Problem zdt2();
[[nodiscard]] Problem zdt3();
[[nodiscard]] Problem zdt6();
[[nodiscard]] Problem dtlz2();
[[nodiscard]] Problem cre25();
[[nodiscard]] Problem osy();

/// All of them with the true fronts' figures from `file` (tests/data/sizing/front_problems.csv; origin in
/// tests/data/sizing_SOURCES.md).
[[nodiscard]] std::vector<FrontProblem> front_problems(const std::string& file);

/// Hypervolume of feasible minimised points over that of the true front.
[[nodiscard]] double hypervolume_ratio(const FrontProblem& problem, const std::vector<Objectives>& points);

/// A problem of the kind the actuator poses, but with closed formulas: a winding on a grid (configuration, gauge,
/// radial and axial turns, magnet, gap; 311 040 designs), torque against mass (and, with `three`, power), limits on
/// mass, current density and outer radius, and windings that do not fit.
enum class GridObjectives { two, three };
[[nodiscard]] Problem winding_grid(GridObjectives objectives);

/// Every design of a problem with a grid in each variable: the feasible, minimised objectives.
[[nodiscard]] std::vector<Objectives> enumerate_feasible(const Problem& problem);

}  // namespace coilwright::sizing::testing
