#include "linear_system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace coilwright::simulation {
namespace {

using actuator::CoilCurrents;
using actuator::InternalStates;
using actuator::Model;
using mechanics::JointMatrix;
using mechanics::JointVector;

// 1/s: a state that comes back is faster by far, one that does not is at rest to the last bit.
constexpr double no_relaxation = 1e-12;

// Accelerations and slopes of the effects' states, one above the other.
class Slopes {
 public:
  Slopes(const Model& model, const CoilCurrents& currents) : model_(model), currents_(currents) {}

  [[nodiscard]] Eigen::VectorXd operator()(const JointVector& angles, const JointVector& rates,
                                           const InternalStates& internal) const {
    JointVector accelerations;
    InternalStates slopes = InternalStates::Zero(internal.size());
    const auto count = static_cast<std::size_t>(internal.size());
    model_.derivative(angles, rates, {internal.data(), count}, currents_, JointVector::Zero(angles.size()),
                      accelerations, {slopes.data(), count});
    Eigen::VectorXd both(angles.size() + internal.size());
    both << accelerations, slopes;
    return both;
  }

 private:
  const Model& model_;
  const CoilCurrents& currents_;
};

// Central difference of `function` of one entry of `at`, by a step of `share` of it or of 1.
template <typename Vector, typename Function>
Eigen::VectorXd slope_by(Vector at, Eigen::Index entry, double share, const Function& function) {
  const double centre = at[entry];
  const double step = share * std::max(1.0, std::abs(centre));
  at[entry] = centre + step;
  Eigen::VectorXd difference = function(at);
  at[entry] = centre - step;
  difference -= function(at);
  return difference / (2.0 * step);
}

}  // namespace

LinearSystem linear_system(const Model& model, const JointVector& angles, const CoilCurrents& currents) {
  constexpr double angle_step = 1e-5;
  constexpr double state_step = 1e-6;
  const int n = model.joints();
  const int m = model.internal_states();
  const JointVector still = JointVector::Zero(n);
  const InternalStates settled = model.settled(angles, currents);
  const Slopes slopes(model, currents);

  // Of every state: by how much accelerations and slopes change with it.
  std::vector<Eigen::VectorXd> by_state;
  std::vector<int> relaxing;
  int of_bodies = 0;
  for (int i = 0; i < m; ++i) {
    by_state.push_back(
        slope_by(settled, i, state_step, [&](const InternalStates& states) { return slopes(angles, still, states); }));
    if (model.is_of_a_body(i))
      ++of_bodies;
    else if (std::abs(by_state.back()[n + i]) > no_relaxation)
      relaxing.push_back(i);
  }
  const int r = static_cast<int>(relaxing.size());

  LinearSystem out{.matrix = Eigen::MatrixXd::Zero(2 * n + r, 2 * n + r),
                   .relaxing = r,
                   .sticks = r + of_bodies < m,
                   .relaxing_states = relaxing};
  const Eigen::LLT<JointMatrix> mass(model.chain().mass_matrix(angles));
  out.matrix.block(0, n, n, n).setIdentity();
  out.matrix.block(n, 0, n, n) = -mass.solve(model.tangent_stiffness(angles, currents));
  out.matrix.block(n, n, n, n) = -mass.solve(model.damping(angles, currents));
  for (int k = 0; k < r; ++k) {
    const Eigen::VectorXd& effect = by_state[static_cast<std::size_t>(relaxing[k])];
    out.matrix.block(n, 2 * n + k, n, 1) = effect.head(n);
    for (int i = 0; i < r; ++i) out.matrix(2 * n + i, 2 * n + k) = effect[n + relaxing[i]];
  }
  for (int j = 0; j < n && r > 0; ++j) {
    const Eigen::VectorXd by_angle =
        slope_by(angles, j, angle_step, [&](const JointVector& at) { return slopes(at, still, settled); });
    const Eigen::VectorXd by_rate =
        slope_by(still, j, angle_step, [&](const JointVector& at) { return slopes(angles, at, settled); });
    const Eigen::VectorXd moved =
        slope_by(angles, j, angle_step, [&](const JointVector& at) { return model.settled(at, currents); });
    for (int i = 0; i < r; ++i) {
      out.matrix(2 * n + i, j) = by_angle[n + relaxing[i]];
      out.matrix(2 * n + i, n + j) = by_rate[n + relaxing[i]];
      // The tangent stiffness is that with the states settled anew; here they are held.
      out.matrix.block(n, j, n, 1) -= out.matrix.block(n, 2 * n + i, n, 1) * moved[relaxing[i]];
    }
  }
  return out;
}

Eigen::MatrixXd slopes_by_currents(const Model& model, const JointVector& angles, const CoilCurrents& currents,
                                   const LinearSystem& system) {
  constexpr double current_step = 1e-6;
  const int n = model.joints();
  const JointVector still = JointVector::Zero(n);
  const InternalStates settled = model.settled(angles, currents);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(system.matrix.rows(), currents.size());
  for (Eigen::Index coil = 0; coil < currents.size(); ++coil) {
    const Eigen::VectorXd all = slope_by(currents, coil, current_step, [&](const CoilCurrents& at) {
      return Slopes(model, at)(angles, still, settled);
    });
    out.col(coil).segment(n, n) = all.head(n);
    for (int k = 0; k < system.relaxing; ++k)
      out(2 * n + k, coil) = all[n + system.relaxing_states[static_cast<std::size_t>(k)]];
  }
  return out;
}

Eigen::VectorXcd LinearSystem::eigenvalues() const {
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
}

LinearSystem::Decomposition LinearSystem::decomposition() const {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
  Eigen::MatrixXcd right = solver.eigenvectors();
  Eigen::MatrixXcd left = right.inverse();
  return {.values = solver.eigenvalues(), .right = std::move(right), .left = std::move(left)};
}

}  // namespace coilwright::simulation
