#include "coilwright/magnetics/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coilwright/magnetics/axial_force.hpp"
#include "magnetics/require.hpp"

namespace coilwright::magnetics {
namespace {

constexpr int first_intervals = 12;
constexpr int max_intervals = 192;

/// cos(pi j / n) for j = 0 .. n, symmetric to the bit.
double chebyshev_point(int j, int n) {
  return std::sin(0.5 * std::numbers::pi * (n - 2 * j) / n);
}

using Samples = std::array<double, max_intervals + 1>;

/// Coefficients of the Chebyshev series through the samples at cos(pi j / n), all of its n + 1 terms.
void chebyshev_series(const Samples& values, int n, Samples& series) {
  std::array<double, 2 * max_intervals> cosine;
  for (int m = 0; m < 2 * n; ++m) cosine[m] = m <= n ? chebyshev_point(m, n) : cosine[2 * n - m];
  for (int k = 0; k <= n; ++k) {
    double sum = 0.5 * (values[0] + (k % 2 == 0 ? values[n] : -values[n]));
    for (int j = 1; j < n; ++j) sum += values[j] * cosine[(j * k) % (2 * n)];
    series[k] = sum * (k == 0 || k == n ? 1.0 : 2.0) / n;
  }
}

/// Bound on what the series leaves out. An interpolant errs by at most twice the sum of the missing coefficients
/// (Trefethen, Approximation Theory and Approximation Practice, th. 4.2), which fall geometrically for a smooth
/// function: at the rate seen between the middle and the end of the series.
double truncation_bound(const Samples& series, int n) {
  const auto largest = [&](int from, int count) {
    double most = 0.0;
    for (int k = from; k < from + count; ++k) most = std::max(most, std::abs(series[k]));
    return most;
  };
  const double end = largest(n - 2, 3);
  const double middle = largest(n / 2 - 1, 3);
  const double rate = end < middle ? std::pow(end / middle, 2.0 / n) : 1.0;
  return rate < 0.98 ? 2.0 * end * rate / (1.0 - rate) : 100.0 * end;
}

}  // namespace

Curve::Curve(BatchFunction function, const Spec& spec) : lower_(spec.lower), upper_(spec.upper) {
  require_finite("curve lower", spec.lower);
  require(std::isfinite(spec.upper) && spec.upper > spec.lower, "curve upper",
          fmt::format("finite and > lower ({})", spec.lower), spec.upper);
  require(spec.tolerance >= 1e-13 && spec.tolerance < 1.0, "curve tolerance", ">= 1e-13 and < 1", spec.tolerance);

  const double middle = 0.5 * (lower_ + upper_);
  const double half = 0.5 * (upper_ - lower_);
  Samples values;
  Samples series;
  Samples points;
  Samples fresh;
  for (int n = first_intervals;; n *= 2) {
    // Chebyshev points are nested: doubling needs only those with odd numbers.
    const bool first = n == first_intervals;
    int count = 0;
    for (int j = first ? 0 : 1; j <= n; j += first ? 1 : 2) points[count++] = middle + half * chebyshev_point(j, n);
    function({points.data(), static_cast<std::size_t>(count)}, {fresh.data(), static_cast<std::size_t>(count)});
    evaluations_ += count;
    if (!first)
      for (int j = n / 2; j >= 0; --j) values[2 * j] = values[j];
    for (int i = 0, j = first ? 0 : 1; i < count; ++i, j += first ? 1 : 2) {
      require(std::isfinite(fresh[i]), "curve function", fmt::format("finite at {}", points[i]), fresh[i]);
      values[j] = fresh[i];
      scale_ = std::max(scale_, std::abs(fresh[i]));
    }
    chebyshev_series(values, n, series);
    error_bound_ = truncation_bound(series, n);
    if (error_bound_ <= 0.5 * spec.tolerance * scale_) {
      cut({series.data(), static_cast<std::size_t>(n) + 1}, 0.5 * spec.tolerance * scale_);
      return;
    }
    if (2 * n > max_intervals)
      throw std::domain_error(
          fmt::format("curve over [{}, {}]: tolerance {} not reached with {} points; error about {}", lower_, upper_,
                      spec.tolerance, n + 1, error_bound_ / scale_));
  }
}

void Curve::cut(std::span<const double> series, double tolerance) {
  constexpr int points = degree + 1;
  // Values at the Chebyshev roots of a piece -> local Chebyshev coefficients -> powers of t.
  std::array<std::array<double, points>, points> cosine;
  for (int k = 0; k < points; ++k)
    for (int j = 0; j < points; ++j) cosine[k][j] = std::cos(std::numbers::pi * k * (j + 0.5) / points);
  double worst = 0.0;
  for (pieces_ = 4;; pieces_ *= 2) {
    worst = 0.0;
    for (int piece = 0; piece < pieces_; ++piece) {
      std::array<double, points> x;
      std::array<double, points> b1{};
      std::array<double, points> b2{};
      for (int j = 0; j < points; ++j) x[j] = (2 * piece + 1 + cosine[1][j]) / pieces_ - 1.0;
      for (std::size_t k = series.size() - 1; k > 0; --k)
        for (int j = 0; j < points; ++j) {
          const double b = series[k] + 2.0 * x[j] * b1[j] - b2[j];
          b2[j] = b1[j];
          b1[j] = b;
        }
      std::array<double, points> local;
      for (int k = 0; k < points; ++k) {
        local[k] = 0.0;
        for (int j = 0; j < points; ++j) local[k] += (series[0] + x[j] * b1[j] - b2[j]) * cosine[k][j];
        local[k] *= (k == 0 ? 1.0 : 2.0) / points;
      }
      worst = std::max(worst, 2.0 * (std::abs(local[degree]) + std::abs(local[degree - 1])));
      // T_k in powers by its recurrence.
      Piece powers{};
      Piece before{};
      Piece now{};
      before[0] = 1.0;
      now[1] = 1.0;
      powers[0] = local[0];
      for (int k = 1; k <= degree; ++k) {
        for (int i = 0; i <= k; ++i) powers[i] += local[k] * now[i];
        Piece next{};
        for (int i = 0; i <= k && i < degree; ++i) next[i + 1] = 2.0 * now[i];
        for (int i = 0; i <= degree; ++i) next[i] -= before[i];
        before = now;
        now = next;
      }
      coefficients_[piece] = powers;
    }
    if (worst <= tolerance || pieces_ == max_pieces) break;
  }
  if (worst > tolerance)
    throw std::domain_error(fmt::format("curve over [{}, {}]: not smooth enough for {} pieces; error about {}", lower_,
                                        upper_, max_pieces, worst / scale_));
  error_bound_ += worst;
  pieces_per_unit_ = pieces_ / (upper_ - lower_);
}

Curve torque_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                   Fidelity fidelity, const Curve::Spec& spec) {
  const auto torque = [&](std::span<const double> angles, std::span<double> torques) {
    std::transform(angles.begin(), angles.end(), torques.begin(),
                   [&](double angle) { return hinge_torque_per_ampere(coil, magnet, geometry, fidelity, angle); });
  };
  return Curve(torque, spec);
}

Curve force_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    axial_force_per_ampere(coil, magnet, distances, forces);
  };
  return Curve(force, spec);
}

Curve force_curve(const CylinderMagnet& first, const CylinderMagnet& second, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    std::transform(distances.begin(), distances.end(), forces.begin(),
                   [&](double distance) { return axial_force(first, second, distance); });
  };
  return Curve(force, spec);
}

Curve force_curve(const ThickCoil& first, const ThickCoil& second, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    std::transform(distances.begin(), distances.end(), forces.begin(),
                   [&](double distance) { return axial_force(first, 1.0, second, 1.0, distance); });
  };
  return Curve(force, spec);
}

}  // namespace coilwright::magnetics
