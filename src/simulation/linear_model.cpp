#include "coilwright/simulation/linear_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/pressed_joints.hpp"
#include "coilwright/units/angle.hpp"
#include "linear_system.hpp"

namespace coilwright::simulation {
namespace {

using actuator::CoilCurrents;
using actuator::Model;
using mechanics::JointVector;

// "1.4 A", or "1.4 and -0.3 A" where they differ.
std::string text_of(const CoilCurrents& currents) {
  std::vector<std::string> values;
  for (const double each : currents)
    if (values.empty() || (currents.array() != currents[0]).any()) values.push_back(fmt::format("{:.6g}", each));
  return fmt::format("{} A", fmt::join(values, " and "));
}

void require_linearisable(const Model& model, const CoilCurrents& currents) {
  for (const double current : currents)
    if (!std::isfinite(current)) throw std::invalid_argument(fmt::format("current must be finite; got {} A", current));
  if (model.coils() == 0) throw std::invalid_argument("has no coils to drive");
  if (currents.size() != model.coils())
    throw std::invalid_argument(
        fmt::format("has {} coils; a current for each is needed, got {}", model.coils(), currents.size()));
  for (int i = 0; i < model.internal_states(); ++i)
    if (model.is_of_a_body(i))
      throw std::invalid_argument("has an effect with a body of its own, which a linear model leaves out");
}

JointVector equilibrium_under(const Model& model, const CoilCurrents& currents) {
  const auto rest = find_equilibrium(model, model.all_coils(0.0), JointVector::Zero(model.joints()));
  if (!rest) throw std::runtime_error("has no stable pose without current to start from");
  const auto found = find_equilibrium(model, currents, *rest);
  if (!found)
    throw std::runtime_error(fmt::format("has no stable pose under {} to be linearised at", text_of(currents)));
  return *found;
}

// Beyond its curve a pair's torque goes on as a straight line, which no measurement and no theory has. Below, where it
// starts, faces press: they give way by hundredths of a degree.
void require_known_torque(const Model& model, const JointVector& angles, const CoilCurrents& currents) {
  for (const actuator::HingePair& pair : model.magnetics().hinge_pairs()) {
    const double last = pair.torque_per_ampere->upper();
    if (angles[pair.joint] > last)
      throw std::runtime_error(
          fmt::format("rests with joint {} at {:.4g} deg under {}, and its torque is known up to "
                      "{:.4g} deg",
                      pair.joint + 1, angles[pair.joint] * units::degrees_per_radian, text_of(currents),
                      last * units::degrees_per_radian));
  }
}

}  // namespace

bool LinearModel::stable() const {
  return std::ranges::all_of(eigenvalues, [](const std::complex<double>& value) { return value.real() < 0.0; });
}

LinearModel linearise(const Model& model, const CoilCurrents& currents) {
  require_linearisable(model, currents);
  const JointVector angles = equilibrium_under(model, currents);
  require_known_torque(model, angles, currents);
  const LinearSystem system = linear_system(model, angles, currents);
  const int n = model.joints();
  const Eigen::Index size = system.matrix.rows();

  LinearModel out{.angles = angles,
                  .currents = currents,
                  .a = system.matrix,
                  .b = slopes_by_currents(model, angles, currents, system),
                  .c = Eigen::MatrixXd::Zero(1 + n, size),
                  .d = Eigen::MatrixXd::Zero(1 + n, currents.size()),
                  .effect_states = system.relaxing,
                  .modes = modes(model, angles, currents),
                  .eigenvalues = {},
                  .dc_gain = {},
                  .sticks = system.sticks,
                  .pressed_joints = pressed_joints(model, angles)};
  out.c.topLeftCorner(1, n).setOnes();
  out.c.bottomLeftCorner(n, n).setIdentity();
  const Eigen::VectorXcd values = system.eigenvalues();
  out.eigenvalues.assign(values.begin(), values.end());
  const Eigen::FullPivLU<Eigen::MatrixXd> factor(out.a);
  if (factor.isInvertible()) out.dc_gain = out.d - out.c * factor.solve(out.b);
  return out;
}

LinearModel linearise(const Model& model, double current) {
  LinearModel out = linearise(model, model.all_coils(current));
  const CoilCurrents shares = model.current_shares();
  out.b = (out.b * shares).eval();
  out.d = (out.d * shares).eval();
  if (out.dc_gain) *out.dc_gain = (*out.dc_gain * shares).eval();
  return out;
}

}  // namespace coilwright::simulation
