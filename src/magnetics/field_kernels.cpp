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

/// What one end of a sheet of radius r adds to the field at radius rho, s above it; the radial part is times rho. Only
/// the difference of two ends is a field: the constant that would make each a half-infinite solenoid is left out.
HWY_INLINE Field field_of_end(Tag d, Vector r, Vector rho, Vector s, int steps) {
  const Circles c = circles(d, r, rho, s);
  const Vector first = hn::Mul(c.first_c, hn::Add(c.first_c, c.first_c));
  const Vector two_r = hn::Add(r, r);
  const Vector sine = hn::MulAdd(c.difference, c.far, hn::Mul(c.near, c.sum));
  const Vector cosine = hn::CopySign(two_r, c.difference);
  const LandenResult result = finish(d, steps, start(d, c, hn::Add(sine, sine), cosine, first));
  Field field;
  field.radial = hn::Mul(hn::Mul(result.squares, result.inverse_mean), hn::Set(d, -0.125));
  field.axial = hn::Mul(hn::Mul(hn::Mul(r, s), hn::Mul(c.w_inverse, hn::Set(d, 0.5))), result.third_kind);
  return field;
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

/// What a block of eight points needs.
struct Effort {
  double rate;             // of Gauss-Legendre over the radius
  double squared_modulus;  // k'^2, the least
};

HWY_INLINE Effort effort_of_block(const SheetBody& body, const double* radius, const double* height) {
  const Tag d;
  const Vector inner = hn::Set(d, body.inner_radius);
  const Vector outer = hn::Set(d, body.outer_radius);
  const Vector half = hn::Set(d, body.half_length);
  Vector to_ends = hn::Set(d, 1e300);
  Vector modulus = hn::Set(d, 1.0);
  for (std::size_t i = 0; i < block; i += hn::Lanes(d)) {
    const Vector rho = hn::LoadU(d, radius + i);
    // The nearer end decides.
    const Vector s = hn::Sub(hn::Abs(hn::LoadU(d, height + i)), half);
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
  return {length > 0.0 ? gauss_rate(nearest, length) : 1e9, hn::GetLane(hn::MinOfLanes(d, modulus))};
}

template <class FieldOfRadius>
HWY_INLINE void sum_over_sheets(const SheetBody& body, double error, const FieldPoints& points,
                                const FieldValues& values, FieldOfRadius field_of_radius) {
  const Tag d;
  for (std::size_t j = 0; j < points.radius.size(); j += block) {
    const Effort effort = effort_of_block(body, points.radius.data() + j, points.height.data() + j);
    const int steps = landen_steps_needed(effort.squared_modulus, field_moduli);
    const SheetNodes nodes(body, gauss_nodes_needed(effort.rate, error));
    for (std::size_t lane = j; lane < j + block; lane += hn::Lanes(d)) {
      const Vector rho = hn::LoadU(d, points.radius.data() + lane);
      const Vector z = hn::LoadU(d, points.height.data() + lane);
      Field sum{hn::Zero(d), hn::Zero(d)};
      for (int i = 0; i < nodes.count(); ++i) {
        const Field one = field_of_radius(d, hn::Set(d, nodes.radius(i)), rho, z, steps);
        const Vector w = hn::Set(d, nodes.weight(i));
        sum.radial = hn::MulAdd(w, one.radial, sum.radial);
        sum.axial = hn::MulAdd(w, one.axial, sum.axial);
      }
      // Near the axis the radial field is proportional to rho, its sum to rho^2: the floor only keeps 0 / 0 out.
      const Vector floor = hn::Set(d, 1e-150);
      hn::StoreU(hn::Div(sum.radial, hn::Max(rho, floor)), d, values.radial.data() + lane);
      hn::StoreU(sum.axial, d, values.axial.data() + lane);
    }
  }
}

void sheets(const SheetBody& body, double error, const FieldPoints& points, const FieldValues& values) {
  const double half_length = body.half_length;
  sum_over_sheets(body, error, points, values,
                  [half_length](Tag d, Vector r, Vector rho, Vector z, int steps) HWY_ATTR {
                    const Vector half = hn::Set(d, half_length);
                    const Field bottom = field_of_end(d, r, rho, hn::Add(z, half), steps);
                    const Field top = field_of_end(d, r, rho, hn::Sub(z, half), steps);
                    return Field{hn::Sub(bottom.radial, top.radial), hn::Sub(bottom.axial, top.axial)};
                  });
}

void loops(const SheetBody& body, double error, const QuadratureRule& along, const FieldPoints& points,
           const FieldValues& values) {
  const double half_length = body.half_length;
  sum_over_sheets(body, error, points, values,
                  [half_length, &along](Tag d, Vector r, Vector rho, Vector z, int steps) HWY_ATTR {
                    Field sum{hn::Zero(d), hn::Zero(d)};
                    for (std::size_t k = 0; k < along.count; ++k) {
                      const Vector s = hn::Sub(z, hn::Set(d, half_length * along.node[k]));
                      const Field one = field_of_loop(d, r, rho, s, steps);
                      const Vector w = hn::Set(d, 2.0 * half_length * along.weight[k]);
                      sum.radial = hn::MulAdd(w, one.radial, sum.radial);
                      sum.axial = hn::MulAdd(w, one.axial, sum.axial);
                    }
                    return sum;
                  });
}

}  // namespace coilwright::magnetics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coilwright::magnetics {

HWY_EXPORT(sheets);
HWY_EXPORT(loops);

void field_of_sheets(const SheetBody& body, double error, const FieldPoints& points, const FieldValues& values) {
  assert(points.radius.size() % 8 == 0 && points.height.size() == points.radius.size());
  HWY_DYNAMIC_DISPATCH(sheets)(body, error, points, values);
}

void field_of_loops(const SheetBody& body, double error, const QuadratureRule& along, const FieldPoints& points,
                    const FieldValues& values) {
  assert(points.radius.size() % 8 == 0 && points.height.size() == points.radius.size());
  HWY_DYNAMIC_DISPATCH(loops)(body, error, along, points, values);
}

}  // namespace coilwright::magnetics
#endif  // HWY_ONCE
