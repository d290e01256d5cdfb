#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "coilwright/magnetics/constants.hpp"
#include "magnetics/field_kernels.hpp"
#include "magnetics/gauss_legendre.hpp"
#include "magnetics/landen_steps.hpp"
#include "magnetics/magnet_field.hpp"
#include "magnetics/sheet_kernels.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {
namespace {

// A uniformly magnetised body has the field H = T M, T being the second derivatives of the Newtonian potential of its
// shape. Of a cylinder, in cylindrical coordinates, T has the elements a = T_rr, b = T_pp, c = T_zz and d = T_rz. The
// sheet round its side gives c (less 1 inside) and d, the flux through a loop of the point's radius gives
// b = -flux / (2 pi r^2), and the trace is 0 outside and -1 inside. So a diametrically magnetised cylinder takes no
// formulas of its own. docs/theory/magnetics.md, "Field".

constexpr std::size_t at_once = 8;
constexpr double log_error = -23.0;  // 1e-10
constexpr int most_loops = 8;
constexpr double round_surface = 1e-12;  // of the size: nearer to a surface than that is just outside
// Of the radius: nearer to the axis (a - b) / r, which goes as r, is taken from there.
constexpr double near_axis = 1e-3;

using Block = std::array<double, at_once>;

/// Radius and height of eight points.
struct Places {
  Block radius;
  Block height;
};

/// Loops in which the current of a sheet is gathered for points so far away that a few are as good as the sheet; 0 for
/// nearer ones.
int loops_for(const SheetBody& body, const Places& at) {
  double nearest = 1e300;
  for (std::size_t i = 0; i < at_once; ++i) nearest = std::min(nearest, std::hypot(at.radius[i], at.height[i]));
  const double to_ends = 2.0 * std::max(nearest - body.outer_radius, body.half_length);
  const double needed = gauss_nodes_needed(gauss_rate(to_ends, 2.0 * body.half_length), log_error) + 1.0;
  return needed <= most_loops ? static_cast<int>(std::ceil(needed)) : 0;
}

struct Sheets {
  Block radial;
  Block axial;
};

Sheets sheets_at(const SheetBody& body, const Places& at, int loops) {
  Sheets out{};
  const FieldPoints points{.radius = at.radius, .height = at.height};
  const FieldValues values{.radial = out.radial, .axial = out.axial};
  if (loops > 0)
    field_of_loops(body, log_error, gauss_legendre(loops), points, values);
  else
    field_of_sheets(body, log_error, points, values);
  return out;
}

// Its derivative along the axis: a loop at the lower end less one at the upper end.
Sheets slopes_at(const SheetBody& body, const Places& at) {
  Sheets out{};
  const double weight = 0.5 / body.half_length;
  const std::array<double, 2> node{-1.0, 1.0};
  const std::array<double, 2> weights{weight, -weight};
  field_of_loops(body, log_error, {.node = node.data(), .weight = weights.data(), .count = 2, .padded_count = 2},
                 {.radius = at.radius, .height = at.height}, {.radial = out.radial, .axial = out.axial});
  return out;
}

FacePair loops_of(const SheetBody& sheet, double radius, double offset, double sign) {
  const double across = radius - sheet.outer_radius;
  const double sum = radius + sheet.outer_radius;
  const double square = offset * offset;
  return {.nodes = {.rule = gauss_legendre(1), .centre = sheet.outer_radius, .half_width = 0.0},
          .offset = offset,
          .sign = sign,
          .landen_steps = landen_steps_needed((across * across + square) / (sum * sum + square), exact_moduli)};
}

// T_pp of a single sheet.
double hoop_element(const SheetBody& sheet, double radius, double height, int loops) {
  // Even in the radius, so what the floor changes is 1e-12 of it.
  const double r = std::max(radius, 1e-6 * sheet.outer_radius);
  double flux = 0.0;
  if (loops == 0) {
    std::array<FacePair, 2> faces{loops_of(sheet, r, height + sheet.half_length, 1.0),
                                  loops_of(sheet, r, height - sheet.half_length, -1.0)};
    flux = sum_of_inductance_integrals(faces, r);
  } else {
    const QuadratureRule along = gauss_legendre(loops);
    std::array<FacePair, most_loops> rings{};
    for (std::size_t i = 0; i < along.count; ++i)
      rings[i] =
          loops_of(sheet, r, height - sheet.half_length * along.node[i], 2.0 * sheet.half_length * along.weight[i]);
    flux = sum_of_inductances({rings.data(), along.count}, r);
  }
  return -flux / (2.0 * std::numbers::pi * r * r);
}

/// Share of the sheets round a point between the two ends, and how it changes outwards, in a winding or at a magnet.
struct Inside {
  double share;
  double slope;
};

Inside inside(const SheetBody& body, double radius, double height) {
  if (std::abs(height) >= body.half_length || radius >= body.outer_radius) return {.share = 0.0, .slope = 0.0};
  if (radius < body.inner_radius || body.shells == 1) return {.share = 1.0, .slope = 0.0};
  if (body.spread == Spread::uniform) {
    const double width = body.outer_radius - body.inner_radius;
    return {.share = (body.outer_radius - radius) / width, .slope = -1.0 / width};
  }
  const double step = (body.outer_radius - body.inner_radius) / (body.shells - 1);
  return {.share = std::floor((body.outer_radius - radius) / step + 1.0) / body.shells, .slope = 0.0};
}

/// Adds B of sheets that stand for the magnetisation M, whose parts across the axis only a single sheet may have.
class RoundField {
 public:
  /// `outwards` is -1 for the bore of a ring, outside of which is nearer to the axis.
  RoundField(const SheetBody& body, const Eigen::Vector3d& magnetisation, Wanted wanted, double outwards = 1.0)
      : body_(body),
        m_(magnetisation),
        wanted_(wanted),
        outwards_(outwards),
        diametral_(m_.x() != 0.0 || m_.y() != 0.0) {}

