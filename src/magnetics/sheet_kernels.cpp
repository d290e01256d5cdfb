#include "magnetics/sheet_kernels.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

// Highway compiles this file once per instruction set and picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "magnetics/sheet_kernels.cpp"  // NOLINT
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace coilwright::magnetics::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Tag>;
constexpr std::size_t block = 8;

/// Descending Landen transformation (arithmetic-geometric mean) shared by the complete integrals of all three kinds.
/// Holds 2^n times the means, Bulirsch's p as the fraction p/q (no division per step) and his two coefficients; see
/// docs/theory-magnetics.md, "One sequence for K, E and Pi".
struct Landen {
  Vector arithmetic;  // 2^n a_n
  Vector geometric;   // 2^n g_n
  Vector p;
  Vector q;
  Vector sine;     // Bulirsch's s times the product of p so far
  Vector cosine;   // Bulirsch's c times the same
  Vector squares;  // sum of 2^n c_n^2, c_n = (a_{n-1} - g_{n-1}) / 2
};

/// What a finished sequence gives.
struct LandenResult {
  Vector inverse_mean;  // 1 / a_n at the end: 2 K / pi
  Vector squares;
  Vector third_kind;  // (s + c e) / (e (e q + p)): Bulirsch's cel up to a factor known beforehand
};

HWY_INLINE void step_p(Vector product, Landen& x) {
  const Vector w = hn::Mul(product, x.q);
  const Vector cosine = hn::MulAdd(x.cosine, x.p, hn::Mul(x.sine, x.q));
  const Vector sine = hn::MulAdd(x.sine, x.p, hn::Mul(x.cosine, w));
  x.cosine = cosine;
  x.sine = hn::Add(sine, sine);
  const Vector p = hn::MulAdd(x.p, x.p, hn::Mul(w, x.q));
  x.q = hn::Mul(x.p, x.q);
  x.p = p;
}

/// `scale` is 1 / 2^(n+1) of the first step. The last mean is corrected by -c^2 / (4 a), which makes the error fourth
/// order in the last c and saves a step.
HWY_INLINE LandenResult finish(Tag d, int steps, Landen x) {
  double scale = 0.25;
  for (int i = 0; i < steps; ++i) {
    const Vector difference = hn::Sub(x.arithmetic, x.geometric);
    const Vector product = hn::Mul(x.arithmetic, x.geometric);
    x.squares = hn::MulAdd(hn::Mul(difference, difference), hn::Set(d, scale), x.squares);
    step_p(product, x);
    x.arithmetic = hn::Add(x.arithmetic, x.geometric);
    const Vector root = hn::Sqrt(product);
    x.geometric = hn::Add(root, root);
    scale *= 0.5;
  }
  const Vector difference = hn::Sub(x.arithmetic, x.geometric);
  const Vector square = hn::Mul(difference, difference);
  x.squares = hn::MulAdd(square, hn::Set(d, scale), x.squares);
  step_p(hn::Mul(x.arithmetic, x.geometric), x);
  const Vector mean = hn::Add(x.arithmetic, x.geometric);
  // The corrected mean is b / mean.
  const Vector b = hn::NegMulAdd(square, hn::Set(d, 0.25), hn::Mul(mean, mean));
  const Vector t = hn::MulAdd(b, x.q, hn::Mul(mean, x.p));
  const Vector inverse = hn::Div(hn::Set(d, 1.0), hn::Mul(b, t));
  const Vector mean_inverse = hn::Mul(mean, inverse);
  LandenResult result;
  result.third_kind = hn::Mul(mean_inverse, hn::MulAdd(x.sine, mean, hn::Mul(x.cosine, b)));
  result.inverse_mean = hn::Mul(hn::Mul(mean_inverse, t), hn::Set(d, 1.0 / scale));
  result.squares = x.squares;
  return result;
}

/// Lengths of two coaxial circles of radii r and rho, offset s, from which everything starts.
struct Circles {
  Vector sum;          // r + rho
  Vector difference;   // r - rho
  Vector difference2;  // its square
  Vector s2;           // s^2
  Vector far2;         // (r + rho)^2 + s^2
  Vector far;          // its root: farthest distance of the circles
  Vector near;         // nearest distance
  Vector first_mean;   // far + near = 2 a_1
  Vector first_c;      // c_1 = (far - near) / 2, without cancellation
  Vector w_inverse;    // 1 / (far difference2 + near sum^2)
};

