#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "coilwright/actuator/parts/torque_curve_error.hpp"
#include "coilwright/magnetics/curve.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::actuator {

/// The parts of a hinge pair, and the curves of torque per ampere that follow from them. Logically immutable and
/// thread-safe; the exact curve is computed on first use (0.1 to 1 s) and cached.
class HingePairParts {
 public:
  /// Inputs of a HingePairParts.
  struct Spec {
    magnetics::ThickCoil coil;
    magnetics::CylinderMagnet magnet;
    magnetics::HingeGeometry geometry;
    magnetics::Fidelity fidelity{};  ///< by which the model takes the pair's torque
    magnetics::Curve::Spec range;    ///< of joint angles, rad
    /// Lower end of the curve by the line of centres, rad, instead of that of `range`: its coaxial force is smooth
    /// where parts overlap, and a chain without stops swings there. If it is not smooth there, `range` counts.
    std::optional<double> line_of_centres_lower{};
  };
  /// Keeps the inputs and builds no curve yet.
  explicit HingePairParts(const Spec& spec) : spec_(spec) {}
  /// The same pair with an error of its curves. It shares the curves of `computed`, which is not null.
  HingePairParts(std::shared_ptr<const HingePairParts> computed, const TorqueCurveError& error)
      : spec_(computed->spec_), computed_(std::move(computed)), error_(error) {}

  [[nodiscard]] const Spec& spec() const noexcept { return spec_; }
  /// Torque per ampere by the fidelity of the spec, N m/A over rad. Throws the errors of magnetics::torque_curve.
  [[nodiscard]] std::shared_ptr<const magnetics::Curve> torque() const;
  /// Torque per ampere by the whole force and torque of the tilted, displaced pair, N m/A over rad. Safe from any
  /// thread.
  [[nodiscard]] std::shared_ptr<const magnetics::Curve> exact_torque() const;

 private:
  [[nodiscard]] std::shared_ptr<const magnetics::Curve> curve(magnetics::Fidelity fidelity,
                                                              const magnetics::Curve::Spec& range) const;

  Spec spec_;
  std::shared_ptr<const HingePairParts> computed_{};  // null without an error
  TorqueCurveError error_{};
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const magnetics::Curve> exact_;
};

}  // namespace coilwright::actuator
