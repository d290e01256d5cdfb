#include "coilwright/magnetics/inner_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "magnetics/field_kernels.hpp"
#include "magnetics/gauss_legendre.hpp"
#include "magnetics/landen_steps.hpp"
#include "magnetics/radial_nodes.hpp"
#include "magnetics/require.hpp"
#include "magnetics/sheet_kernels.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {
namespace {

constexpr double inner_rule_error = 1e-8;

void check(const CylinderSize& size) {
  require_positive("cylinder radius", size.radius);
  require_positive("cylinder length", size.length);
}

struct CompleteIntegrals {
  double first;   // K
  double second;  // E
};

// By the arithmetic-geometric mean (Abramowitz and Stegun 17.6), of the modulus and its complement.
CompleteIntegrals complete_integrals(double modulus, double complement) {
  double arithmetic = 1.0;
  double geometric = complement;
  double share = 0.5 * modulus * modulus;
  for (double weight = 1.0; arithmetic - geometric > 1e-9 * arithmetic; weight *= 2.0) {
    const double c = 0.5 * (arithmetic - geometric);
    const double next = 0.5 * (arithmetic + geometric);
    geometric = std::sqrt(arithmetic * geometric);
    arithmetic = next;
    share += weight * c * c;
  }
  const double first = std::numbers::pi / (arithmetic + geometric);
  return {.first = first, .second = first * (1.0 - share)};
}

// Mean flux through a loop of `radius` at `height` from the source's centre, over mu0 and its surface current, m^2.
double flux(const SheetBody& source, double radius, double height) {
  std::array<FacePair, 2> faces;
  double nearest = 1.0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const double sign = i == 0 ? 1.0 : -1.0;
    const double offset = height + sign * source.half_length;
    const double across = radius - std::clamp(radius, source.inner_radius, source.outer_radius);
    const double closest = std::clamp(radius, source.inner_radius, source.outer_radius);
    const double square =
        (across * across + offset * offset) / ((radius + closest) * (radius + closest) + offset * offset);
    nearest = std::min(nearest, std::abs(offset) / source.outer_radius);
    faces[i] = {.nodes = {.rule = {}, .centre = source.mean_radius(), .half_width = source.half_width()},
                .offset = offset,
                .sign = sign,
                .landen_steps = landen_steps_needed(square, exact_moduli)};
  }
  if (source.spread == Spread::uniform) {
    // One rule for both faces: the kinks of the two integrals at r = R then cancel, as bodies do not overlap.
    const double offset = nearest * source.outer_radius;
    const double to_ends =
        std::hypot(radius - source.inner_radius, offset) + std::hypot(radius - source.outer_radius, offset);
    const int order =
        gauss_order_of_blocks(gauss_rate(to_ends, source.outer_radius - source.inner_radius), inner_rule_error);
    for (FacePair& face : faces) face.nodes.rule = gauss_legendre(std::min(order, max_gauss_order));
    return sum_of_inductance_integrals(faces, radius);
  }
  return sum_over_shells(source, faces, radius);
}

double mean_field(const SheetBody& source, const CylinderSize& within, double distance) {
  const double half = 0.5 * within.length;
  // The flux is singular where the loop lies on an edge of the source, a clearance beyond the cylinder's end.
  const double clearance = std::max(std::abs(distance) - half - source.half_length, 0.0);
  const double across = within.radius - std::clamp(within.radius, source.inner_radius, source.outer_radius);
  const double to_ends = std::hypot(clearance, across) + std::hypot(clearance + within.length, across);
  const double needed = gauss_nodes_needed(gauss_rate(to_ends, within.length), std::log(inner_rule_error));
  const QuadratureRule along = gauss_legendre(static_cast<int>(std::clamp(std::ceil(needed), 4.0, 32.0)));
  double mean = 0.0;
  for (std::size_t i = 0; i < along.count; ++i)
    mean += along.weight[i] * flux(source, within.radius, distance + half * along.node[i]);
  return source.surface_current * mean / (std::numbers::pi * within.radius * within.radius);
}

FaceValues face_field(const SheetBody& source, const CylinderSize& within, double distance) {
  FaceValues radius{};
  FaceValues height{};
  FaceValues radial{};
  FaceValues axial{};
  constexpr std::size_t half = face_points / 2;
  // Just inside: a sheet's own field is taken at its edge plane too.
  const double inside = 0.5 * within.length * (1.0 - 1e-12);
  for (std::size_t i = 0; i < face_points; ++i) {
    radius[i] = within.radius * static_cast<double>(i % half) / half;
    height[i] = distance + (i < half ? -inside : inside);
  }
  field_of_sheets(source, std::log(inner_rule_error), {.radius = radius, .height = height},
                  {.radial = radial, .axial = axial});
  for (double& value : axial) value *= source.surface_current;
  return axial;
}

AxialField field_in(const SheetBody& source, const CylinderSize& within, double distance) {
  check(within);
  require_finite("distance", distance);
  return {.mean = mean_field(source, within, distance), .faces = face_field(source, within, distance)};
}

}  // namespace

double demagnetisation_factor(const CylinderSize& size) {
  check(size);
  // Nagaoka's coefficient by Lorenz's formula, k^2 = D^2 / (D^2 + L^2).
  const double diameter = 2.0 * size.radius;
  const double diagonal = std::hypot(diameter, size.length);
  const double k = diameter / diagonal;
  const double cosine = size.length / diagonal;
  const double square = k * k;
  const auto [first, second] = complete_integrals(k, cosine);
  const double nagaoka =
      4.0 / (3.0 * std::numbers::pi * cosine) * (cosine * cosine / square * (first - second) + second - k);
  return 1.0 - nagaoka;
}

double recoil_factor(const CylinderSize& size, double recoil) {
  require(std::isfinite(recoil) && recoil >= 1.0, "recoil permeability", "finite and >= 1", recoil);
  return 1.0 / (1.0 + (recoil - 1.0) * demagnetisation_factor(size));
}

AxialField axial_field(const ThickCoil& coil, double current, const CylinderSize& within, double distance) {
  require_finite("current", current);
  return field_in(sheets_of(coil, current), within, distance);
}

AxialField axial_field(const CylinderMagnet& magnet, const CylinderSize& within, double distance) {
  return field_in(weakened_sheets_of(magnet), within, distance);
}

FaceValues face_demagnetisation_factors(const CylinderSize& size) {
  check(size);
  const SheetBody sheet{.inner_radius = size.radius,
                        .outer_radius = size.radius,
                        .half_length = 0.5 * size.length,
                        .surface_current = 1.0,
                        .shells = 1,
                        .spread = Spread::shells};
  FaceValues factors = face_field(sheet, size, 0.0);
  // B / mu0 of the sheet, less the magnetisation.
  for (double& value : factors) value = 1.0 - value;
  return factors;
}

}  // namespace coilwright::magnetics
