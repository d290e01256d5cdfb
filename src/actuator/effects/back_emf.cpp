#include "actuator/effects/effect_rows.hpp"
#include "coilwright/actuator/parts/coil_magnet_pairs.hpp"

namespace coilwright::actuator::effects {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;

class BackEmfTerm final : public EffectTerm {
 public:
  BackEmfTerm(MagneticStage driven, int coils, double conductance)
      : driven_(std::move(driven)), coils_(coils), conductance_(conductance) {}

  // A coil with torques g_j per ampere sees the voltage sum g_j omega_j and drives kappa times it through itself.
  void add_torques(const Kinematics& motion, const CoilCurrents& /*strength*/, InternalStateView /*own*/,
                   JointVector& torques) const override {
    for (int c = 0; c < coils_; ++c) {
      const JointVector per_ampere = torque_per_ampere(motion, c);
      torques -= conductance_ * per_ampere.dot(motion.rates) * per_ampere;
    }
  }

  void add_damping(const Kinematics& motion, const CoilCurrents& /*strength*/, JointMatrix& damping) const override {
    for (int c = 0; c < coils_; ++c) {
      const JointVector per_ampere = torque_per_ampere(motion, c);
      damping += conductance_ * per_ampere * per_ampere.transpose();
    }
  }

 private:
  JointVector torque_per_ampere(const Kinematics& motion, int coil) const {
    CoilCurrents unit = CoilCurrents::Zero(coils_);
    unit[coil] = 1.0;
    JointVector torque = JointVector::Zero(motion.angles.size());
    driven_.add_torques(motion.chain, motion.angles, unit, torque);
    return torque;
  }

  MagneticStage driven_;
  int coils_;
  double conductance_;
};

}  // namespace

EffectProperties back_emf() {
  return {.id = "back_emf",
          .stage = Stage::magnetics,
          .description = "motion drives currents of its own through closed coils or metal nearby",
          .equation = "q -= kappa g (g . omega) for each coil, g = dq/di",
          .source =
              "u = R i + (dq/di) omega: the flux linkage's slope is the torque per ampere (Woodson and Melcher, "
              "Electromechanical Dynamics, 1968, ch. 3)",
          .check = "film a release once with the coils' circuit open and once closed: closed, it dies away faster",
          .parameters = {from_zero("conductance_1_Ohm",
                                   "1/R of a coil under a voltage drive; less what eddy currents leave")},
          .needs_closed_circuit = true,
          .starts = shares_of(
              [](const RigScale& scale) {
                const double per_ampere = scale.torque / scale.current;
                return scale.torque / (per_ampere * per_ampere * scale.rate);
              },
              {0.02, 0.2}),
          .build = [](Values values, ModelSpec& spec) -> Term {
            return std::make_unique<BackEmfTerm>(coil_magnet_pairs(spec.magnetics), spec.coils, values[0]);
          }};
}

}  // namespace coilwright::actuator::effects
