#pragma once

#include <span>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// Axial force on the second of two coaxial bodies, N, along +z (from the first to the second if distance > 0).
/// Positive current and positive remanence give moments along +z, so like senses attract: negative for distance > 0.
///
/// `distance` is from centre to centre, m, any finite value; the force is odd in it. Bodies may overlap: the result is
/// that of the two current distributions in the same place, as for a magnet in the bore of a coil. The relative error
/// is below 1e-10, except where the force passes through zero (distance -> 0); there the error is below 1e-13 of the
/// largest force of the pair. Theory and sources: docs/theory/magnetics.md. Throws std::invalid_argument if a distance
/// or a current is not finite.
[[nodiscard]] double axial_force(const ThickCoil& coil, double current, const CylinderMagnet& magnet, double distance);
/// Axial force between two magnets of like polarity, with the same conventions.
[[nodiscard]] double axial_force(const CylinderMagnet& first, const CylinderMagnet& second, double distance);
/// Axial force between two coils, with the same conventions.
[[nodiscard]] double axial_force(const ThickCoil& first, double first_current, const ThickCoil& second,
                                 double second_current, double distance);

/// Force of a coil on a coaxial magnet per ampere, N/A, at many distances (m): forces[i] belongs to distances[i] and
/// equals axial_force(coil, 1.0, magnet, distances[i]) to the bit. Throws std::invalid_argument if the spans differ in
/// size or a distance is not finite.
void axial_force_per_ampere(const ThickCoil& coil, const CylinderMagnet& magnet, std::span<const double> distances,
                            std::span<double> forces);

}  // namespace coilwright::magnetics
