#pragma once

#include "coilwright/magnetics/inner_field.hpp"

namespace coilwright::magnetics {

/// Squareness of a typical sintered NdFeB: makers guarantee 0.9, and 0.99 is a good one.
inline constexpr double typical_squareness = 0.95;

/// The curve on which a magnet leaves its recoil line: M = M0 + chi H down to a knee, then straight through s M0 at
/// s HcJ to 0 at -HcJ and beyond. s is the squareness. Makers state Hk / HcJ with M = 0.9 M0 at Hk, which is
/// 1 - 0.9 (1 - s) / s: 0.953 for 0.95, and 0.9 for 0.9.
struct DemagnetisationCurve {
  double magnetisation{};                  ///< M0 = Br / mu0, A/m; finite, >= 0
  double coercivity{};                     ///< HcJ, A/m; finite; at 0 and below the magnet holds no magnetisation
  double susceptibility{};                 ///< chi of the recoil line, recoil permeability less 1; >= 0
  double squareness = typical_squareness;  ///< s; > 0.5, < 1

  /// The margin 1 - |H| / HcJ above which the curve is on its recoil line: the knee for chi = 0; others are lower.
  [[nodiscard]] double knee_margin() const noexcept { return (1.0 - squareness) / squareness; }

  /// Magnetisation M at an inner field H (A/m, negative against the magnetisation) that the magnet meets for the first
  /// time, A/m; never below -M0.
  [[nodiscard]] double at(double field) const noexcept;
};

/// Share of its moment, 0 to 2, that an axially magnetised cylinder loses for good in its own field and a field
/// `outside`, A/m, positive along the magnetisation, which is given on its faces and taken as linear between them.
///
/// The magnet is cut into 8 rings by 10 discs, each uniformly magnetised in the field of all others. Every cell sits on
/// the curve; it keeps M - chi H, the recoil line's value at H = 0. Transverse fields are left out. Twice as many cells
/// each way change a loss below 50 % by less than 0.2 % of the moment. Derivation, checks: docs/theory/magnetics.md,
/// "Irreversible loss". Throws std::invalid_argument naming the rule for a size or curve outside the ranges above.
[[nodiscard]] double irreversible_loss(const CylinderSize& size, const DemagnetisationCurve& curve,
                                       const FaceValues& outside);

}  // namespace coilwright::magnetics
