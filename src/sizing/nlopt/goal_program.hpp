#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "sizing/nlopt/linearisation.hpp"
#include "sizing/nlopt/nlopt_run.hpp"
#include "sizing/sampling/goal.hpp"

namespace coilwright::sizing {

/// A box of unit coordinates, inside the unit cube.
struct Box {
  Eigen::VectorXd lower, upper;
};

/// All of the unit cube that a space allows: 0 to the largest legal value along each axis.
[[nodiscard]] Box whole_box(const DesignSpace& space);

/// Objectives and constraints as functions of unit coordinates: those of a model, or the problem's own.
struct DesignFunctions {
  /// What a call asks for.
  enum class Wanted { values, gradients };
  /// The objectives, then the constraints, at `x`; the jacobian only for `gradients`.
  std::function<Linearisation(const Eigen::VectorXd& x, Wanted wanted)> at;
  Eigen::Index objectives{}, constraints{};  ///< number of each
  double margin{};                           ///< constraints must not exceed -margin, >= 0
};

/// How NLopt is run on a goal.
struct NloptSettings {
  Algorithm algorithm{};        ///< any but `automatic`
  int max_calls{};              ///< of the objective
  double relative_tolerance{};  ///< on the coordinates; 0: none
  double first_step{};          ///< of derivative-free algorithms, relative to the box; 0: NLopt's default
  std::uint64_t seed = 1;       ///< of NLopt's random generator
};

/// Minimises a goal over the axes `free` of a box with NLopt, from `start`, and returns the point where NLopt ended. To
/// algorithms that take constraints a min-max goal is posed smoothly: its value becomes a variable, and each of its
/// terms a constraint. Other algorithms minimise the goal plus a penalty on the largest constraint.
[[nodiscard]] Eigen::VectorXd minimise(const DesignFunctions& functions, const Goal& goal, const Box& box,
                                       const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free,
                                       const NloptSettings& settings);

}  // namespace coilwright::sizing
