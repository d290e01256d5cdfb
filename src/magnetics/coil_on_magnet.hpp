#pragma once

#include <optional>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "magnetics/recoil_currents.hpp"
#include "magnetics/sheets.hpp"
#include "magnetics/surface_quadrature.hpp"

namespace coilwright::magnetics {

/// A coil and a magnet as sheets, with what recoil adds: made once for many poses.
class CoilOnMagnet {
 public:
  CoilOnMagnet(const ThickCoil& coil, double current, const CylinderMagnet& magnet);

  /// As axial_force() of them.
  [[nodiscard]] double axial_force(double distance) const;
  /// As wrench() of them, which is that of `exact_pose`.
  [[nodiscard]] Wrench wrench(const Pose& pose, const Accuracy& accuracy) const;

 private:
  [[nodiscard]] double scale() const;

  SheetBody source_;
  SheetBody target_;
  std::optional<RecoilCurrents> recoil_;
};

}  // namespace coilwright::magnetics