HWY_INLINE Circles circles(Tag d, Vector r, Vector rho, Vector s) {
  Circles c;
  c.sum = hn::Add(r, rho);
  c.difference = hn::Sub(r, rho);
  c.difference2 = hn::Mul(c.difference, c.difference);
  c.s2 = hn::Mul(s, s);
  const Vector sum2 = hn::Mul(c.sum, c.sum);
  c.far2 = hn::Add(sum2, c.s2);
  c.far = hn::Sqrt(c.far2);
  // The floor keeps touching circles finite; what they are multiplied by is zero there.
  c.near = hn::Sqrt(hn::MulAdd(c.far2, hn::Set(d, 1e-30), hn::Add(c.difference2, c.s2)));
  c.first_mean = hn::Add(c.far, c.near);
  const Vector w = hn::MulAdd(c.far, c.difference2, hn::Mul(c.near, sum2));
  const Vector both = hn::Div(hn::Set(d, 1.0), hn::Mul(w, c.first_mean));
  c.first_c = hn::Mul(hn::Mul(hn::Mul(hn::Set(d, 2.0), r), rho), hn::Mul(both, w));
  c.w_inverse = hn::Mul(both, c.first_mean);
  return c;
}

HWY_INLINE Landen start(Tag d, const Circles& c, Vector sine, Vector cosine, Vector squares) {
  Landen x;
  x.arithmetic = c.first_mean;
  const Vector root = hn::Sqrt(hn::Mul(c.far, c.near));
  x.geometric = hn::Add(root, root);
  x.p = hn::Set(d, 1.0);
  x.q = hn::Mul(hn::Mul(hn::Abs(c.difference), c.sum), c.w_inverse);
  x.sine = sine;
  x.cosine = cosine;
  x.squares = squares;
  return x;
}

/// Phi / mu0 of two circles: s M / 2 + 4 pi s (r rho)^2 (...) / w^2 * third kind.
HWY_INLINE Vector inductance_integral(Tag d, Vector r, Vector rho, Vector s, int steps) {
  const Circles c = circles(d, r, rho, s);
  const Vector first = hn::Mul(c.first_c, hn::Add(c.first_c, c.first_c));
  const LandenResult result = finish(d, steps, start(d, c, hn::Set(d, 1.0), hn::Zero(d), first));
  const Vector half_inductance =
      hn::Mul(hn::Mul(result.squares, result.inverse_mean), hn::Set(d, std::numbers::pi / 8.0));
  const Vector product = hn::Mul(r, rho);
  const Vector sum_s = hn::Mul(c.sum, c.sum);
  const Vector weight = hn::MulAdd(c.difference2, c.far2, hn::Mul(c.s2, sum_s));
  const Vector factor = hn::Mul(hn::Mul(hn::Mul(product, product), hn::Set(d, 4.0 * std::numbers::pi)),
                                hn::Mul(weight, hn::Mul(c.w_inverse, c.w_inverse)));
  return hn::Mul(s, hn::MulAdd(factor, result.third_kind, half_inductance));
}

/// M / mu0 of two circles.
HWY_INLINE Vector inductance(Tag d, Vector r, Vector rho, Vector s, int steps) {
  const Circles c = circles(d, r, rho, s);
  const Vector first = hn::Mul(c.first_c, hn::Add(c.first_c, c.first_c));
  const Vector zero = hn::Zero(d);
  const LandenResult result = finish(d, steps, start(d, c, zero, zero, first));
  return hn::Mul(hn::Mul(result.squares, result.inverse_mean), hn::Set(d, std::numbers::pi / 4.0));
}

