#include "coilwright/magnetics/axial_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "coilwright/magnetics/constants.hpp"
#include "magnetics/coil_on_magnet.hpp"
#include "magnetics/gauss_legendre.hpp"
#include "magnetics/landen_steps.hpp"
#include "magnetics/radial_nodes.hpp"
#include "magnetics/require.hpp"
#include "magnetics/sheet_kernels.hpp"
#include "magnetics/sheet_wrench.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {
namespace {

/// Share of a pair of faces' own size that a radial rule may leave out.
constexpr double rule_error = 5e-12;

/// Below this share of its terms the sum of the closed form has lost too many digits (4e-16 / 2e-3 = 2e-13).
constexpr double cancellation = 2e-3;

int steps_for(const SheetBody& body, double radius, double offset) {
  const double r = std::clamp(radius, body.inner_radius, body.outer_radius);
  const double square = offset * offset;
  return landen_steps_needed(((radius - r) * (radius - r) + square) / ((radius + r) * (radius + r) + square),
                             exact_moduli);
}

FacePair face_pair(const SheetBody& source, double radius, double offset, double sign) {
  return {{{}, source.mean_radius(), source.half_width()}, offset, sign, steps_for(source, radius, offset)};
}

double length_of(double x, double y) {
  return std::sqrt(x * x + y * y);
}

/// Order of the Gauss-Legendre rule that a uniform source needs for a face `offset` away from a sheet of `radius`: the
/// integrand is singular at radius +- i offset. Above max_gauss_order: none is enough.
int radial_order(const SheetBody& body, double radius, double offset) {
  const double to_ends = length_of(radius - body.inner_radius, offset) + length_of(radius - body.outer_radius, offset);
  return gauss_order_of_blocks(gauss_rate(to_ends, body.outer_radius - body.inner_radius), rule_error);
}

/// Phi(s) holds sgn(s) pi/2 min(r, R)^2, the whole flux of a half-infinite sheet, whose kink at r = R a rule through
/// R cannot see. It cancels between faces except where the bodies overlap, but each face has a rule of its own: this
/// puts the exact mean in the place of the rule's.
double kink_correction(const SheetBody& source, double radius, double offset, const QuadratureRule& rule) {
  const double inner = source.inner_radius;
  const double outer = source.outer_radius;
  if (radius <= inner || radius >= outer || offset == 0.0) return 0.0;
  const double exact =
      ((radius * radius * radius - inner * inner * inner) / 3.0 + radius * radius * (outer - radius)) / (outer - inner);
  double by_rule = 0.0;
  for (std::size_t i = 0; i < rule.count; ++i) {
    const double r = std::min(radius, source.mean_radius() + source.half_width() * rule.node[i]);
    by_rule += rule.weight[i] * r * r;
  }
  return std::copysign(0.5 * std::numbers::pi, offset) * (exact - by_rule);
}

/// Sum of +- Phi over four pairs of faces, for a uniform source.
double uniform_difference(const SheetBody& source, double radius, std::span<FacePair> pairs) {
  double graded = 0.0;
  double corrections = 0.0;
  for (FacePair& pair : pairs) {
    const int order = radial_order(source, radius, pair.offset);
    pair.nodes.rule = gauss_legendre(std::min(order, max_gauss_order));
    if (order > max_gauss_order && pair.offset != 0.0) {
      const RadialSet set = RadialSet::graded(source, radius, pair.offset);
      FacePair near = pair;
      near.nodes.rule = set.rule();
      graded += sum_of_inductance_integrals({&near, 1}, radius);
      corrections += pair.sign * kink_correction(source, radius, pair.offset, near.nodes.rule);
      pair.nodes.rule = gauss_legendre(1);
      pair.sign = 0.0;
    } else {
      corrections += pair.sign * kink_correction(source, radius, pair.offset, pair.nodes.rule);
    }
  }
  return sum_of_inductance_integrals(pairs, radius) + graded + corrections;
}

/// Mean over the source's sheets of Phi between four pairs of faces.
double closed_form(const SheetBody& source, double radius, double half_length, double distance) {
  const double sum = half_length + source.half_length;
  const double difference = half_length - source.half_length;
  std::array<FacePair, 4> pairs{
      face_pair(source, radius, distance + sum, 1.0), face_pair(source, radius, distance + difference, -1.0),
      face_pair(source, radius, distance - difference, -1.0), face_pair(source, radius, distance - sum, 1.0)};
  if (source.spread == Spread::uniform) return uniform_difference(source, radius, pairs);
  return sum_over_shells(source, pairs, radius);
}

/// Nodes along the shorter body that far_form needs.
double far_nodes_needed(const SheetBody& source, double radius, double half_length, double distance) {
  const double longer = std::max(half_length, source.half_length);
  const double shorter = std::min(half_length, source.half_length);
  const double nearest = std::abs(distance) - longer;
  const double across = radius - std::clamp(radius, source.inner_radius, source.outer_radius);
  const double to_ends = length_of(nearest - shorter, across) + length_of(nearest + shorter, across);
  return gauss_nodes_needed(gauss_rate(to_ends, 2.0 * shorter), std::log(rule_error));
}

/// The same as closed_form without its cancellation: one of the two integrals over length by Gauss-Legendre, which
/// leaves a first difference of the (positive) mutual inductance of loops.
double far_form(const SheetBody& source, double radius, double half_length, double distance, int order) {
  const double longer = std::max(half_length, source.half_length);
  const double shorter = std::min(half_length, source.half_length);
  const QuadratureRule along = gauss_legendre(order);
  double total = 0.0;
  for (std::size_t i = 0; i < along.count; ++i) {
    const double z = distance + shorter * along.node[i];
    const double weight = 2.0 * shorter * along.weight[i];
    std::array<FacePair, 2> pairs{face_pair(source, radius, z + longer, weight),
                                  face_pair(source, radius, z - longer, -weight)};
    for (int first = 0; first < source.shells; first += RadialSet::capacity) {
      const bool uniform = source.spread == Spread::uniform;
      if (uniform && first > 0) break;
      const RadialSet set = RadialSet::shells(source, first);
      for (FacePair& pair : pairs)
        pair.nodes.rule =
            uniform ? gauss_legendre(std::min(radial_order(source, radius, pair.offset), max_gauss_order)) : set.rule();
      total += sum_of_inductances(pairs, radius);
    }
  }
  return total;
}

/// Integral of d M / d distance over both lengths, mean over the source's sheets; the force over mu0 and currents.
double sheet_force(const SheetBody& source, double radius, double half_length, double distance) {
  const double closed = closed_form(source, radius, half_length, distance);
  // Phi is at most its value at infinity, half the flux of an endless sheet through the smaller circle.
  const double smaller = std::min(radius, source.outer_radius);
  if (std::abs(closed) > cancellation * std::numbers::pi * smaller * smaller) return closed;
  const double needed = far_nodes_needed(source, radius, half_length, distance);
  if (needed > 32.0) return closed;
  // Two more than by the rate alone: near its singularity the inductance is (distance / radius)^3 times larger.
  return far_form(source, radius, half_length, distance, static_cast<int>(std::ceil(needed)) + 2);
}

/// Mean of the sheet force over a target of uniform current. As a function of the target's radius it has weak
/// singularities where that passes the source's inner and outer radius, so the rule stops there.
double force_on_uniform(const SheetBody& source, const SheetBody& target, double distance) {
  const auto inside = [&](double radius) { return std::clamp(radius, target.inner_radius, target.outer_radius); };
  const std::array<double, 4> ends{target.inner_radius, inside(source.inner_radius), inside(source.outer_radius),
                                   target.outer_radius};
  const QuadratureRule rule = gauss_legendre(48);
  double integral = 0.0;
  for (std::size_t panel = 0; panel < 3; ++panel) {
    const double width = ends[panel + 1] - ends[panel];
    if (width <= 0.0) continue;
    for (std::size_t i = 0; i < rule.count; ++i) {
      const double radius = ends[panel] + 0.5 * width * (1.0 + rule.node[i]);
      integral += width * rule.weight[i] * sheet_force(source, radius, target.half_length, distance);
    }
  }
  return integral / (target.outer_radius - target.inner_radius);
}

double force_on_shells(const SheetBody& source, const SheetBody& target, double distance) {
  const SheetNodes shells(target, 1.0);
  double mean = 0.0;
  for (int i = 0; i < shells.count(); ++i)
    mean += shells.weight(i) * sheet_force(source, shells.radius(i), target.half_length, distance);
  return mean;
}

}  // namespace

