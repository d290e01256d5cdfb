#include "straightforward.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <cmath>
#include <numbers>

namespace coilwright::simulation {
namespace {

// Tables I and II of the paper.
constexpr double l0 = 6.3e-3, l1 = 3.6e-3, l2 = 9.1e-3, h = 11.5e-3, m1 = 16.5e-3, m2 = 22.5e-3;
constexpr double k = 12.5e-3, b = 1.29e-4, g = 9.81;
constexpr double magnet_radius = 10e-3, magnet_length = 6e-3, remanence = 1.44;
constexpr double inner = 3e-3, outer = 9.5e-3, coil_length = 12e-3;
constexpr int shells = 15, turns_axial = 30;

// One of the four terms of the paper's (15), with (17)-(19); Boost takes the modulus, the paper the parameter. Where a
// magnet's face is level with a coil's (s1 = 0) the term is zero: its limit.
double face_term(double r, double s1) {
  if (s1 == 0.0) return 0.0;
  const double s2 = (magnet_radius - r) * (magnet_radius - r) / (s1 * s1) + 1.0;
  const double s3 = std::sqrt((magnet_radius + r) * (magnet_radius + r) + s1 * s1);
  const double s4 = 4.0 * magnet_radius * r / (s3 * s3);
  const double modulus = std::sqrt(s4);
  const double f = boost::math::ellint_1(modulus) - boost::math::ellint_2(modulus) / s2 +
                   (s1 * s1 / (s3 * s3) - 1.0) * boost::math::ellint_3(modulus, s4 / (1.0 - s2));
  return s1 * s2 * s3 * f;
}

double torque(double angle, double current) {
  const double q = h * h - l0 * l1;
  const double z =
      std::sqrt(l0 * l0 + l1 * l1 + 2.0 * h * h - 2.0 * q * std::cos(angle) + 2.0 * h * (l0 + l1) * std::sin(angle));
  const double arm = (q * std::sin(angle) + h * (l0 + l1) * std::cos(angle)) / z;
  return shell_force(z, current) * arm;
}

using State = std::array<double, 4>;

// The paper's (9)-(12).
State slope(const State& s, double current) {
  const double t1 = s[0], t2 = s[1], w1 = s[2], w2 = s[3];
  const double c2 = std::cos(t2), s2 = std::sin(t2);
  const double m12 = m2 * (h * h + l2 * l2 + 2 * l1 * l2 * c2 + 2 * h * l1 * s2);
  const double m22 = m2 * (h * h + l2 * l2);
  const double m11 = m1 * (h * h + l1 * l1) + m2 * (h * h + 4 * l1 * l1 + l2 * l2 + 4 * l1 * l2 * c2 + 4 * h * l1 * s2);
  const double e = 2 * m2 * l1 * (h * c2 - l2 * s2);
  const double g2 = g * m2 * (l2 * std::sin(t1 + t2) - h * std::cos(t1 + t2));
  const double g1 = g * ((m1 * l1 + 2 * m2 * l1) * std::sin(t1) - m1 * h * std::cos(t1)) + g2;
  const double f1 = torque(t1, current) - k * t1 - b * w1 - g1 - e * w2 * (2 * w1 + w2);
  const double f2 = torque(t2, current) - k * t2 - b * w2 - g2 + e * w1 * w1;
  const double determinant = m11 * m22 - m12 * m12;
  return {w1, w2, (m22 * f1 - m12 * f2) / determinant, (m11 * f2 - m12 * f1) / determinant};
}

State moved(const State& s, const State& d, double by) {
  State out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = s[i] + by * d[i];
  return out;
}

}  // namespace

double shell_force(double distance, double current) {
  double sum = 0.0;
  for (int i = 0; i < shells; ++i) {
    const double r = inner + (outer - inner) * i / (shells - 1);
    for (const double e1 : {1.0, -1.0})
      for (const double e2 : {1.0, -1.0})
        sum += e1 * e2 * face_term(r, distance - 0.5 * (e1 * magnet_length + e2 * coil_length));
  }
  // -J1 J2 / 2 mu0 of (15) and (16) for repulsion, without (13)'s division by the number of shells.
  return -0.5 * remanence * turns_axial * current / coil_length * sum;
}

double peak_speed(const Straightforward& step) {
  constexpr double dt = 1e-4;
  constexpr double degree = std::numbers::pi / 180.0;
  State s{13.517 * degree, 7.548 * degree, 0.0, 0.0};
  double peak = 0.0;
  const int steps = static_cast<int>(std::lround(step.duration / dt));
  for (int i = 0; i < steps; ++i) {
    const State a = slope(s, step.current);
    const State c = slope(moved(s, a, 0.5 * dt), step.current);
    const State d = slope(moved(s, c, 0.5 * dt), step.current);
    const State f = slope(moved(s, d, dt), step.current);
    for (std::size_t j = 0; j < 4; ++j) s[j] += dt / 6.0 * (a[j] + 2.0 * c[j] + 2.0 * d[j] + f[j]);
    peak = std::max(peak, std::abs(s[2] + s[3]));
  }
  return peak;
}

}  // namespace coilwright::simulation
