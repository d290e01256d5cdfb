#pragma once

#include <array>
#include <cstddef>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "magnetics/sheets.hpp"
#include "magnetics/surface_quadrature.hpp"

namespace coilwright::magnetics {

/// What recoil takes from a magnet, as rings of current on its surface.
///
/// The magnet's own field H changes its magnetisation by chi H, chi = recoil permeability - 1. Inside the magnet H has
/// neither curl nor divergence, so that change is a current chi H_z round the side and -+ chi H_rho round the faces.
/// H is taken of the uniform magnet; that the change itself makes less of H only in the mean, by 1 / (1 + chi N).
/// Everything here is per A/m of the magnetisation without recoil, Br / mu0, like a sheet of unit current.
class RecoilCurrents {
 public:
  explicit RecoilCurrents(const CylinderMagnet& magnet);

  /// Axial force on them from a coaxial source of unit current, over mu0, m^2. `distance` from the source's centre to
  /// the magnet's, m.
  [[nodiscard]] double axial_force(const SheetBody& source, double distance) const;

  /// Force and torque on them about the magnet's centre, likewise, in the source's frame; `axis` is a unit vector.
  [[nodiscard]] Wrench wrench(const SheetBody& source, const Eigen::Vector3d& position, const Eigen::Vector3d& axis,
                              const Accuracy& accuracy) const;

 private:
  static constexpr std::size_t side_rings = 4;
  static constexpr std::size_t face_rings = 10;

  TargetSheet side_;
  std::array<CurrentRing, side_rings + 2 * face_rings> rings_;
};

}  // namespace coilwright::magnetics
