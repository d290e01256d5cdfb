#include "systems/motional_effect.hpp"

#include <Eigen/Cholesky>

namespace coilwright::systems {

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

}  // namespace coilwright::systems
