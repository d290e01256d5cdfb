#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::simulation {

/// A static problem: the residual of the torques at a pose, N m, and its negative slope, N m/rad (both over the
/// joints).
struct StaticProblem {
  std::function<mechanics::JointVector(const mechanics::JointVector&)> residual;
  std::function<mechanics::JointMatrix(const mechanics::JointVector&)> stiffness;
  double torque_scale{};  ///< N m, > 0: residuals below 1e-11 of it count as zero
};

/// The stable equilibrium to which a heavily damped chain creeps from `start`, rad per joint; absent if the creep ends
/// nowhere within 400 steps or folds a joint beyond 180 degrees.
///
/// It takes Newton steps where the stiffness is positive definite and the residual falls, and elsewhere implicit steps
/// along the gradient flow, which cannot end on a saddle or a maximum.
[[nodiscard]] std::optional<mechanics::JointVector> creep_to_equilibrium(const StaticProblem& problem,
                                                                         const mechanics::JointVector& start);

/// A torque as a scale for others of this model, N m: that of its stiffest hinge at 1 rad, or its weight when straight.
[[nodiscard]] double torque_scale(const actuator::Model& model);

/// The stable equilibrium to which a model under constant currents (A) creeps.
[[nodiscard]] std::optional<mechanics::JointVector> find_equilibrium(const actuator::Model& model,
                                                                     const actuator::CoilCurrents& currents,
                                                                     const mechanics::JointVector& start);

/// Every stable equilibrium that is reached from a grid of starting poses (each joint at -2, 20, 60 and 110 degrees, at
/// most 256 poses), each once, in order of bending angle. A finger with more than one can snap.
[[nodiscard]] std::vector<mechanics::JointVector> stable_equilibria(const actuator::Model& model,
                                                                    const actuator::CoilCurrents& currents);

}  // namespace coilwright::simulation
