#include "systems/driven_coils.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <stdexcept>
#include <utility>

#include "coilwright/actuator/parts/coil_magnet_pairs.hpp"

namespace coilwright::systems {
namespace {

using actuator::CoilCurrents;
using actuator::MagneticStage;
using mechanics::JointVector;

class CoilsTerm final : public actuator::EffectTerm {
 public:
  CoilsTerm(CoilLoop loop, MagneticStage pairs) : loop_(std::move(loop)), pairs_(std::move(pairs)) {}

  int states() const override { return coils() + DrivenCoils::integrals; }

  void magnetize(InternalStateView own, const CoilCurrents& /*currents*/, CoilCurrents& strength) const override {
    strength = Eigen::Map<const Eigen::VectorXd>(own.states, coils());
    if (own.slopes == nullptr) return;
    const double driver = loop_.entry.dot(strength);
    const CoilCurrents dropped = loop_.resistances.cwiseProduct(strength);
    const CoilCurrents left = (loop_.voltage - loop_.resistance * driver) * loop_.entry - dropped;
    slopes(own).noalias() = loop_.response * left;
    own.slopes[coils() + DrivenCoils::charge] = driver;
    own.slopes[coils() + DrivenCoils::square] = driver * driver;
    own.slopes[coils() + DrivenCoils::heat] = dropped.dot(strength);
  }

  void add_torques(const Kinematics& motion, const CoilCurrents& strength, InternalStateView own,
                   JointVector& /*torques*/) const override {
    if (own.slopes == nullptr) return;
    const CoilCurrents voltages = induced(pairs_, coils(), motion);
    slopes(own).noalias() -= loop_.response * voltages;
    own.slopes[coils() + DrivenCoils::work] = voltages.dot(strength);
  }

 private:
  int coils() const { return static_cast<int>(loop_.entry.size()); }
  Eigen::Map<Eigen::VectorXd> slopes(InternalStateView own) const { return {own.slopes, loop_.entry.size()}; }

  CoilLoop loop_;
  MagneticStage pairs_;
};

}  // namespace

drive::CoilBank of_like_actuators(const drive::CoilBank& one, int count) {
  const Eigen::Index coils = one.resistances.size();
  drive::CoilBank all{.resistances = one.resistances.replicate(count, 1),
                      .inductances = Eigen::MatrixXd::Zero(coils * count, coils * count),
                      .wiring = one.wiring};
  for (int i = 0; i < count; ++i) all.inductances.block(i * coils, i * coils, coils, coils) = one.inductances;
  return all;
}

MotionalEffect motional_effect(const actuator::Assembly& assembly, const drive::CoilBank& bank,
                               const drive::Driver& driver) {
  const actuator::Model& model = assembly.model;
  const mechanics::JointVector straight = mechanics::JointVector::Zero(model.joints());
  const mechanics::JointVector without = model.magnetic_torques(straight, model.all_coils(0.0));
  const Eigen::Index coils = bank.resistances.size();
  // Voltage of each coil of every actuator while all joints open at one radian a second.
  Eigen::VectorXd voltages(coils);
  for (Eigen::Index i = 0; i < coils; ++i) {
    actuator::CoilCurrents unit = model.all_coils(0.0);
    unit[i % assembly.coils] = 1.0;
    voltages[i] = (model.magnetic_torques(straight, unit) - without).sum();
  }
  const double common = driver.on.resistance + driver.on.supply_resistance;
  MotionalEffect out{.joint_damping = model.damping(straight).sum()};
  double power = 0.0;
  if (bank.wiring == drive::BankWiring::series) {
    out.emf_per_rate = voltages.sum();
    power = voltages.sum() * voltages.sum() / (bank.resistances.sum() + common);
  } else {
    // Each coil has its own current; what the driver feels is their sum.
    Eigen::MatrixXd loops = Eigen::MatrixXd::Constant(coils, coils, common);
    loops.diagonal() += bank.resistances;
    power = voltages.dot(Eigen::LLT<Eigen::MatrixXd>(loops).solve(voltages));
    const Eigen::VectorXd conductances = bank.resistances.cwiseInverse();
    out.emf_per_rate = conductances.dot(voltages) / conductances.sum();
  }
  out.damping = power * assembly.coils / static_cast<double>(coils);
  return out;
}

CoilLoop loop_of(const drive::CoilBank& bank) {
  const Eigen::Index coils = bank.resistances.size();
  CoilLoop loop{.resistances = bank.resistances, .response = {}, .entry = CoilCurrents::Ones(coils)};
  if (bank.wiring == drive::BankWiring::parallel) {
    loop.response = Eigen::LLT<Eigen::MatrixXd>(bank.inductances).solve(Eigen::MatrixXd::Identity(coils, coils));
  } else {
    loop.response = CoilMatrix::Constant(coils, coils, 1.0 / bank.inductances.sum());
    loop.entry /= static_cast<double>(coils);
  }
  return loop;
}

CoilLoop on_path(const drive::CoilBank& bank, const drive::Path& path, int actuators) {
  const bool series = bank.wiring == drive::BankWiring::series;
  CoilLoop loop = loop_of(bank);
  loop.voltage = (path.source - path.diodes) / (series ? actuators : 1);
  loop.resistance = (path.resistance + path.supply_resistance) * (series ? 1.0 / actuators : actuators);
  return loop;
}

CoilLoop opened(CoilLoop loop) {
  const CoilCurrents answer = loop.response * loop.entry;
  const CoilMatrix taken = answer * answer.transpose() / loop.entry.dot(answer);
  loop.response -= taken;
  loop.voltage = loop.resistance = 0.0;
  return loop;
}

void require_no_effects_up_to(const actuator::Model& model, actuator::Stage last, std::string_view on) {
  for (const actuator::Effect& effect : model.nominal_spec().effects)
    if (effect.kind->stage() <= last)
      throw std::invalid_argument(
          fmt::format("effect {}: acts on {}, which follow from the driver here", effect.kind->id(), on));
}

CoilCurrents induced(const MagneticStage& pairs, int coils, const actuator::EffectTerm::Kinematics& motion) {
  CoilCurrents voltages(coils);
  CoilCurrents unit = CoilCurrents::Zero(coils);
  JointVector torque(motion.angles.size());
  for (int c = 0; c < coils; ++c) {
    unit[c] = 1.0;
    torque.setZero();
    pairs.add_torques(motion.chain, motion.angles, unit, torque);
    voltages[c] = torque.dot(motion.rates);
    unit[c] = 0.0;
  }
  return voltages;
}

DrivenCoils::DrivenCoils(CoilLoop loop)
    : DescribedEffect(
          {.id = "driven_coils",
           .stage = actuator::Stage::magnetics,
           .description = "a driver's voltage drives the currents against resistance, inductance and motion",
           .equation = "L i' = u - R i - g . omega for each coil, g = dq/di",
           .source = "Woodson and Melcher, Electromechanical Dynamics, 1968, ch. 3",
           .starts = [](const actuator::RigScale& /*scale*/) { return std::vector<std::vector<double>>{{}}; },
           .build =
               [loop = std::move(loop)](std::span<const double> /*values*/, actuator::ModelSpec& spec) {
                 return std::make_unique<CoilsTerm>(loop, coil_magnet_pairs(spec.magnetics));
               }}) {}

}  // namespace coilwright::systems
