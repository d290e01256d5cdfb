#include <algorithm>
#include <array>

#include "actuator/effects/effect_rows.hpp"

namespace coilwright::actuator::effects {
namespace {

constexpr std::array attracting_sides = {-1.0, 1.0};

// The matter is as large as half its distance: keeps the pull finite and smooth where the angle reaches it.
constexpr double size = 0.5;

// How much stronger the pull is at that angle than at zero.
double growth(double angle, double range, double side) {
  const double distance = 1.0 - side * angle / range;
  const double closeness = (1.0 + size * size) / (distance * distance + size * size);
  return closeness * closeness;
}

// As strong where the motion comes nearest to the matter as another effect anywhere: a pull that is so strong at zero
// tears the finger over to it.
Starts attraction_starts(const RigScale& scale) {
  Starts out;
  for (const double side : attracting_sides) {
    const double reached = side > 0.0 ? scale.upper_angle : scale.lower_angle;
    const double beyond = std::max(30.0 / degrees, 0.8 * side * reached);
    for (const double range : log_spread(beyond, std::max(90.0 / degrees, 2.0 * beyond), 3)) {
      const double nearest = side * std::clamp(side * reached, 0.0, range);
      out.push_back({0.05 * scale.torque / growth(nearest, range, side), range, side});
    }
  }
  return out;
}

}  // namespace

EffectProperties static_attraction() {
  return {.id = "static_attraction",
          .stage = Stage::magnetics,
          .description = "iron or another magnet nearby pulls or pushes without any current",
          .equation = "q_1 += a ((1 + c^2)/((1 - s theta_1/r)^2 + c^2))^2, c = 1/2",
          .source =
              "a dipole's force on its image in iron falls with the fourth power of the distance (Jackson, Classical "
              "Electrodynamics, ch. 5); c is a choice",
          .check = "look for iron or another magnet near the finger, take it away and film one release again",
          .parameters = {about_zero("torque_Nmm", "torque at angle zero, opening positive"),
                         {.key = "range_deg",
                          .text = "angle from zero to where the matter is",
                          .lower = 5.0 / degrees,
                          .upper = 180.0 / degrees},
                         {.key = "side",
                          .text = "where the matter is: 1 opening, -1 closing",
                          .lower = -1.0,
                          .upper = 1.0,
                          .choices = attracting_sides}},
          .starts = attraction_starts,
          // The magnet nearest the base, on the first link, is what iron attracts; a coil without current is copper.
          .build =
              [](Values values, ModelSpec& /*spec*/) {
                return added_torque([torque = values[0], range = values[1], side = values[2]](
                                        const EffectTerm::Kinematics& motion, mechanics::JointVector& torques) {
                  torques[0] += torque * growth(motion.angles[0], range, side);
                });
              },
          // A rig without coils can have iron beside it as well as any other.
          .inapplicable = [](const ModelSpec& /*spec*/) { return std::optional<std::string>(); }};
}

}  // namespace coilwright::actuator::effects
