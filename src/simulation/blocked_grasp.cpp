#include "coilwright/simulation/blocked_grasp.hpp"

#include <algorithm>
#include <cmath>

#include "coilwright/simulation/equilibrium.hpp"

namespace coilwright::simulation {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;

// How exactly the tip stays on the wall, relative to its lever: far below a micrometre.
constexpr double wall_tolerance = 1e-11;

// The wall as a spring of finite stiffness that starts from a known force: the augmented Lagrangian of the constraint.
// Its equilibria are stable ones of the finger on the wall, and it lets go by itself where the finger leaves.
struct Wall {
  const actuator::Model& model;
  double position;   // x of the wall, m
  double stiffness;  // N/m

  [[nodiscard]] double penetration(const JointVector& angles) const {
    return model.chain().position(model.tip(), angles).x() - position;
  }
  [[nodiscard]] double force(double known, const JointVector& angles) const {
    return std::max(0.0, known + stiffness * penetration(angles));
  }
  [[nodiscard]] JointVector slope(const JointVector& angles) const {
    return model.chain().jacobian(model.tip(), angles).row(0).transpose();
  }
  // d2(tip x)/dtheta2 by central differences of its slope; step^2 / 6 relative.
  [[nodiscard]] JointMatrix curvature(const JointVector& angles) const {
    constexpr double step = 1e-5;
    const int n = model.joints();
    JointMatrix out(n, n);
    for (int j = 0; j < n; ++j) {
      JointVector ahead = angles;
      JointVector behind = angles;
      ahead[j] += step;
      behind[j] -= step;
      out.col(j) = (slope(ahead) - slope(behind)) / (2.0 * step);
    }
    return out;
  }
};

StaticProblem pressed(const Wall& wall, const actuator::CoilCurrents& currents, double known) {
  return {.residual =
              [&wall, &currents, known](const JointVector& angles) {
                return JointVector(wall.model.static_residual(angles, currents) -
                                   wall.force(known, angles) * wall.slope(angles));
              },
          .stiffness =
              [&wall, &currents, known](const JointVector& angles) {
                JointMatrix out = wall.model.tangent_stiffness(angles, currents);
                const double force = wall.force(known, angles);
                if (force <= 0.0) return out;
                const JointVector across = wall.slope(angles);
                out += wall.stiffness * across * across.transpose() + force * wall.curvature(angles);
                return out;
              },
          .torque_scale = torque_scale(wall.model)};
}

}  // namespace

std::optional<BlockedGrasp> blocked_grasp(const actuator::Model& model, const actuator::CoilCurrents& currents) {
  const JointVector straight = JointVector::Zero(model.joints());
  Wall wall{.model = model, .position = model.chain().position(model.tip(), straight).x(), .stiffness = 0.0};
  const double lever = wall.slope(straight).lpNorm<Eigen::Infinity>();
  // A hundred times what the finger can bring to bear over a radian: each pass below takes two digits off the
  // penetration, and the first one stays shallow enough not to pass through the wall.
  const double drive = model.static_residual(straight, currents).lpNorm<Eigen::Infinity>();
  wall.stiffness = 100.0 * std::max(torque_scale(model), 10.0 * drive) / (lever * lever);
  JointVector angles = straight;
  double force = 0.0;
  for (int pass = 0; pass < 50; ++pass) {
    const std::optional<JointVector> next = creep_to_equilibrium(pressed(wall, currents, force), angles);
    if (!next) return std::nullopt;
    angles = *next;
    const double before = force;
    force = wall.force(force, angles);
    if (force == 0.0 && before == 0.0) return BlockedGrasp{.force = 0.0, .angles = angles};
    if (std::abs(wall.penetration(angles)) <= wall_tolerance * lever)
      return BlockedGrasp{.force = force, .angles = angles};
  }
  return std::nullopt;
}

}  // namespace coilwright::simulation
