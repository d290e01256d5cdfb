#include "coilwright/simulation/blocked_grasp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/units/angle.hpp"

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
  mechanics::LinkPoint contact;
  double position;   // x of the wall, m
  double stiffness;  // N/m

  [[nodiscard]] double penetration(const JointVector& angles) const {
    return model.chain().position(contact, angles).x() - position;
  }
  [[nodiscard]] double force(double known, const JointVector& angles) const {
    return std::max(0.0, known + stiffness * penetration(angles));
  }
  [[nodiscard]] JointVector slope(const JointVector& angles) const {
    return model.chain().jacobian(contact, angles).row(0).transpose();
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

void check(double value, const char* name, const char* unit) {
  if (!std::isfinite(value) || value < 0.0)
    throw std::invalid_argument(fmt::format("{} must be finite and >= 0; got {} {}", name, value, unit));
}

mechanics::LinkPoint contact_of(const actuator::Model& model, const actuator::GraspPoint& grasp) {
  mechanics::LinkPoint contact = model.tip();
  if (!grasp.height) return contact;
  check(*grasp.height, "grasp height", "m");
  // Rounding of a length in millimetres aside.
  if (*grasp.height > contact.along * (1.0 + 1e-9))
    throw std::invalid_argument(
        fmt::format("grasp height must not lie beyond the tip, {:.6g} mm from its joint; got {:.6g} mm",
                    contact.along * 1e3, *grasp.height * 1e3));
  contact.along = *grasp.height;
  return contact;
}

JointVector bent_alike(const actuator::Model& model, double bending) {
  return JointVector::Constant(model.joints(), bending / model.joints());
}

// The bending up to `end` at which the contact of a finger that bends in all joints alike is as far out as it gets;
// infinite if it goes on outwards. Its x is a sum of a few waves that are slow beside the step.
double farthest_out(const actuator::Model& model, const mechanics::LinkPoint& contact, double end) {
  constexpr double step = 5.0 * units::degree;
  const auto outwards = [&](double bending) {
    return model.chain().jacobian(contact, bent_alike(model, bending)).row(0).sum();
  };
  for (double low = 0.0; low < end; low += step) {
    const double high = std::min(low + step, end);
    if (outwards(high) > 0.0) continue;
    std::uintmax_t calls = 50;
    const auto tolerance = [](double a, double b) { return std::abs(b - a) < 1e-9; };
    return boost::math::tools::toms748_solve(outwards, low, high, tolerance, calls).first;
  }
  return std::numeric_limits<double>::infinity();
}

JointVector touching_pose(const actuator::Model& model, const mechanics::LinkPoint& contact, double opening) {
  check(opening, "grasp opening", "rad");
  const double farthest = farthest_out(model, contact, opening);
  if (opening >= farthest)
    throw std::invalid_argument(
        fmt::format("grasp opening must be less than {:.4g} deg, from where on the contact comes back from the wall "
                    "that it would touch; got {:.6g} deg",
                    farthest / units::degree, opening / units::degree));
  return bent_alike(model, opening);
}

}  // namespace

double wall_position(const actuator::Model& model, const actuator::GraspPoint& grasp) {
  const mechanics::LinkPoint contact = contact_of(model, grasp);
  return model.chain().position(contact, touching_pose(model, contact, grasp.opening)).x();
}

std::optional<BlockedGrasp> blocked_grasp(const actuator::Model& model, const actuator::CoilCurrents& currents,
                                          const actuator::GraspPoint& grasp) {
  const mechanics::LinkPoint contact = contact_of(model, grasp);
  const JointVector touching = touching_pose(model, contact, grasp.opening);
  Wall wall{
      .model = model, .contact = contact, .position = model.chain().position(contact, touching).x(), .stiffness = 0.0};
  const double lever = wall.slope(touching).lpNorm<Eigen::Infinity>();
  // A hundred times what the finger can bring to bear over a radian: each pass below takes two digits off the
  // penetration, and the first one stays shallow enough not to pass through the wall.
  const double drive = model.static_residual(touching, currents).lpNorm<Eigen::Infinity>();
  wall.stiffness = 100.0 * std::max(torque_scale(model), 10.0 * drive) / (lever * lever);
  JointVector angles = touching;
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
