// An effect of one's own. An effect of Coilwright is such a row in src/actuator/effects and a line in its
// standard_effects.cpp; this one belongs to a program, whose line is `standard_effects().with(reluctance_torque())`.

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace {

using namespace coilwright;
using namespace coilwright::actuator;

constexpr double degrees = 180.0 / std::numbers::pi;

// Soft iron in the magnet's segment (a screw, a back plate) raises the inductance of the coil that faces it, the more
// the further the joint is closed: by L(theta) = 2 L_1 / (1 + exp(theta/r)). The coil pulls the iron towards itself
// whichever way its current flows: q = i^2/2 dL/dtheta.
class ReluctanceTerm final : public EffectTerm {
 public:
  ReluctanceTerm(std::vector<HingePair> pairs, double inductance, double range)
      : pairs_(std::move(pairs)), inductance_(inductance), range_(range) {}

  void add_torques(const Kinematics& motion, const CoilCurrents& strength, InternalStateView /*own*/,
                   mechanics::JointVector& torques) const override {
    for (const HingePair& pair : pairs_) {
      const double current = strength[pair.coil];
      const double width = std::cosh(0.5 * motion.angles[pair.joint] / range_);
      torques[pair.joint] -= 0.5 * current * current * 0.5 * inductance_ / range_ / (width * width);
    }
  }

 private:
  std::vector<HingePair> pairs_;
  double inductance_;
  double range_;
};

// Where a fit starts: a tenth of the torques on this rig, with a short and a long range.
std::vector<std::vector<double>> starts(const RigScale& scale) {
  std::vector<std::vector<double>> out;
  for (const double range : {20.0 / degrees, 60.0 / degrees})
    out.push_back({0.1 * scale.torque * 4.0 * range / (scale.current * scale.current), range});
  return out;
}

}  // namespace

const EffectKind& reluctance_torque() {
  static const DescribedEffect kind(
      {.id = "reluctance_torque",
       .stage = Stage::magnetics,
       .description = "iron beside the magnets is pulled whichever way the current flows",
       .equation = "q_j -= i^2/2 L_1/(2r) / cosh^2(theta_j/(2r))",
       .source = "the force of a coil on iron is half the squared current times the slope of the inductance "
                 "(Woodson and Melcher, Electromechanical Dynamics, 1968, ch. 3); the shape over the angle is a choice",
       .parameters = {{.key = "inductance_mH",
                       .text = "what the iron adds to a coil with the joint straight",
                       .lower = 0.0,
                       .upper = std::numeric_limits<double>::infinity(),
                       .absent = 0.0},
                      {.key = "range_deg",
                       .text = "angle over which that falls by half",
                       .lower = 5.0 / degrees,
                       .upper = 180.0 / degrees}},
       .starts = starts,
       .build = [](std::span<const double> values, ModelSpec& spec) {
         return std::make_unique<ReluctanceTerm>(spec.magnetics.hinge_pairs(), values[0], values[1]);
       }});
  return kind;
}
