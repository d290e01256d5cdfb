#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/drive/coil_bank.hpp"
#include "coilwright/drive/driver.hpp"
#include "coilwright/systems/driven_actuator.hpp"

namespace coilwright::systems {

/// Of the straight actuator: a coil whose torque per ampere is g sees the voltage g . omega, and the currents i that
/// all of these drive through coils and driver damp the motion by g i (Woodson and Melcher, Electromechanical Dynamics,
/// 1968, ch. 3). The driver is taken as closed by its resistance while on; actuators that share it move alike.
[[nodiscard]] MotionalEffect motional_effect(const actuator::Assembly& assembly, const drive::CoilBank& bank,
                                             const drive::Driver& driver);

}  // namespace coilwright::systems
