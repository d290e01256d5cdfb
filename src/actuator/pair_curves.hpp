#pragma once

#include <memory>

#include "coilwright/actuator/design.hpp"
#include "coilwright/actuator/dimensions.hpp"
#include "coilwright/magnetics/curve.hpp"

namespace coilwright::actuator {

/// Force between two coaxial components over the distance of their centres, and its energy.
struct AxialCurves {
  std::shared_ptr<const magnetics::Curve> force;   ///< on the second, N (per A for a coil)
  std::shared_ptr<const magnetics::Curve> energy;  ///< zero at infinity, J (per A)
};

/// The one-dimensional curves of a design, each built when first asked for: all its coils are alike and so are its
/// magnets, so every pair of a kind shares them.
class PairCurves {
 public:
  PairCurves(const Design& design, const Dimensions& size) : design_(design), size_(size) {}

  [[nodiscard]] std::shared_ptr<const magnetics::Curve> hinge_torque();
  [[nodiscard]] const AxialCurves& coil_magnet();
  [[nodiscard]] const AxialCurves& magnet_magnet();
  /// Force between a coil and its neighbouring magnet at angle 0, N/A, positive for repulsion.
  [[nodiscard]] double rest_force_per_ampere() const;

 private:
  const Design& design_;
  const Dimensions& size_;
  std::shared_ptr<const magnetics::Curve> hinge_torque_;
  AxialCurves coil_magnet_;
  AxialCurves magnet_magnet_;
};

}  // namespace coilwright::actuator