  void add(std::span<const Eigen::Vector3d> points, std::span<FieldSample> samples) const {
    for (std::size_t first = 0; first < points.size(); first += at_once) {
      const std::size_t count = std::min(at_once, points.size() - first);
      add_block(points.subspan(first, count), samples.subspan(first, count));
    }
  }

 private:
  // A point on a surface is put just outside.
  [[nodiscard]] Places places(std::span<const Eigen::Vector3d> points) const {
    Places at{};
    for (std::size_t i = 0; i < at_once; ++i) {
      const Eigen::Vector3d& point = points[std::min(i, points.size() - 1)];
      double& radius = at.radius[i] = std::hypot(point.x(), point.y());
      double& height = at.height[i] = point.z();
      const double size = body_.outer_radius + body_.half_length;
      if (std::abs(radius - body_.outer_radius) <= round_surface * size && std::abs(height) <= body_.half_length)
        radius = body_.outer_radius + outwards_ * round_surface * size;
      if (std::abs(std::abs(height) - body_.half_length) <= round_surface * size)
        height = std::copysign(body_.half_length + round_surface * size, height);
    }
    return at;
  }

  void add_block(std::span<const Eigen::Vector3d> points, std::span<FieldSample> samples) const {
    const Places at = places(points);
    const int loops = loops_for(body_, at);
    const Sheets here = sheets_at(body_, at, loops);
    const bool with_gradient = wanted_ == Wanted::gradient;
    const Sheets along = with_gradient ? slopes_at(body_, at) : Sheets{};
    const Block shear = with_gradient && diametral_ ? shears(at, here, loops) : Block{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double rho = at.radius[i];
      const Inside in = inside(body_, rho, at.height[i]);
      const double b = diametral_ ? hoop_element(body_, rho, at.height[i], loops) : 0.0;
      const double c = here.axial[i] - in.share;
      const double d = here.radial[i];
      const double a = -in.share - b - c;
      const double x = points[i].x();
      const double y = points[i].y();
      const double flat = std::hypot(x, y);
      const Eigen::Vector3d out = flat > 0.0 ? Eigen::Vector3d(x / flat, y / flat, 0.0) : Eigen::Vector3d(1, 0, 0);
      const Eigen::Vector3d round(-out.y(), out.x(), 0.0);
      const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
      const double outward = m_.dot(out);
      const double sideways = m_.dot(round);
      samples[i].flux_density += vacuum_permeability * ((a * outward + d * m_.z()) * out + b * sideways * round +
                                                        (d * outward + c * m_.z()) * up + in.share * m_);
      if (!with_gradient) continue;
      // On the axis d / r is its limit, half of what leaves along it.
      const double spread = flat > 1e-9 * body_.outer_radius ? d / rho : -0.5 * along.axial[i];
      const double c_z = along.axial[i];
      const double d_z = along.radial[i];
      const double a_z = -spread - c_z;
      const double b_r = shear[i];
      const Eigen::Vector3d by_r = ((-b_r - d_z) * outward + a_z * m_.z()) * out + b_r * sideways * round +
                                   (a_z * outward + (d_z + in.slope) * m_.z()) * up;
      const Eigen::Vector3d by_p =
          b_r * sideways * out + (b_r * outward + spread * m_.z()) * round + spread * sideways * up;
      const Eigen::Vector3d by_z =
          (a_z * outward + d_z * m_.z()) * out + spread * sideways * round + (d_z * outward + c_z * m_.z()) * up;
      samples[i].gradient +=
          vacuum_permeability * (by_r * out.transpose() + by_p * round.transpose() + by_z * up.transpose());
    }
  }

