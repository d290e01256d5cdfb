#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/actuator/model/torque_correction.hpp"
#include "coilwright/actuator/parts/coil_currents.hpp"
#include "coilwright/actuator/parts/coil_row.hpp"
#include "coilwright/actuator/parts/magnetic_stage.hpp"
#include "coilwright/mechanics/face_contact.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator {

/// A joint's own torques: spring, damper, constant, and the faces that meet when it closes.
struct Hinge {
  double stiffness{};      ///< k, N m/rad; >= 0
  double damping{};        ///< b, N m s/rad; >= 0
  double torque_offset{};  ///< added at every angle, N m
  mechanics::FaceContact contact{};
};

/// The parts of a model: the nominal stages, and the effects to be built into them.
struct ModelSpec {
  mechanics::PlanarChain chain;
  std::vector<Hinge> hinges;  ///< one per joint
  MagneticStage magnetics;
  int coils{};                    ///< number of currents that the magnetics take; >= 0
  mechanics::LinkPoint tip;       ///< the point that touches first when the finger grasps
  std::vector<Effect> effects{};  ///< each kind at most once
  /// Places of the coils, for the forces among them that `magnetics` leaves out; null if the places are not known.
  std::shared_ptr<const CoilRow> coil_row{};
  std::optional<double> coil_resistance{};  ///< of one coil at 20 degC, ohm, > 0; absent for a lumped model
  /// Share of the operating current that each coil carries, (coils), finite. Empty: each carries the whole.
  CoilCurrents current_shares{};
  std::optional<TorqueCorrection> torque_correction{};  ///< a torque that a fit found and that has no name
};

}  // namespace coilwright::actuator