template <class Integral>
HWY_INLINE double sum_over_pairs(std::span<const FacePair> pairs, double other_radius, Integral integral) {
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  const Vector rho = hn::Set(d, other_radius);
  // Eight running sums whatever the vector width, added in one order at the end: the same bits on 4 and 8 lanes.
  HWY_ALIGN std::array<double, block> sums{};
  for (std::size_t lane = 0; lane < block; lane += lanes) {
    Vector sum = hn::Zero(d);
    for (const FacePair& pair : pairs) {
      const Vector s = hn::Set(d, pair.offset);
      const Vector sign = hn::Set(d, pair.sign);
      const Vector centre = hn::Set(d, pair.nodes.centre);
      const Vector half = hn::Set(d, pair.nodes.half_width);
      for (std::size_t i = lane; i < pair.nodes.rule.padded_count; i += block) {
        const Vector r = hn::MulAdd(half, hn::LoadU(d, pair.nodes.rule.node + i), centre);
        const Vector w = hn::Mul(sign, hn::LoadU(d, pair.nodes.rule.weight + i));
        sum = hn::MulAdd(w, integral(d, r, rho, s, pair.landen_steps), sum);
      }
    }
    hn::StoreU(sum, d, sums.data() + lane);
  }
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

double inductance_integrals(std::span<const FacePair> pairs, double other_radius) {
  return sum_over_pairs(pairs, other_radius, [](Tag d, Vector r, Vector rho, Vector s, int steps) HWY_ATTR {
    return inductance_integral(d, r, rho, s, steps);
  });
}

double inductances(std::span<const FacePair> pairs, double other_radius) {
  return sum_over_pairs(pairs, other_radius, [](Tag d, Vector r, Vector rho, Vector s, int steps) HWY_ATTR {
    return inductance(d, r, rho, s, steps);
  });
}

struct EndField {
  Vector radial;
  Vector axial;
};

/// Field of a sheet of unit current from minus infinity up to a face, at `s` above... as a difference of two faces
/// only: the constant that would make each one a half-infinite solenoid cancels.
HWY_INLINE EndField field_of_face(Tag d, Vector r, Vector rho, Vector s, int steps) {
  const Circles c = circles(d, r, rho, s);
  const Vector two_r = hn::Add(r, r);
  // c_1^2 / rho, finite on the axis: c_1 = 2 r rho / first_mean.
  const Vector ratio = hn::Div(two_r, c.first_mean);
  const Vector sine = hn::MulAdd(c.difference, c.far, hn::Mul(c.near, c.sum));
  const Vector cosine = hn::CopySign(two_r, c.difference);
  const LandenResult result = finish(d, steps, start(d, c, hn::Add(sine, sine), cosine, hn::Zero(d)));
  const Vector safe_rho = hn::Max(rho, hn::Set(d, 1e-300));
  const Vector over_rho = hn::MulAdd(hn::Mul(ratio, ratio), hn::Add(rho, rho), hn::Div(result.squares, safe_rho));
  EndField field;
  field.radial = hn::Mul(hn::Mul(over_rho, result.inverse_mean), hn::Set(d, -0.125));
  field.axial = hn::Mul(hn::Mul(hn::Mul(r, s), hn::Mul(c.w_inverse, hn::Set(d, 0.5))), result.third_kind);
  return field;
}

void sheets(const RadialNodes& nodes, double half_length, int steps, const FieldPoints& points,
            const FieldValues& values) {
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  const Vector half = hn::Set(d, half_length);
  for (std::size_t j = 0; j < points.radius.size(); j += lanes) {
    const Vector rho = hn::LoadU(d, points.radius.data() + j);
    const Vector z = hn::LoadU(d, points.height.data() + j);
    const Vector above_bottom = hn::Add(z, half);
    const Vector above_top = hn::Sub(z, half);
    Vector radial = hn::Zero(d);
    Vector axial = hn::Zero(d);
    for (std::size_t i = 0; i < nodes.rule.count; ++i) {
      const Vector r = hn::Set(d, nodes.centre + nodes.half_width * nodes.rule.node[i]);
      const Vector w = hn::Set(d, nodes.rule.weight[i]);
      const EndField bottom = field_of_face(d, r, rho, above_bottom, steps);
      const EndField top = field_of_face(d, r, rho, above_top, steps);
      radial = hn::MulAdd(w, hn::Sub(bottom.radial, top.radial), radial);
      axial = hn::MulAdd(w, hn::Sub(bottom.axial, top.axial), axial);
    }
    hn::StoreU(radial, d, values.radial.data() + j);
    hn::StoreU(axial, d, values.axial.data() + j);
  }
}

}  // namespace coilwright::magnetics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coilwright::magnetics {

HWY_EXPORT(inductance_integrals);
HWY_EXPORT(inductances);
HWY_EXPORT(sheets);

namespace {

constexpr double square_root(double x) {
  double root = x < 1.0 ? 1.0 : x;
  for (double next = 0.5 * (root + x / root); next < root; next = 0.5 * (root + x / root)) root = next;
  return root;
}

/// squared_moduli[i] is the least k'^2 for which i steps are enough: the means then differ by less than 4e-4, and the
/// neglected fourth power, ((1 - g/a) / 2)^4, is below 2e-15. One step turns k' into 2 sqrt(k') / (1 + k').
constexpr std::array<double, 9> squared_moduli = [] {
  std::array<double, 9> least{};
  double ratio = 1.0 - 4e-4;
  for (double& square : least) {
    const double root = ratio / (1.0 + square_root((1.0 - ratio) * (1.0 + ratio)));
    ratio = root * root;
    square = ratio * ratio;
  }
  return least;
}();

}  // namespace

int landen_steps_needed(double near_squared, double far_squared) {
  int steps = 0;
  while (steps < 9 && near_squared < squared_moduli[static_cast<std::size_t>(steps)] * far_squared) ++steps;
  return steps;
}

double sum_of_inductance_integrals(std::span<const FacePair> pairs, double other_radius) {
  return HWY_DYNAMIC_DISPATCH(inductance_integrals)(pairs, other_radius);
}

double sum_of_inductances(std::span<const FacePair> pairs, double other_radius) {
  return HWY_DYNAMIC_DISPATCH(inductances)(pairs, other_radius);
}

void field_of_sheets(const RadialNodes& nodes, double half_length, int landen_steps, const FieldPoints& points,
                     const FieldValues& values) {
  assert(points.radius.size() % 8 == 0);
  HWY_DYNAMIC_DISPATCH(sheets)(nodes, half_length, landen_steps, points, values);
}

}  // namespace coilwright::magnetics
#endif  // HWY_ONCE
