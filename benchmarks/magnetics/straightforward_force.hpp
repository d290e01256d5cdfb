#pragma once

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <cmath>

namespace coilwright::benchmarks {

/// Sizes of a coil and a magnet as the paper's Table II has them, SI.
struct PaperPair {
  double inner_radius, outer_radius, coil_length;
  int turns_radial, turns_axial;
  double magnet_radius, magnet_length, remanence;
};

/// The program one writes straight from the paper's (13)-(19), its two slips mended (no 1/N_r; K, E, Pi of the
/// parameter m = k^2): the baseline all speed figures are ratios to. Force of a coil on a magnet, N/A, attraction
/// negative. Fails where faces are level or r = R_m, as printed.
inline double straightforward_force(const PaperPair& p, double z) {
  double force = 0.0;
  const double j2 = p.turns_axial / p.coil_length;
  for (int n = 0; n < p.turns_radial; ++n) {
    const double r = p.inner_radius + n * (p.outer_radius - p.inner_radius) / (p.turns_radial - 1);
    for (const double e1 : {1.0, -1.0})
      for (const double e2 : {1.0, -1.0}) {
        const double s1 = z - (e1 * p.magnet_length + e2 * p.coil_length) / 2.0;
        const double s2 = (p.magnet_radius - r) * (p.magnet_radius - r) / (s1 * s1) + 1.0;
        const double s3 = std::sqrt((p.magnet_radius + r) * (p.magnet_radius + r) + s1 * s1);
        const double s4 = 4.0 * p.magnet_radius * r / (s3 * s3);
        const double k = std::sqrt(s4);
        const double fs = boost::math::ellint_1(k) - boost::math::ellint_2(k) / s2 +
                          (s1 * s1 / (s3 * s3) - 1.0) * boost::math::ellint_3(k, s4 / (1.0 - s2));
        force += e1 * e2 * s1 * s2 * s3 * fs;
      }
  }
  return p.remanence * j2 / 2.0 * force;
}

}  // namespace coilwright::benchmarks
