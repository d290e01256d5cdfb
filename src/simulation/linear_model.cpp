#include "coilwright/simulation/linear_model.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "coilwright/simulation/equilibrium.hpp"
#include "linear_system.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Model;
using mechanics::JointVector;

void require_linearisable(const Model& model, double current) {
  if (!std::isfinite(current)) throw std::invalid_argument(fmt::format("current must be finite; got {} A", current));
  if (model.coils() == 0) throw std::invalid_argument("has no coils to drive");
  for (int i = 0; i < model.internal_states(); ++i)
    if (model.is_of_a_body(i))
      throw std::invalid_argument("has an effect with a body of its own, which a linear model leaves out");
}

JointVector equilibrium_under(const Model& model, double current) {
  const auto rest = find_equilibrium(model, model.all_coils(0.0), JointVector::Zero(model.joints()));
  if (!rest) throw std::runtime_error("has no stable pose without current to start from");
  const auto found = find_equilibrium(model, model.all_coils(current), *rest);
  if (!found) throw std::runtime_error(fmt::format("has no stable pose under {:.6g} A to be linearised at", current));
  return *found;
}

// Beyond its curve a pair's torque goes on as a straight line, which no measurement and no theory has. Below, where it
// starts, faces press: they give way by hundredths of a degree.
void require_known_torque(const Model& model, const JointVector& angles, double current) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  for (const actuator::HingePair& pair : model.magnetics().hinge_pairs()) {
    const double last = pair.torque_per_ampere->upper();
    if (angles[pair.joint] > last)
      throw std::runtime_error(
          fmt::format("rests with joint {} at {:.4g} deg under {:.6g} A, and its torque is known up to {:.4g} deg",
                      pair.joint + 1, angles[pair.joint] * degrees, current, last * degrees));
  }
}

std::vector<int> pressed(const Model& model, const JointVector& angles) {
  std::vector<int> out;
  for (int j = 0; j < model.joints(); ++j)
    if (model.hinges()[j].contact.torque(angles[j], 0.0) > 0.0) out.push_back(j);
  return out;
}

}  // namespace

bool LinearModel::stable() const {
  return std::ranges::all_of(eigenvalues, [](const std::complex<double>& value) { return value.real() < 0.0; });
}

LinearModel linearise(const Model& model, double current) {
  require_linearisable(model, current);
  const JointVector angles = equilibrium_under(model, current);
  require_known_torque(model, angles, current);
  const actuator::CoilCurrents currents = model.all_coils(current);
  const LinearSystem system = linear_system(model, angles, currents);
  const int n = model.joints();
  const Eigen::Index size = system.matrix.rows();

  LinearModel out{.angles = angles,
                  .current = current,
                  .a = system.matrix,
                  .b = slopes_by_current(model, angles, currents, system),
                  .c = Eigen::MatrixXd::Zero(1 + n, size),
                  .d = Eigen::VectorXd::Zero(1 + n),
                  .effect_states = system.relaxing,
                  .modes = modes(model, angles, currents),
                  .eigenvalues = {},
                  .dc_gain = {},
                  .sticks = system.sticks,
                  .pressed_joints = pressed(model, angles)};
  out.c.topLeftCorner(1, n).setOnes();
  out.c.bottomLeftCorner(n, n).setIdentity();
  const Eigen::VectorXcd values = system.eigenvalues();
  out.eigenvalues.assign(values.begin(), values.end());
  const Eigen::FullPivLU<Eigen::MatrixXd> factor(out.a);
  if (factor.isInvertible()) out.dc_gain = out.d - out.c * factor.solve(out.b);
  return out;
}

}  // namespace coilwright::simulation
