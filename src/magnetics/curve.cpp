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

/// cos(pi m / max_intervals) for a whole turn, symmetric to the bit; every smaller number of intervals divides it.
const std::array<double, 2 * max_intervals>& cosines() {
  static const auto table = [] {
    std::array<double, 2 * max_intervals> cosine;
    for (int m = 0; m <= max_intervals; ++m)
      cosine[m] = std::sin(0.5 * std::numbers::pi * (max_intervals - 2 * m) / max_intervals);
    for (int m = max_intervals + 1; m < 2 * max_intervals; ++m) cosine[m] = cosine[2 * max_intervals - m];
    return cosine;
  }();
  return table;
}

double chebyshev_point(int j, int n) {
  return cosines()[static_cast<std::size_t>(j * (max_intervals / n))];
}

using Samples = std::array<double, max_intervals + 1>;

/// Coefficients of the Chebyshev series through the samples at cos(pi j / n), all of its n + 1 terms.
void chebyshev_series(const Samples& values, int n, Samples& series) {
  const auto& cosine = cosines();
  const int stride = max_intervals / n;
  for (int k = 0; k <= n; ++k) {
    double sum = 0.5 * (values[0] + (k % 2 == 0 ? values[n] : -values[n]));
    for (int j = 1, m = k * stride; j < n; ++j) {
      sum += values[j] * cosine[m];
      m += k * stride;
      if (m >= 2 * max_intervals) m -= 2 * max_intervals;
    }
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

/// Linear maps from the values at the Chebyshev roots of a piece.
template <int points>
struct PieceMaps {
  std::array<double, points> root;
  std::array<std::array<double, points>, points> to_powers;  // [value][power]
  std::array<double, points> to_last;                        // the two highest Chebyshev coefficients
  std::array<double, points> to_last_but_one;

  PieceMaps() : to_powers{} {
    std::array<double, points> before{};  // T_(k-1) in powers
    std::array<double, points> now{};     // T_k
    before[1] = 1.0;                      // T_(-1) = T_1
    now[0] = 1.0;
    for (int k = 0; k < points; ++k) {
      for (int j = 0; j < points; ++j) {
        const double coefficient = (k == 0 ? 1.0 : 2.0) / points * std::cos(std::numbers::pi * k * (j + 0.5) / points);
        for (int i = 0; i <= k; ++i) to_powers[j][i] += coefficient * now[i];
        if (k == 1) root[j] = 0.5 * points * coefficient;
        if (k == points - 1) to_last[j] = coefficient;
        if (k == points - 2) to_last_but_one[j] = coefficient;
      }
      std::array<double, points> next{};
      for (int i = 0; i + 1 < points; ++i) next[i + 1] = 2.0 * now[i];
      for (int i = 0; i < points; ++i) next[i] -= before[i];
      before = now;
      now = next;
    }
  }
};

}  // namespace

Curve::Curve(BatchFunction function, const Spec& spec)
    : lower_(spec.lower),
      upper_(spec.upper),
      origin_(spec.lower - (spec.boundary_layer_width > 0.0 ? spec.boundary_layer_width : spec.upper - spec.lower)) {
  require_finite("curve lower", spec.lower);
  require(std::isfinite(spec.upper) && spec.upper > spec.lower, "curve upper",
          fmt::format("finite and > lower ({})", spec.lower), spec.upper);
  require(spec.tolerance >= 1e-13 && spec.tolerance < 1.0, "curve tolerance", ">= 1e-13 and < 1", spec.tolerance);
  require(std::isfinite(spec.boundary_layer_width) && spec.boundary_layer_width >= 0.0, "curve boundary_layer_width",
          "finite and >= 0", spec.boundary_layer_width);

  const double from = std::log(lower_ - origin_);
  const double to = std::log(upper_ - origin_);
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  Samples values;
  Samples series;
  Samples points;
  Samples fresh;
  for (int n = first_intervals;; n *= 2) {
    // Chebyshev points are nested: doubling needs only those with odd numbers.
    const bool first = n == first_intervals;
    int count = 0;
    for (int j = first ? 0 : 1; j <= n; j += first ? 1 : 2)
      points[count++] = std::clamp(origin_ + std::exp(middle + half * chebyshev_point(j, n)), lower_, upper_);
    function({points.data(), static_cast<std::size_t>(count)}, {fresh.data(), static_cast<std::size_t>(count)});
    evaluations_ += count;
    if (!first)
      for (int j = n / 2; j >= 0; --j) values[2 * j] = values[j];
    for (int i = 0, j = first ? 0 : 1; i < count; ++i, j += first ? 1 : 2) {
      if (!std::isfinite(fresh[i]))
        throw std::invalid_argument(fmt::format("curve function must be finite; got {} at {}", fresh[i], points[i]));
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

/// Interpolates the series between two distances from the origin; returns a bound on the error that adds.
double Curve::set_piece(Piece& piece, double from, double to, std::span<const double> series) const {
  constexpr int points = degree + 1;
  static const PieceMaps<points> maps;
  const double first = std::log(lower_ - origin_);
  const double last = std::log(upper_ - origin_);
  piece.centre = 0.5 * (from + to);
  piece.scale = 2.0 / (to - from);
  std::array<double, points> x;
  for (int j = 0; j < points; ++j)
    x[j] = (2.0 * std::log(piece.centre + 0.5 * (to - from) * maps.root[j]) - first - last) / (last - first);
  // Clenshaw's recurrence for all points at once.
  std::array<double, points> b1{};
  std::array<double, points> b2{};
  for (std::size_t k = series.size() - 1; k > 0; --k)
    for (int j = 0; j < points; ++j) {
      const double b = series[k] + 2.0 * x[j] * b1[j] - b2[j];
      b2[j] = b1[j];
      b1[j] = b;
    }
  piece.powers.fill(0.0);
  double highest = 0.0;
  double next = 0.0;
  for (int j = 0; j < points; ++j) {
    const double value = series[0] + x[j] * b1[j] - b2[j];
    for (int i = 0; i < points; ++i) piece.powers[i] += maps.to_powers[j][i] * value;
    highest += maps.to_last[j] * value;
    next += maps.to_last_but_one[j] * value;
  }
  return 2.0 * (std::abs(highest) + std::abs(next));
}

void Curve::cut(std::span<const double> series, double tolerance) {
  const double from = lower_ - origin_;
  const double to = upper_ - origin_;
  double worst = 0.0;
  // One bit of the mantissa more halves every piece.
  for (shift_ = 51; shift_ > 40; --shift_) {
    first_ = std::bit_cast<std::uint64_t>(from) >> shift_;
    const std::uint64_t count = (std::bit_cast<std::uint64_t>(to) >> shift_) - first_ + 1;
    if (count > max_pieces) break;
    worst = 0.0;
    for (std::uint64_t i = 0; i < count && worst <= tolerance; ++i) {
      const double start = std::bit_cast<double>((first_ + i) << shift_);
      const double end = std::bit_cast<double>((first_ + i + 1) << shift_);
      const double begin = std::max(start, from);
      // A last piece of no width holds only the upper end itself.
      const double finish = std::max(std::min(end, to), begin + 1e-3 * (end - start));
      worst = std::max(worst, set_piece(pieces_[i], begin, finish, series));
    }
    if (worst <= tolerance) {
      error_bound_ += worst;
      return;
    }
  }
  throw std::domain_error(fmt::format("curve over [{}, {}]: not smooth enough for {} pieces; error about {}", lower_,
                                      upper_, max_pieces, worst / scale_));
}

namespace {

Curve::Spec with_boundary_layer(Curve::Spec spec, double boundary_layer_width) {
  if (spec.boundary_layer_width == 0.0)
    spec.boundary_layer_width = std::min(boundary_layer_width, spec.upper - spec.lower);
  return spec;
}

}  // namespace

Curve torque_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                   Fidelity fidelity, const Curve::Spec& spec) {
  const auto torque = [&](std::span<const double> angles, std::span<double> torques) {
    std::transform(angles.begin(), angles.end(), torques.begin(),
                   [&](double angle) { return hinge_torque_per_ampere(coil, magnet, geometry, fidelity, angle); });
  };
  // The torque varies over the angle in which the centres move apart by a fraction of their first distance.
  const double reach = 0.5 * (geometry.coil_offset + geometry.magnet_offset) / geometry.axis_offset;
  return Curve(torque, with_boundary_layer(spec, 0.3 * reach));
}

Curve force_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    axial_force_per_ampere(coil, magnet, distances, forces);
  };
  return Curve(force, with_boundary_layer(spec, coil.outer_radius()));
}

Curve force_curve(const CylinderMagnet& first, const CylinderMagnet& second, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    std::transform(distances.begin(), distances.end(), forces.begin(),
                   [&](double distance) { return axial_force(first, second, distance); });
  };
  return Curve(force, with_boundary_layer(spec, first.radius()));
}

Curve force_curve(const ThickCoil& first, const ThickCoil& second, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    std::transform(distances.begin(), distances.end(), forces.begin(),
                   [&](double distance) { return axial_force(first, 1.0, second, 1.0, distance); });
  };
  return Curve(force, with_boundary_layer(spec, first.outer_radius()));
}

}  // namespace coilwright::magnetics
