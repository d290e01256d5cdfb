// Included once per instruction set by Highway, hence no #pragma once but this toggle.
#if defined(COILWRIGHT_MAGNETICS_LANDEN_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef COILWRIGHT_MAGNETICS_LANDEN_INL_HPP
#undef COILWRIGHT_MAGNETICS_LANDEN_INL_HPP
#else
#define COILWRIGHT_MAGNETICS_LANDEN_INL_HPP
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace coilwright::magnetics::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, 8>;
using Vector = hn::Vec<Tag>;
constexpr std::size_t block = 8;

/// Descending Landen transformation (arithmetic-geometric mean) shared by the complete integrals of all three kinds.
/// Holds 2^n times the means, Bulirsch's p as the fraction p/q (no division per step) and his two coefficients; see
/// docs/theory/magnetics.md, "One sequence for K, E and Pi".
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

/// One step of Bulirsch's p, c and s. All four are halved, which changes no result and keeps p near 1 where the means
/// have converged, where it would otherwise square itself out of range.
HWY_INLINE void step_p(Tag d, Vector product, Landen& x) {
  const Vector half = hn::Set(d, 0.5);
  const Vector half_p = hn::Mul(half, x.p);
  const Vector half_q = hn::Mul(half, x.q);
  const Vector w = hn::Mul(product, x.q);
  const Vector cosine = hn::MulAdd(x.cosine, half_p, hn::Mul(x.sine, half_q));
  x.sine = hn::MulAdd(x.sine, x.p, hn::Mul(x.cosine, w));
  x.cosine = cosine;
  x.q = hn::Mul(half_p, x.q);
  x.p = hn::MulAdd(half_p, x.p, hn::Mul(w, half_q));
}

/// `scale` is 1 / 2^(n+1) of the first step. The last mean is corrected by -c^2 / (4 a), which makes the error fourth
/// order in the last c and saves a step.
HWY_INLINE LandenResult finish(Tag d, int steps, Landen x) {
  double scale = 0.25;
  for (int i = 0; i < steps; ++i) {
    const Vector difference = hn::Sub(x.arithmetic, x.geometric);
    const Vector product = hn::Mul(x.arithmetic, x.geometric);
    x.squares = hn::MulAdd(hn::Mul(difference, difference), hn::Set(d, scale), x.squares);
    step_p(d, product, x);
    x.arithmetic = hn::Add(x.arithmetic, x.geometric);
    const Vector root = hn::Sqrt(product);
    x.geometric = hn::Add(root, root);
    scale *= 0.5;
  }
  const Vector difference = hn::Sub(x.arithmetic, x.geometric);
  const Vector square = hn::Mul(difference, difference);
  x.squares = hn::MulAdd(square, hn::Set(d, scale), x.squares);
  step_p(d, hn::Mul(x.arithmetic, x.geometric), x);
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
  Vector first_mean_inverse;
  Vector first_c;    // c_1 = (far - near) / 2, without cancellation
  Vector w_inverse;  // 1 / (far difference2 + near sum^2)
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
  c.first_mean_inverse = hn::Mul(both, w);
  c.first_c = hn::Mul(hn::Mul(hn::Add(r, r), rho), c.first_mean_inverse);
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

}  // namespace coilwright::magnetics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
