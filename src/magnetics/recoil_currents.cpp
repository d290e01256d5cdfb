#include "magnetics/recoil_currents.hpp"

#include <cmath>
#include <numbers>

#include "coilwright/magnetics/inner_field.hpp"
#include "magnetics/field_kernels.hpp"
#include "magnetics/gauss_legendre.hpp"

namespace coilwright::magnetics {
namespace {

// At a recoil permeability of 1.05 they add 4 % to a force, and may err by as much more than that.
constexpr double over_whole = 25.0;
constexpr double log_field_error = -18.0;  // 2e-8

}  // namespace

RecoilCurrents::RecoilCurrents(const CylinderMagnet& magnet)
    : side_{.radius = magnet.radius(), .half_length = 0.5 * magnet.length()}, rings_{} {
  constexpr std::size_t count = side_rings + 2 * face_rings;
  std::array<double, count> radius{};
  std::array<double, count> height{};
  std::array<double, count> width{};
  const QuadratureRule along = gauss_legendre(side_rings);
  for (std::size_t i = 0; i < side_rings; ++i) {
    radius[i] = side_.radius;
    height[i] = side_.half_length * along.node[i];
    width[i] = magnet.length() * along.weight[i];
  }
  // rho = R (1 - t^2), t from 0 to 1: towards the rim the field goes as log(R - rho), and t log t is tame. A higher
  // power would leave fewer rings for the rest of the face, where a coil's field varies.
  const QuadratureRule across = gauss_legendre(face_rings);
  const double just_inside = side_.half_length * (1.0 - 1e-12);
  for (std::size_t i = 0; i < face_rings; ++i) {
    const double t = 0.5 * (1.0 + across.node[i]);
    for (std::size_t face = 0; face < 2; ++face) {
      const std::size_t at = side_rings + face * face_rings + i;
      radius[at] = side_.radius * (1.0 - t * t);
      height[at] = face == 0 ? -just_inside : just_inside;
      width[at] = 2.0 * side_.radius * t * across.weight[i];
    }
  }
  std::array<double, count> radial{};
  std::array<double, count> axial{};
  field_of_sheets(sheets_of(magnet), log_field_error, {.radius = radius, .height = height},
                  {.radial = radial, .axial = axial});
  const double susceptibility = magnet.recoil_permeability() - 1.0;
  const CylinderSize shape{.radius = magnet.radius(), .length = magnet.length()};
  const double change = susceptibility / (1.0 + susceptibility * demagnetisation_factor(shape));
  double moment = 0.0;  // per pi R^2
  for (std::size_t i = 0; i < count; ++i) {
    // The sheet's B / mu0 less the magnetisation; round a face by the normal along +z or -z.
    const double field = i < side_rings ? axial[i] - 1.0 : std::copysign(1.0, -height[i]) * radial[i];
    rings_[i] = {.radius = radius[i], .height = height[i], .current = change * field * width[i]};
    moment += rings_[i].current * (radius[i] / side_.radius) * (radius[i] / side_.radius);
  }
  // What the rules miss at the rims: their moment is known by the mean of the inner field.
  const double missing = recoil_factor(shape, magnet.recoil_permeability()) - 1.0 - moment / magnet.length();
  for (std::size_t i = 0; i < side_rings; ++i) rings_[i].current += missing * width[i];
}

double RecoilCurrents::axial_force(const SheetBody& source, double distance) const {
  std::array<double, std::tuple_size_v<decltype(rings_)>> radius{};
  auto height = radius;
  auto radial = radius;
  auto axial = radius;
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    radius[i] = rings_[i].radius;
    height[i] = distance + rings_[i].height;
  }
  field_of_sheets(source, log_field_error, {.radius = radius, .height = height}, {.radial = radial, .axial = axial});
  double force = 0.0;
  for (std::size_t i = 0; i < rings_.size(); ++i)
    force -= 2.0 * std::numbers::pi * radius[i] * rings_[i].current * radial[i];
  return force;
}

Wrench RecoilCurrents::wrench(const SheetBody& source, const Eigen::Vector3d& position, const Eigen::Vector3d& axis,
                              const Accuracy& accuracy) const {
  const Accuracy of_share{.log_radial = accuracy.log_radial + std::log(over_whole),
                          .log_along = accuracy.log_along,
                          .harmonic = accuracy.harmonic * std::sqrt(over_whole)};
  return lorentz_wrench(source, side_, rings_, position, axis, of_share);
}

}  // namespace coilwright::magnetics