double axial_force_of_sheets(const SheetBody& first, const SheetBody& second, double distance) {
  require_finite("distance", distance);
  if (distance == 0.0) return 0.0;  // by symmetry; the sums would leave a rounding error
  const double apart = std::abs(distance);
  // The force does not depend on which body is called the first. A uniform one makes the better source: its rules know
  // about the radius of the sheet they act on.
  const bool swapped = first.spread == Spread::shells && second.spread == Spread::uniform;
  const SheetBody& source = swapped ? second : first;
  const SheetBody& target = swapped ? first : second;
  const double mean = target.spread == Spread::uniform ? force_on_uniform(source, target, apart)
                                                       : force_on_shells(source, target, apart);
  return std::copysign(1.0, distance) * vacuum_permeability * first.surface_current * second.surface_current * mean;
}

double axial_force(const ThickCoil& coil, double current, const CylinderMagnet& magnet, double distance) {
  require_finite("current", current);
  return CoilOnMagnet(coil, current, magnet).axial_force(distance);
}

double axial_force(const CylinderMagnet& first, const CylinderMagnet& second, double distance) {
  return axial_force_of_sheets(weakened_sheets_of(first), weakened_sheets_of(second), distance);
}

double axial_force(const ThickCoil& first, double first_current, const ThickCoil& second, double second_current,
                   double distance) {
  require_finite("first_current", first_current);
  require_finite("second_current", second_current);
  return axial_force_of_sheets(sheets_of(first, first_current), sheets_of(second, second_current), distance);
}

void axial_force_per_ampere(const ThickCoil& coil, const CylinderMagnet& magnet, std::span<const double> distances,
                            std::span<double> forces) {
  if (distances.size() != forces.size())
    throw std::invalid_argument(
        fmt::format("forces must be as many as distances ({}); got {}", distances.size(), forces.size()));
  const CoilOnMagnet pair(coil, 1.0, magnet);
  std::transform(distances.begin(), distances.end(), forces.begin(),
                 [&](double distance) { return pair.axial_force(distance); });
}

}  // namespace coilwright::magnetics
