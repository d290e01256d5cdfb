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

#include "magnetics/landen-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace coilwright::magnetics::HWY_NAMESPACE {
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

}  // namespace coilwright::magnetics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coilwright::magnetics {

HWY_EXPORT(inductance_integrals);
HWY_EXPORT(inductances);

double sum_of_inductance_integrals(std::span<const FacePair> pairs, double other_radius) {
  return HWY_DYNAMIC_DISPATCH(inductance_integrals)(pairs, other_radius);
}

double sum_of_inductances(std::span<const FacePair> pairs, double other_radius) {
  return HWY_DYNAMIC_DISPATCH(inductances)(pairs, other_radius);
}

}  // namespace coilwright::magnetics
#endif  // HWY_ONCE
