#include "truth/torque_curves.hpp"

#include <algorithm>
#include <array>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "degree.hpp"
#include "truth/current_loops.hpp"

namespace truth {
namespace {

using std::numbers::pi;

double shell_radius(const Pair& pair, int shell) {
  return pair.inner_radius + (pair.outer_radius - pair.inner_radius) * shell / (pair.turns_radial - 1.0);
}

double shell_current(const Pair& pair) {
  return pair.turns_axial / pair.coil_length;
}  // A/m per A

// The joint is the origin, the chain's axis -y as it hangs, "across" is -x: the paper's own frame, as complex numbers.
// A centre at `along` of a link that makes `angle` with the vertical:
std::complex<double> centre(double along, double offset, double angle) {
  return std::complex<double>(-offset, -along) * std::polar(1.0, angle);
}

using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;
constexpr double lowest = -60.0 * degree;
constexpr double highest = 150.0 * degree;

template <typename Function>
Spline tabulate(Function&& function, int intervals) {
  const double step = (highest - lowest) / intervals;
  std::vector<double> values;
  for (int i = 0; i <= intervals; ++i) values.push_back(function(lowest + i * step));
  return {values.begin(), values.end(), lowest, step};
}

double inside(double angle) {
  return std::clamp(angle, lowest, highest);
}

}  // namespace

double coaxial_force(const Pair& pair, double z) {
  // A loop of the coil at height s feels of the magnet's sheet, whose ends are at z -+ l_m / 2, the integral of dM/ds:
  // the difference of M at the ends. Loops of one shell lie side by side: an integral over the coil's length.
  const double magnet_sheet = pair.remanence / mu0;
  double force = 0.0;
  for (int shell = 0; shell < pair.turns_radial; ++shell) {
    const double radius = shell_radius(pair, shell);
    force += boost::math::quadrature::gauss<double, 40>::integrate(
        [&](double s) {
          return mutual_inductance(radius, pair.magnet_radius, z - 0.5 * pair.magnet_length - s) -
                 mutual_inductance(radius, pair.magnet_radius, z + 0.5 * pair.magnet_length - s);
        },
        -0.5 * pair.coil_length, 0.5 * pair.coil_length);
  }
  return magnet_sheet * shell_current(pair) * force;
}

double line_of_centres_torque(const Pair& pair, double angle) {
  const std::complex<double> coil = centre(-pair.coil_offset, pair.axis_offset, 0.0);
  const std::complex<double> magnet = centre(pair.magnet_offset, pair.axis_offset, angle);
  const std::complex<double> line = magnet - coil;
  const double distance = std::abs(line);
  // arm: moment of the unit push from coil to magnet, acting at the magnet, about the joint
  const double arm = std::imag(std::conj(magnet) * line) / distance;
  return coaxial_force(pair, distance) * arm;
}

double exact_torque(const Pair& pair, double angle) {
  // In the coil's frame its axis is +z (towards the magnet) and "across, away from the joint" is +x.
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  const auto coil_field = [&](double radius, double height) {
    LoopField sum;
    for (int shell = 0; shell < pair.turns_radial; ++shell) {
      const double a = shell_radius(pair, shell);
      const auto add = [&](double abscissa, double weight) {
        const LoopField one = loop_field(a, radius, height - 0.5 * pair.coil_length * abscissa);
        sum.radial += weight * one.radial;
        sum.axial += weight * one.axial;
      };
      for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
        add(Gauss::abscissa()[i], Gauss::weights()[i]);
        add(-Gauss::abscissa()[i], Gauss::weights()[i]);
      }
    }
    const double scale = shell_current(pair) * 0.5 * pair.coil_length;
    return LoopField{.radial = scale * sum.radial, .axial = scale * sum.axial};
  };

