#include "magnetics/field_kernels.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "magnetics/landen_steps.hpp"
#include "magnetics/radial_nodes.hpp"

// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "magnetics/field_kernels.cpp"  // NOLINT
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

#include "magnetics/landen-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace coilwright::magnetics::HWY_NAMESPACE {

struct Field {
  Vector radial;
  Vector axial;
};

/// What one end of a sheet of radius r adds to the field at radius rho, s above it; the radial part is times rho. It
/// is the field of the end's magnetic charge: the flux that runs inside the sheet is left to `flux_inside`. So it is
/// smooth across rho = r, and each end may have a rule of its own.
HWY_INLINE Field field_of_end(Tag d, Vector r, Vector rho, Vector s, int steps) {
  const Circles c = circles(d, r, rho, s);
  const Vector first = hn::Mul(c.first_c, hn::Add(c.first_c, c.first_c));
  const Vector two_r = hn::Add(r, r);
  const Vector sine = hn::MulAdd(c.difference, c.far, hn::Mul(c.near, c.sum));
  const Vector cosine = hn::CopySign(two_r, c.difference);
  const LandenResult result = finish(d, steps, start(d, c, hn::Add(sine, sine), cosine, first));
  const Vector flux = hn::IfThenElseZero(hn::Ge(c.difference, hn::Zero(d)), hn::CopySign(hn::Set(d, 0.5), s));
  Field field;
  field.radial = hn::Mul(hn::Mul(result.squares, result.inverse_mean), hn::Set(d, -0.125));
  field.axial = hn::MulSub(hn::Mul(hn::Mul(r, s), hn::Mul(c.w_inverse, hn::Set(d, 0.5))), result.third_kind, flux);
  return field;
}

/// Share of the sheets round a point between the two ends: the flux density inside an endless coil of unit current.
HWY_INLINE Vector flux_inside(Tag d, const SheetBody& body, Vector rho, Vector z) {
  Vector share = hn::Zero(d);
  if (body.spread == Spread::uniform) {
    const Vector outer = hn::Set(d, body.outer_radius);
    const Vector width = hn::Set(d, body.outer_radius - body.inner_radius);
    share = hn::Min(hn::Max(hn::Div(hn::Sub(outer, rho), width), hn::Zero(d)), hn::Set(d, 1.0));
  } else {
    const SheetNodes shells(body, 1.0);
    for (int i = 0; i < shells.count(); ++i)
      share =
          hn::Add(share, hn::IfThenElseZero(hn::Ge(hn::Set(d, shells.radius(i)), rho), hn::Set(d, shells.weight(i))));
  }
  return hn::IfThenElseZero(hn::Lt(hn::Abs(z), hn::Set(d, body.half_length)), share);
}

/// Field of a loop of unit current; the radial part is times rho.
HWY_INLINE Field field_of_loop(Tag d, Vector r, Vector rho, Vector s, int steps) {
  const Circles c = circles(d, r, rho, s);
  const Vector zero = hn::Zero(d);
  const Vector first = hn::Mul(c.first_c, hn::Add(c.first_c, c.first_c));
  const LandenResult result = finish(d, steps, start(d, c, zero, zero, first));
  const Vector t = hn::Mul(result.squares, hn::Set(d, 0.5));
  const Vector two_r2 = hn::Mul(r, hn::Add(r, r));
  const Vector rho2 = hn::Mul(rho, rho);
  const Vector q2 = hn::Add(hn::MulAdd(r, r, rho2), c.s2);
  const Vector near2 = hn::Add(c.difference2, c.s2);
  const Vector scale = hn::Div(hn::Mul(result.inverse_mean, hn::Set(d, 0.25)), hn::Mul(near2, c.far2));
  Field field;
  field.radial = hn::Mul(hn::Mul(s, scale), hn::NegMulAdd(q2, t, hn::Mul(hn::Add(two_r2, two_r2), rho2)));
  field.axial = hn::Mul(scale, hn::MulAdd(two_r2, hn::Sub(q2, hn::Add(rho2, rho2)), hn::Mul(hn::Sub(q2, two_r2), t)));
  return field;
}

/// What a block of eight points needs for loops at one height.
struct Effort {
  double rate;  // of Gauss-Legendre over the radius
  int steps;    // of the arithmetic-geometric mean
};

HWY_INLINE Effort effort_of_block(const SheetBody& body, const double* radius, const double* height, double level) {
  const Tag d;
  const Vector inner = hn::Set(d, body.inner_radius);
  const Vector outer = hn::Set(d, body.outer_radius);
  Vector to_ends = hn::Set(d, 1e300);
  Vector modulus = hn::Set(d, 1.0);
  for (std::size_t i = 0; i < block; i += hn::Lanes(d)) {
    const Vector rho = hn::LoadU(d, radius + i);
    const Vector s = hn::Sub(hn::LoadU(d, height + i), hn::Set(d, level));
    const Vector s2 = hn::Mul(s, s);
    const Vector to_inner = hn::Sub(rho, inner);
    const Vector to_outer = hn::Sub(rho, outer);
    to_ends = hn::Min(
        to_ends, hn::Add(hn::Sqrt(hn::MulAdd(to_inner, to_inner, s2)), hn::Sqrt(hn::MulAdd(to_outer, to_outer, s2))));
    const Vector r = hn::Min(hn::Max(rho, inner), outer);
    const Vector difference = hn::Sub(rho, r);
    const Vector sum = hn::Add(rho, r);
    modulus = hn::Min(modulus, hn::Div(hn::MulAdd(difference, difference, s2), hn::MulAdd(sum, sum, s2)));
  }
  const double length = body.outer_radius - body.inner_radius;
  const double nearest = hn::GetLane(hn::MinOfLanes(d, to_ends));
  const double least = hn::GetLane(hn::MinOfLanes(d, modulus));
  return {length > 0.0 ? gauss_rate(nearest, length) : 1e9, landen_steps_needed(least, field_moduli)};
}

