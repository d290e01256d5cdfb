#pragma once

#include <string_view>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/model.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/drive/coil_bank.hpp"
#include "coilwright/drive/driver.hpp"
#include "coilwright/systems/driven_actuator.hpp"

namespace coilwright::systems {

inline constexpr double copper_melts = 1085.0;  ///< degC, CRC Handbook

/// The coils of `count` >= 1 like actuators on one driver, those of one actuator after those of the other. Between
/// actuators there is no mutual inductance.
[[nodiscard]] drive::CoilBank of_like_actuators(const drive::CoilBank& one, int count);

/// Of the straight actuator: a coil whose torque per ampere is g sees the voltage g . omega, and the currents i that
/// all of these drive through coils and driver damp the motion by g i (Woodson and Melcher, Electromechanical Dynamics,
/// 1968, ch. 3). The driver is taken as closed by its resistance while on; actuators that share it move alike.
[[nodiscard]] MotionalEffect motional_effect(const actuator::Assembly& assembly, const drive::CoilBank& bank,
                                             const drive::Driver& driver);

/// Matrix over the coils of an actuator; no heap.
using CoilMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mechanics::max_joints + 1,
                                 mechanics::max_joints + 1>;

/// The coils of one actuator on one path of a driver. The driver's current is I = entry . i, and
///   di/dt = response (voltage entry - diag(resistances) i - resistance I entry - induced by motion).
/// In parallel every entry is 1 and the response is L^-1; in series all coils have one current, every entry is 1/n and
/// the response 11^T / (1^T L 1). With the driver open, I stays as it is.
struct CoilLoop {
  actuator::CoilCurrents resistances;  ///< of the coils, ohm
  CoilMatrix response;                 ///< 1/H
  actuator::CoilCurrents entry;        ///< dimensionless
  double voltage{};                    ///< of the driver, V
  double resistance{};                 ///< of the driver, ohm
};

/// The loop of a bank that keeps its rules (drive::reduce checks them), with nothing driving it.
[[nodiscard]] CoilLoop loop_of(const drive::CoilBank& bank);

/// The loop of an actuator's bank on a path of a driver that as many `actuators` share, alike and moving alike: in
/// parallel each sees as many times the driver's resistance, in series that part of its voltage and resistance.
[[nodiscard]] CoilLoop on_path(const drive::CoilBank& bank, const drive::Path& path, int actuators);

/// A loop with the driver open: I does not change. Coils in parallel may still drive currents round each other.
[[nodiscard]] CoilLoop opened(CoilLoop loop);

/// The coils' currents as states of a model, with what motion induces in them by the model's own torques per ampere g_j
/// of each joint: sum g_j omega_j (Woodson and Melcher, Electromechanical Dynamics, 1968, ch. 3), so that what the
/// circuit loses the chain gains. States, all of one actuator: the currents, then Integral by Integral.
struct DrivenCoils final : actuator::DescribedEffect {
  /// What is integrated beside the currents, in this order after them.
  enum Integral {
    charge,  ///< of the driver's current, A s
    square,  ///< of its square, A^2 s
    heat,    ///< in the coils, J
    work,    ///< done on the chain, J
    integrals
  };

  /// Keeps the loop.
  explicit DrivenCoils(CoilLoop loop);
};

/// Throws std::invalid_argument where the model has an effect of a stage up to `last`, which acts `on` what follows
/// from a driver here.
void require_no_effects_up_to(const actuator::Model& model, actuator::Stage last, std::string_view on);

/// What motion induces in each coil, V, against the current that opens the joints: sum over the joints of torque per
/// ampere and rate. `pairs` are actuator::coil_magnet_pairs().
[[nodiscard]] actuator::CoilCurrents induced(const actuator::MagneticStage& pairs, int coils,
                                             const actuator::EffectTerm::Kinematics& motion);

}  // namespace coilwright::systems
