#pragma once

#include <array>
#include <optional>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// The coaxial force of a coil on a magnet over that on the same magnet without recoil: 0.96 to 0.98 for a disc of
/// NdFeB. It changes slowly with the distance but costs twenty times the force, so a curve takes it from here:
/// interpolation between 13 distances, within 1e-6 of it over most pairs and 1e-5 over the rest. Where the faces pass
/// each other (a magnet in the bore of a coil, or currents in one place that a solver steps through) another 13.
class RecoilShare {
 public:
  /// For distances of the centres from `nearest` to `farthest`, m, 0 <= nearest < farthest.
  RecoilShare(const ThickCoil& coil, const CylinderMagnet& magnet, double nearest, double farthest);

  [[nodiscard]] double at(double distance) const;

 private:
  /// Barycentric interpolation between Chebyshev points of the second kind in log(distance - origin).
  class Piece {
   public:
    Piece(const ThickCoil& coil, const CylinderMagnet& magnet, double origin, double nearest, double farthest);
    [[nodiscard]] double at(double distance) const;

   private:
    static constexpr int points = 13;

    double origin_;  // m
    std::array<double, points> place_;
    std::array<double, points> share_;
  };

  double level_;  // distance at which the faces are level, m
  std::optional<Piece> apart_;
  std::optional<Piece> passed_;
};

}  // namespace coilwright::magnetics