  // (T_rr - T_pp) / r, which is the slope of T_pp outwards.
  [[nodiscard]] Block shears(const Places& at, const Sheets& here, int loops) const {
    const double least = near_axis * body_.outer_radius;
    const bool near = std::ranges::any_of(at.radius, [&](double radius) { return radius < least; });
    Places off = at;
    for (double& radius : off.radius) radius = std::max(radius, least);
    const Sheets there = near ? sheets_at(body_, off, loops) : here;
    Block out{};
    for (std::size_t i = 0; i < at_once; ++i) {
      const double radius = off.radius[i];
      const double b = hoop_element(body_, radius, off.height[i], loops);
      // c and the trace both have the share inside, with signs that cancel.
      out[i] = (-there.axial[i] - 2.0 * b) / radius * (at.radius[i] / radius);
    }
    return out;
  }

  const SheetBody& body_;
  Eigen::Vector3d m_;  // A/m
  Wanted wanted_;
  double outwards_;
  bool diametral_;
};

SheetBody unit_sheet(double radius, double length) {
  return {.inner_radius = radius,
          .outer_radius = radius,
          .half_length = 0.5 * length,
          .surface_current = 1.0,
          .shells = 1,
          .spread = Spread::shells};
}

}  // namespace

void add_round_field(const DrivenCoil& coil, Wanted wanted, std::span<const Eigen::Vector3d> points,
                     std::span<FieldSample> samples) {
  const SheetBody body = sheets_of(coil.coil, coil.current);
  RoundField(body, {0.0, 0.0, body.surface_current}, wanted).add(points, samples);
}

void add_round_field(const Ring& ring, const Eigen::Vector3d& polarisation, Wanted wanted,
                     std::span<const Eigen::Vector3d> points, std::span<FieldSample> samples) {
  const Eigen::Vector3d magnetisation = polarisation / vacuum_permeability;
  const SheetBody outer = unit_sheet(ring.outer_radius, ring.length);
  RoundField(outer, magnetisation, wanted).add(points, samples);
  if (ring.inner_radius == 0.0) return;
  const SheetBody bore = unit_sheet(ring.inner_radius, ring.length);
  RoundField(bore, -magnetisation, wanted, -1.0).add(points, samples);
}

}  // namespace coilwright::magnetics
