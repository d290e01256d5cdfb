#include <algorithm>
#include <array>

#include "actuator/effects/effect_rows.hpp"

namespace coilwright::actuator::effects {
namespace {

using mechanics::FaceContact;

constexpr std::array sides = {-1.0, 1.0};

// A stop on which a joint rings faster than this, rad/s, looks the same to a camera and costs ever shorter steps: it is
// taken as this stiff.
constexpr double fastest_ring = 5e3;

class StopTerm final : public EffectTerm {
 public:
  StopTerm(std::vector<FaceContact> stops, double side) : stops_(std::move(stops)), side_(side) {}

  // An opening limit is a closing one seen from the other side.
  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView /*own*/,
                   mechanics::JointVector& torques) const override {
    for (std::size_t j = 0; j < stops_.size(); ++j) {
      const int at = static_cast<int>(j);
      torques[at] -= side_ * stops_[j].torque(-side_ * motion.angles[at], -side_ * motion.rates[at]);
    }
  }

  void add_damping(const Kinematics& motion, const CoilCurrents& /*strength*/,
                   mechanics::JointMatrix& damping) const override {
    for (std::size_t j = 0; j < stops_.size(); ++j) {
      const int at = static_cast<int>(j);
      if (-side_ * motion.angles[at] < stops_[j].closing_angle) damping(at, at) += stops_[j].damping;
    }
  }

 private:
  std::vector<FaceContact> stops_;  // in the mirrored angle -side theta
  double side_;
};

constexpr EffectParameter stop_angle{.key = "angle_deg",
                                     .text = "joint angle at which the stop is met, every joint",
                                     .lower = -180.0 / degrees,
                                     .upper = 180.0 / degrees};

// A fit sees a stop only where the motion presses it: from close inside either end of the motion inwards.
Starts stop_starts(const RigScale& scale) {
  const double range = scale.upper_angle - scale.lower_angle;
  const double stiffness = 10.0 * scale.torque / scale.angle;
  Starts out;
  for (const double side : sides) {
    const double end = side > 0.0 ? scale.upper_angle : scale.lower_angle;
    for (const double inwards : {0.03, 0.15, 0.35}) {
      const double angle = end - side * inwards * range;
      out.push_back({std::clamp(angle, stop_angle.lower, stop_angle.upper), stiffness, side});
    }
  }
  return out;
}

}  // namespace

EffectProperties end_stop() {
  return {.id = "end_stop",
          .stage = Stage::hinge,
          .description = "something stops the joints: a limit, a cable, segments that meet",
          .equation = "q -= s max(0, k p + b p'), p = s (theta - theta_c) > 0, b = 0.6 sqrt(k/mobility)",
          .source = "Kelvin-Voigt contact that never pulls: as mechanics::FaceContact",
          .check = "bend the finger by hand and feel for a stop; look for a cable, or segments that touch",
          .parameters = {stop_angle,
                         from_zero("stiffness_Nmm_rad", "of the stop"),
                         {.key = "side",
                          .text = "1: limits opening, -1: limits closing",
                          .lower = -1.0,
                          .upper = 1.0,
                          .choices = sides}},
          .starts = stop_starts,
          .build = [](Values values, ModelSpec& spec) -> Term {
            const double side = values[2];
            const mechanics::JointVector mobility = spec.chain.joint_mobility();
            std::vector<FaceContact> stops;
            for (const double m : mobility) {
              const double stiffness = std::min(values[1], fastest_ring * fastest_ring / m);
              stops.push_back({.closing_angle = -side * values[0],
                               .stiffness = stiffness,
                               .damping = mechanics::contact_damping(stiffness, m)});
            }
            return std::make_unique<StopTerm>(std::move(stops), side);
          }};
}

}  // namespace coilwright::actuator::effects
