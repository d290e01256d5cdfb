#pragma once

#include <vector>

#include "coilwright/actuator/magnetic_stage.hpp"
#include "coilwright/mechanics/face_contact.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator {

/// One joint's own torques: spring, damper, constant, and the faces that meet when it closes.
struct Hinge {
  double stiffness{};      ///< k, N m/rad; >= 0
  double damping{};        ///< b, N m s/rad; >= 0
  double torque_offset{};  ///< added at every angle, N m
  mechanics::FaceContact contact{};
};

/// An actuator as the simulation sees it: drive, magnetics, hinge, chain, camera in a row. Immutable.
class Model {
 public:
  struct Spec {
    mechanics::PlanarChain chain;
    std::vector<Hinge> hinges;  ///< one per joint
    MagneticStage magnetics;
    int coils{};               ///< how many currents the magnetics take; >= 0
    mechanics::LinkPoint tip;  ///< what touches first when the finger grasps
  };
  /// Throws std::invalid_argument where counts do not match or a hinge value breaks its rule.
  explicit Model(Spec spec);

  [[nodiscard]] int joints() const noexcept { return spec_.chain.joints(); }
  [[nodiscard]] int coils() const noexcept { return spec_.coils; }
  [[nodiscard]] const mechanics::PlanarChain& chain() const noexcept { return spec_.chain; }
  [[nodiscard]] const std::vector<Hinge>& hinges() const noexcept { return spec_.hinges; }
  [[nodiscard]] const MagneticStage& magnetics() const noexcept { return spec_.magnetics; }
  [[nodiscard]] const mechanics::LinkPoint& tip() const noexcept { return spec_.tip; }

  /// The same current in every coil: one driver.
  [[nodiscard]] CoilCurrents all_coils(double current) const { return CoilCurrents::Constant(coils(), current); }

  /// Joint torques of magnetics and hinges, N m: everything but gravity and inertia.
  [[nodiscard]] mechanics::JointVector torques(const mechanics::JointVector& angles,
                                               const mechanics::JointVector& rates, const CoilCurrents& currents) const;

  /// Joint accelerations, rad/s^2, under `currents` (A) and further joint torques `applied` (N m).
  [[nodiscard]] mechanics::JointVector accelerations(const mechanics::JointVector& angles,
                                                     const mechanics::JointVector& rates, const CoilCurrents& currents,
                                                     const mechanics::JointVector& applied) const;

  /// Torque left over at rest, N m: zero in an equilibrium.
  [[nodiscard]] mechanics::JointVector static_residual(const mechanics::JointVector& angles,
                                                       const CoilCurrents& currents) const;

  /// -d(static residual)/d(angle), (n, n), N m/rad; an equilibrium is stable where it is positive definite.
  [[nodiscard]] mechanics::JointMatrix tangent_stiffness(const mechanics::JointVector& angles,
                                                         const CoilCurrents& currents) const;

  /// Damping of every joint at rest at `angles`, N m s/rad: of its hinge, and of its stop where that is pressed.
  [[nodiscard]] mechanics::JointVector damping(const mechanics::JointVector& angles) const;

  /// What the camera sees: the sum of the joint angles, rad.
  [[nodiscard]] static double bending_angle(const mechanics::JointVector& angles) { return angles.sum(); }

 private:
  Spec spec_;
};

}  // namespace coilwright::actuator
