#include "coilwright/simulation/modes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>

namespace coilwright::simulation {
namespace {

constexpr int most_states = 2 * mechanics::max_joints;
using StateMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_states, most_states>;

}  // namespace

std::vector<Mode> modes(const actuator::Model& model, const mechanics::JointVector& angles,
                        const actuator::CoilCurrents& currents) {
  const int n = model.joints();
  const Eigen::LLT<mechanics::JointMatrix> mass(model.chain().mass_matrix(angles));
  StateMatrix companion = StateMatrix::Zero(2 * n, 2 * n);
  companion.topRightCorner(n, n).setIdentity();
  companion.bottomLeftCorner(n, n) = -mass.solve(model.tangent_stiffness(angles, currents));
  mechanics::JointMatrix damping = mechanics::JointMatrix::Zero(n, n);
  damping.diagonal() = model.damping(angles);
  companion.bottomRightCorner(n, n) = -mass.solve(damping);

  const Eigen::EigenSolver<StateMatrix> solver(companion, false);
  std::vector<Mode> out;
  for (int i = 0; i < 2 * n; ++i) {
    const std::complex<double> value = solver.eigenvalues()[i];
    if (value.imag() < 0.0) continue;  // its conjugate stands for both
    const double size = std::abs(value);
    out.push_back({.natural_frequency = size / (2.0 * std::numbers::pi),
                   .damping_ratio = size > 0.0 ? -value.real() / size : 0.0});
  }
  std::ranges::sort(out, {}, &Mode::natural_frequency);
  return out;
}

}  // namespace coilwright::simulation
