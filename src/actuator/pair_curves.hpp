#pragma once

#include <memory>

#include "actuator/parts/axial_curves.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/dimensions.hpp"
#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "coilwright/magnetics/curve.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"

namespace coilwright::actuator {

/// The one-dimensional curves of a design, each built when first asked for: all its coils are alike and so are its
/// magnets, so every pair of a kind shares them.
class PairCurves {
 public:
  PairCurves(const Design& design, const Dimensions& size) : design_(design), size_(size) {}

  [[nodiscard]] magnetics::ThickCoil coil() const;
  [[nodiscard]] magnetics::CylinderMagnet magnet() const;
  [[nodiscard]] std::shared_ptr<const magnetics::Curve> hinge_torque();
  [[nodiscard]] std::shared_ptr<const HingePairParts> hinge_parts();
  [[nodiscard]] const AxialCurves& coil_magnet();
  [[nodiscard]] const AxialCurves& magnet_magnet();
  /// Force between a coil and its neighbouring magnet at angle 0, N/A, positive for repulsion.
  [[nodiscard]] double rest_force_per_ampere() const;

 private:
  const Design& design_;
  const Dimensions& size_;
  std::shared_ptr<const magnetics::Curve> hinge_torque_;
  std::shared_ptr<const HingePairParts> hinge_parts_;
  AxialCurves coil_magnet_;
  AxialCurves magnet_magnet_;
};

}  // namespace coilwright::actuator