/// Adds to `radial` (times rho) and `axial` of a block what the body's sheets give at one level, `weight` times.
template <class FieldOfLevel>
HWY_INLINE void add_level(const SheetNodes& nodes, int steps, double level, double weight, const double* radius,
                          const double* height, double* radial, double* axial, FieldOfLevel field_of_level) {
  const Tag d;
  const int count = nodes.count();
  for (std::size_t lane = 0; lane < block; lane += hn::Lanes(d)) {
    const Vector rho = hn::LoadU(d, radius + lane);
    const Vector s = hn::Sub(hn::LoadU(d, height + lane), hn::Set(d, level));
    Vector sum_radial = hn::LoadU(d, radial + lane);
    Vector sum_axial = hn::LoadU(d, axial + lane);
    for (int i = 0; i < count; ++i) {
      const Field one = field_of_level(d, hn::Set(d, nodes.radius(i)), rho, s, steps);
      const Vector w = hn::Set(d, weight * nodes.weight(i));
      sum_radial = hn::MulAdd(w, one.radial, sum_radial);
      sum_axial = hn::MulAdd(w, one.axial, sum_axial);
    }
    hn::StoreU(sum_radial, d, radial + lane);
    hn::StoreU(sum_axial, d, axial + lane);
  }
}

/// Near the axis the radial field is proportional to rho and its sum so far to rho^2: the floor keeps 0 / 0 out.
HWY_INLINE void divide_by_rho(const double* radius, double* radial) {
  const Tag d;
  for (std::size_t lane = 0; lane < block; lane += hn::Lanes(d)) {
    const Vector rho = hn::Max(hn::LoadU(d, radius + lane), hn::Set(d, 1e-150));
    hn::StoreU(hn::Div(hn::LoadU(d, radial + lane), rho), d, radial + lane);
  }
}

void sheets(const SheetBody& body, double log_error, const FieldPoints& points, const FieldValues& values) {
  const Tag d;
  const auto end = [](Tag tag, Vector r, Vector rho, Vector s, int steps)
                       HWY_ATTR { return field_of_end(tag, r, rho, s, steps); };
  for (std::size_t j = 0; j < points.radius.size(); j += block) {
    const double* radius = points.radius.data() + j;
    const double* height = points.height.data() + j;
    double* radial = values.radial.data() + j;
    double* axial = values.axial.data() + j;
    for (std::size_t lane = 0; lane < block; lane += hn::Lanes(d)) {
      const Vector inside = flux_inside(d, body, hn::LoadU(d, radius + lane), hn::LoadU(d, height + lane));
      hn::StoreU(hn::Zero(d), d, radial + lane);
      hn::StoreU(inside, d, axial + lane);
    }
    // Both efforts first: each is a chain of scalars, and two take no longer than one.
    const Effort lower = effort_of_block(body, radius, height, -body.half_length);
    const Effort upper = effort_of_block(body, radius, height, body.half_length);
    const SheetNodes lower_nodes(body, gauss_nodes_needed(lower.rate, log_error));
    const SheetNodes upper_nodes(body, gauss_nodes_needed(upper.rate, log_error));
    add_level(lower_nodes, lower.steps, -body.half_length, 1.0, radius, height, radial, axial, end);
    add_level(upper_nodes, upper.steps, body.half_length, -1.0, radius, height, radial, axial, end);
    divide_by_rho(radius, radial);
  }
}

void loops(const SheetBody& body, double log_error, const QuadratureRule& along, const FieldPoints& points,
           const FieldValues& values) {
  const auto loop = [](Tag tag, Vector r, Vector rho, Vector s, int steps)
                        HWY_ATTR { return field_of_loop(tag, r, rho, s, steps); };
  for (std::size_t j = 0; j < points.radius.size(); j += block) {
    double* radial = values.radial.data() + j;
    double* axial = values.axial.data() + j;
    std::fill_n(radial, block, 0.0);
    std::fill_n(axial, block, 0.0);
    for (std::size_t k = 0; k < along.count; ++k) {
      const double level = body.half_length * along.node[k];
      const Effort effort = effort_of_block(body, points.radius.data() + j, points.height.data() + j, level);
      const SheetNodes nodes(body, gauss_nodes_needed(effort.rate, log_error));
      add_level(nodes, effort.steps, level, 2.0 * body.half_length * along.weight[k], points.radius.data() + j,
                points.height.data() + j, radial, axial, loop);
    }
    divide_by_rho(points.radius.data() + j, radial);
  }
}

}  // namespace coilwright::magnetics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coilwright::magnetics {

HWY_EXPORT(sheets);
HWY_EXPORT(loops);

void field_of_sheets(const SheetBody& body, double log_error, const FieldPoints& points, const FieldValues& values) {
  assert(points.radius.size() % 8 == 0 && points.height.size() == points.radius.size());
  HWY_DYNAMIC_DISPATCH(sheets)(body, log_error, points, values);
}

void field_of_loops(const SheetBody& body, double log_error, const QuadratureRule& along, const FieldPoints& points,
                    const FieldValues& values) {
  assert(points.radius.size() % 8 == 0 && points.height.size() == points.radius.size());
  HWY_DYNAMIC_DISPATCH(loops)(body, log_error, along, points, values);
}

}  // namespace coilwright::magnetics
#endif  // HWY_ONCE