  // Joint at x = -h, z = coil_offset. Opening lifts the magnet's far side: x turns towards z. The magnet's current runs
  // against the coil's, since positive current repels.
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  constexpr int points = 64;  // half a ring; the other half is its mirror image
  double torque = 0.0;
  using AlongMagnet = boost::math::quadrature::gauss<double, 10>;
  const auto ring = [&](double along) {
    double sum = 0.0;
    for (int i = 0; i < points; ++i) {
      const double turn = pi * (i + 0.5) / points;
      // on the magnet: across u = R cos(turn), out of plane v = R sin(turn); from the joint across h + u
      const double across = pair.axis_offset + pair.magnet_radius * std::cos(turn);
      const double out = pair.magnet_radius * std::sin(turn);
      const double arm_x = across * cosine - along * sine;
      const double arm_z = along * cosine + across * sine;
      const double x = arm_x - pair.axis_offset;
      const double z = arm_z + pair.coil_offset;
      const double radius = std::hypot(x, out);
      const LoopField field = coil_field(radius, z);
      const double bx = field.radial * x / radius;
      const double by = field.radial * out / radius;
      const double bz = field.axial;
      // tangent of the ring (counter-clockwise about the magnet's axis), reversed: the magnet's current
      const double tx = std::sin(turn) * cosine;
      const double ty = -std::cos(turn);
      const double tz = std::sin(turn) * sine;
      const double fx = ty * bz - tz * by;
      const double fz = tx * by - ty * bx;
      sum += arm_x * fz - arm_z * fx;  // turns x to z: opening
    }
    return sum;
  };
  for (std::size_t i = 0; i < AlongMagnet::abscissa().size(); ++i) {
    const double half = 0.5 * pair.magnet_length;
    const double weight = AlongMagnet::weights()[i] * half;
    torque += weight * (ring(pair.magnet_offset + half * AlongMagnet::abscissa()[i]) +
                        ring(pair.magnet_offset - half * AlongMagnet::abscissa()[i]));
  }
  return pair.remanence / mu0 * 2.0 * pair.magnet_radius * pi / points * torque;
}

double coil_coil_inductance(const Pair& pair, double first_angle, double second_angle) {
  // Neumann: the flux of coil 1 through coil 2 is the line integral of its vector potential. Far apart (19.8 mm and
  // more): few loops do.
  const double h = pair.axis_offset;
  const std::complex<double> base = centre(-pair.coil_offset, h, 0.0);
  const std::complex<double> second_joint = centre(2.0 * pair.magnet_offset, 0.0, first_angle);
  const double tilt = first_angle + second_angle;
  const std::complex<double> tip = second_joint + centre(pair.coil_offset, h, tilt);
  const std::complex<double> apart = tip - base;
  const double x0 = -apart.real();  // across, the side away from the joints counted negative here: only squares matter
  const double z0 = -apart.imag();  // along
  using Gauss = boost::math::quadrature::gauss<double, 4>;
  std::array<double, 4> nodes{};
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < 2; ++i) {
    nodes[2 * i] = Gauss::abscissa()[i];
    nodes[2 * i + 1] = -Gauss::abscissa()[i];
    weights[2 * i] = weights[2 * i + 1] = 0.5 * Gauss::weights()[i];
  }
  const double mean = 0.5 * (pair.inner_radius + pair.outer_radius);
  // Shells at both edges spread a little wider than copper everywhere: nodes of a build with the shells' variance.
  const double half_build =
      0.5 * (pair.outer_radius - pair.inner_radius) * std::sqrt((pair.turns_radial + 1.0) / (pair.turns_radial - 1.0));
  const double half_length = 0.5 * pair.coil_length;
  constexpr int points = 16;
  const double sine = std::sin(tilt);
  const double cosine = std::cos(tilt);
  double sum = 0.0;
  for (int r1 = 0; r1 < 4; ++r1)
    for (int s1 = 0; s1 < 4; ++s1)
      for (int r2 = 0; r2 < 4; ++r2)
        for (int s2 = 0; s2 < 4; ++s2) {
          const double a = mean + half_build * nodes[r1];
          const double b = mean + half_build * nodes[r2];
          const double along = half_length * nodes[s2];
          double circulation = 0.0;
          for (int i = 0; i < points; ++i) {
            const double turn = pi * (i + 0.5) / points;
            const double u = b * std::cos(turn);
            const double x = x0 + u * cosine - along * sine;
            const double y = b * std::sin(turn);
            const double z = z0 + along * cosine + u * sine - half_length * nodes[s1];
            const double radius = std::hypot(x, y);
            const double tx = -b * std::sin(turn) * cosine;
            const double ty = b * std::cos(turn);
            circulation += loop_potential(a, radius, z) * (x * ty - y * tx) / radius;
          }
          sum += weights[r1] * weights[s1] * weights[r2] * weights[s2] * circulation * 2.0 * pi / points;
        }
  const double turns = pair.turns_radial * pair.turns_axial;
  return turns * turns * sum;
}

