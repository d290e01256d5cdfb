#pragma once

namespace coilwright::winding {

/// A circular coil of rectangular section whose current density is uniform.
struct CoilSection {
  double inner_radius{};  ///< m; finite, >= 0
  double outer_radius{};  ///< m; finite, > inner_radius
  double length{};        ///< along the axis, m; finite, > 0
  int turns{};            ///< >= 1
};

/// Self-inductance of a thick coil in air, H.
///
/// The coil is a stack of concentric cylindrical current sheets. The mutual inductance of two sheets is exact (complete
/// elliptic integrals); the double integral over their radii is a Gauss rule of 4 by 6 points on the triangle inside
/// the other sheet, graded towards equal radii. Its relative error, against 30 by 40 points: 2e-6 for coils at least as
/// long as their outer radius (the prototype: 6e-7), 1e-4 down to a tenth of it, 3e-4 down to a fiftieth, 1e-3 for
/// flatter ones. Derivation and checks: docs/theory/winding.md.
///
/// A uniform current density leaves out the round wires with enamel and space between them: about +mu0 N a (ln(pitch /
/// bare diameter) + 0.15), Rosa's correction. It is 0.05 % for the prototype's 450 turns and 1/N of L in general, so a
/// coil of a handful of turns is off by per cents. Throws std::invalid_argument naming the field, the rule and the
/// value received.
[[nodiscard]] double inductance(const CoilSection& section);

/// Mutual inductance of two coaxial coils side by side, H, positive if like currents have like senses.
///
/// Both are stacks of current sheets; that of two sheets is exact, as in inductance(), so `distance` from centre to
/// centre, m, enters without a quadrature. The two radial integrals are Gauss rules of 16 points. Relative error for
/// the prototype's coil against 30 by 30 points: 2e-5 if faces touch, 8e-7 at 0.3 mm between them, 1e-9 from 1 mm.
///
/// Throws std::invalid_argument naming the field, the rule and the value received: the sections as above, `distance`
/// finite and at least half of both lengths, so that the coils do not overlap.
[[nodiscard]] double mutual_inductance(const CoilSection& first, const CoilSection& second, double distance);

}  // namespace coilwright::winding
