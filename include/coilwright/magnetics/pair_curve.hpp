#pragma once

#include "coilwright/magnetics/curve.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// Curve of hinge_torque_per_ampere over the joint angle, rad -> N m/A. A boundary layer width of 0 is replaced by one
/// that suits the hinge. With Fidelity::exact the range must not reach far into angles at which coil and magnet
/// overlap, because the torque of overlapping currents is known only to 0.5 %; the construction then throws
/// std::domain_error.
[[nodiscard]] Curve torque_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                                 Fidelity fidelity, const Curve::Spec& spec);

/// Curve of axial_force over the distance of the centres, m -> N per ampere, with both senses positive: attraction is
/// negative. Here and below a boundary layer width of 0 is replaced by the radius of the first body.
[[nodiscard]] Curve force_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const Curve::Spec& spec);
/// Curve of the force between two magnets, m -> N.
[[nodiscard]] Curve force_curve(const CylinderMagnet& first, const CylinderMagnet& second, const Curve::Spec& spec);
/// Curve of the force between two coils, m -> N per ampere squared.
[[nodiscard]] Curve force_curve(const ThickCoil& first, const ThickCoil& second, const Curve::Spec& spec);

}  // namespace coilwright::magnetics