namespace curves {

double line_of_centres(double angle) {
  static const Spline curve = tabulate([](double t) { return line_of_centres_torque({}, t); }, 420);
  return curve(inside(angle));
}

double exact(double angle) {
  // From -10 degrees on, where the parts would have met: deeper the torque is that of -10 degrees.
  constexpr double first = -10.0 * degree;
  constexpr int intervals = 80;
  static const Spline curve = [] {
    const double step = (highest - first) / intervals;
    std::vector<double> values;
    for (int i = 0; i <= intervals; ++i) values.push_back(exact_torque({}, first + i * step));
    return Spline(values.begin(), values.end(), first, step);
  }();
  return curve(std::clamp(angle, first, highest));
}

CoilCoilTorque coil_coil(double first_angle, double second_angle) {
  // Polynomial through Chebyshev points in both angles, -8 to 92 degrees: closer the coils would meet.
  constexpr int order = 12;
  constexpr double middle = 42.0 * degree;
  constexpr double half = 50.0 * degree;
  using Grid = std::array<std::array<double, order>, order>;
  static const Grid coefficients = [] {
    Grid value{};
    const auto node = [](int i) { return std::cos(pi * (i + 0.5) / order); };
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j)
        value[i][j] = coil_coil_inductance({}, middle + half * node(i), middle + half * node(j));
    Grid result{};
    for (int p = 0; p < order; ++p)
      for (int q = 0; q < order; ++q) {
        double sum = 0.0;
        for (int i = 0; i < order; ++i)
          for (int j = 0; j < order; ++j)
            sum += value[i][j] * std::cos(p * pi * (i + 0.5) / order) * std::cos(q * pi * (j + 0.5) / order);
        result[p][q] = sum * (p == 0 ? 1.0 : 2.0) * (q == 0 ? 1.0 : 2.0) / (order * order);
      }
    return result;
  }();
  std::array<std::array<double, order>, 2> value{};
  std::array<std::array<double, order>, 2> slope{};
  const std::array<double, 2> at{std::clamp((first_angle - middle) / half, -1.0, 1.0),
                                 std::clamp((second_angle - middle) / half, -1.0, 1.0)};
  for (int axis = 0; axis < 2; ++axis) {
    value[axis][0] = 1.0;
    value[axis][1] = at[axis];
    slope[axis][1] = 1.0;
    for (int n = 2; n < order; ++n) {
      value[axis][n] = 2.0 * at[axis] * value[axis][n - 1] - value[axis][n - 2];
      slope[axis][n] = 2.0 * value[axis][n - 1] + 2.0 * at[axis] * slope[axis][n - 1] - slope[axis][n - 2];
    }
  }
  CoilCoilTorque torque;
  for (int p = 0; p < order; ++p)
    for (int q = 0; q < order; ++q) {
      torque.first += coefficients[p][q] * slope[0][p] * value[1][q] / half;
      torque.second += coefficients[p][q] * value[0][p] * slope[1][q] / half;
    }
  return torque;
}

}  // namespace curves
}  // namespace truth
