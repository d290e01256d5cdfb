#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/units/angle.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace coilwright::simulation {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;

constexpr int most_newton_steps = 400;
constexpr double largest_step = 0.2;  // rad: below the angle over which a torque curve bends
constexpr double residual_tolerance = 1e-11;

// K + shift I, solved for the residual; nothing where it is not positive definite.
std::optional<JointVector> shifted_step(const JointMatrix& stiffness, double shift, const JointVector& residual) {
  JointMatrix matrix = stiffness;
  matrix.diagonal().array() += shift;
  const Eigen::LLT<JointMatrix> factor(matrix);
  if (factor.info() != Eigen::Success) return std::nullopt;
  return JointVector(factor.solve(residual));
}

// The smallest shift at or above `shift` that gives a descent step of bounded length.
JointVector flow_step(const JointMatrix& stiffness, double& shift, const JointVector& residual) {
  assert(stiffness.allFinite() && residual.allFinite() && "no shift ends this loop");
  for (;; shift *= 4.0) {
    const std::optional<JointVector> step = shifted_step(stiffness, shift, residual);
    if (step && step->lpNorm<Eigen::Infinity>() <= largest_step) return *step;
  }
}

}  // namespace

double torque_scale(const actuator::Model& model) {
  double scale =
      model.static_residual(JointVector::Zero(model.joints()), model.all_coils(0.0)).lpNorm<Eigen::Infinity>();
  for (const actuator::Hinge& hinge : model.hinges()) scale = std::max(scale, hinge.stiffness);
  return scale > 0.0 ? scale : 1.0;
}

std::optional<JointVector> creep_to_equilibrium(const StaticProblem& problem, const JointVector& start) {
  const double tolerance = residual_tolerance * problem.torque_scale;
  JointVector angles = start;
  JointVector residual = problem.residual(angles);
  double shift = 0.0;
  for (int i = 0; i < most_newton_steps; ++i) {
    const JointMatrix stiffness = problem.stiffness(angles);
    if (!stiffness.allFinite() || !residual.allFinite()) return std::nullopt;
    const std::optional<JointVector> newton = shifted_step(stiffness, 0.0, residual);
    if (newton && newton->lpNorm<Eigen::Infinity>() <= largest_step) {
      const JointVector next = angles + *newton;
      const JointVector next_residual = problem.residual(next);
      if (next_residual.norm() < 0.9 * residual.norm() || next_residual.norm() <= tolerance) {
        angles = next;
        residual = next_residual;
        if (residual.norm() <= tolerance) return angles;
        continue;
      }
    }
    // Where Newton does not serve, creep: an implicit step is a finite time of the gradient flow. Along it the residual
    // may grow a little (past an inflection) but not leap, which is how a step over a contact's kink shows.
    shift = std::max(shift * 0.25, problem.torque_scale * 1e-2);
    for (;; shift *= 4.0) {
      const JointVector next = angles + flow_step(stiffness, shift, residual);
      JointVector next_residual = problem.residual(next);
      if (next_residual.norm() > 1.2 * residual.norm() && shift < 1e9 * problem.torque_scale) continue;
      angles = next;
      residual = std::move(next_residual);
      break;
    }
    if (angles.lpNorm<Eigen::Infinity>() > std::numbers::pi) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<JointVector> find_equilibrium(const actuator::Model& model, const actuator::CoilCurrents& currents,
                                            const JointVector& start) {
  return creep_to_equilibrium(
      {.residual = [&](const JointVector& angles) { return model.static_residual(angles, currents); },
       .stiffness = [&](const JointVector& angles) { return model.tangent_stiffness(angles, currents); },
       .torque_scale = torque_scale(model)},
      start);
}

std::vector<JointVector> stable_equilibria(const actuator::Model& model, const actuator::CoilCurrents& currents) {
  constexpr double starts[] = {-2.0 * units::degree, 20.0 * units::degree, 60.0 * units::degree, 110.0 * units::degree};
  const int n = model.joints();
  const int poses = n >= 4 ? 256 : 1 << (2 * n);
  std::vector<JointVector> found;
  for (int pose = 0; pose < poses; ++pose) {
    JointVector start(n);
    // Joints beyond the fourth repeat the pattern: symmetric poses matter more than every combination.
    for (int j = 0; j < n; ++j) start[j] = starts[(pose >> (2 * (j % 4))) & 3];
    const std::optional<JointVector> end = find_equilibrium(model, currents, start);
    if (!end) continue;
    const bool known = std::ranges::any_of(
        found, [&](const JointVector& other) { return (other - *end).lpNorm<Eigen::Infinity>() < 1e-6; });
    if (!known) found.push_back(*end);
  }
  std::ranges::sort(found, {}, [](const JointVector& angles) { return angles.sum(); });
  return found;
}

}  // namespace coilwright::simulation
