#include "coilwright/magnetics/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "magnetics/require.hpp"

namespace coilwright::magnetics {
namespace {

constexpr int first_intervals = 8;
constexpr int max_intervals = 64;
constexpr int whole_turn = 2 * max_intervals;
/// Series with a decay below this share of what the next doubling needs are doubled all the same: halving costs more.
constexpr double nearly = 10.0;

/// cos(pi m / max_intervals) for a whole turn, symmetric to the bit; every smaller number of intervals divides it.
const std::array<double, whole_turn>& cosines() {
  static const auto table = [] {
    std::array<double, whole_turn> cosine;
    for (int m = 0; m <= max_intervals; ++m)
      cosine[m] = std::sin(0.5 * std::numbers::pi * (max_intervals - 2 * m) / max_intervals);
    for (int m = max_intervals + 1; m < whole_turn; ++m) cosine[m] = cosine[whole_turn - m];
    return cosine;
  }();
  return table;
}

double chebyshev_point(int j, int n) {
  const int m = j * (max_intervals / n);
  return cosines()[static_cast<std::size_t>(m)];
}

/// A panel that needed this many is next to a singularity; its decay may mislead.
constexpr int suspicious_intervals = 32;

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

double largest_of(const Samples& series, int from, int count) {
  double most = 0.0;
  for (int k = from; k < from + count; ++k) most = std::max(most, std::abs(series[k]));
  return most;
}

/// Bound on what the series leaves out. An interpolant errs by at most twice the sum of the missing coefficients
/// (Trefethen, Approximation Theory and Approximation Practice, th. 4.2). They fall geometrically for a smooth function
/// and like a power next to a weak singularity; which of the two is not known, so the larger sum is taken, from the
/// largest of the last three on, each with the decay seen between the middle and the end of the series. Where nothing
/// decays (noise) it is n times the last.
double truncation_bound(const Samples& series, int n) {
  int last = n;
  for (const int k : {n - 1, n - 2})
    if (std::abs(series[k]) > std::abs(series[last])) last = k;
  const double end = std::abs(series[last]);
  const double middle = largest_of(series, n / 2 - 1, 3);
  double terms = n;
  if (end < 0.5 * middle) {
    const double gain = std::max(end / middle, 1e-300);
    const double rate = std::pow(gain, 2.0 / n);
    const double power = -std::log2(gain);
    const double geometric = std::pow(rate, n + 1 - last) / (1.0 - rate);
    const double algebraic = n / (power - 1.0) * std::pow(static_cast<double>(last) / n, power);
    terms = std::min(terms, std::max(geometric, algebraic));
  }
  return 2.0 * terms * end;
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

/// Whether twice the points would bring `bound` down to about `wanted`, by the decay from the middle to the end.
bool doubling_helps(const Samples& series, int n, double bound, double wanted) {
  if (2 * n > max_intervals) return false;
  if (n == first_intervals) return true;  // too few to tell
  const double middle = largest_of(series, n / 2 - 1, 3);
  const double gain = largest_of(series, n - 2, 3) / middle;
  return bound * gain * gain <= nearly * wanted;
}

constexpr int piece_points = 10;
constexpr int piece_checks = 2;  // at the ends of a piece, where its polynomial errs most
using PieceValues = std::array<double, piece_points + piece_checks>;

/// A panel's series, in x = slope * log(distance) + shift.
struct LogarithmicSeries {
  std::span<const double> series;
  double slope;
  double shift;

  [[nodiscard]] PieceValues at(const PieceValues& distances) const {
    constexpr int count = piece_points + piece_checks;
    PieceValues x;
    for (int j = 0; j < count; ++j) x[j] = slope * std::log(distances[j]) + shift;
    // Clenshaw's recurrence for all points at once.
    PieceValues b1{};
    PieceValues b2{};
    for (std::size_t k = series.size() - 1; k > 0; --k)
      for (int j = 0; j < count; ++j) {
        const double b = series[k] + 2.0 * x[j] * b1[j] - b2[j];
        b2[j] = b1[j];
        b1[j] = b;
      }
    for (int j = 0; j < count; ++j) b1[j] = series[0] + x[j] * b1[j] - b2[j];
    return b1;
  }
};

/// Polynomial of a piece and a bound on the error that it adds.
struct PiecePolynomial {
  std::array<double, piece_points> powers{};
  double error;
};

PiecePolynomial interpolate(const LogarithmicSeries& series, double from, double to) {
  static const PieceMaps<piece_points> maps;
  PieceValues distances;
  for (int j = 0; j < piece_points; ++j) distances[j] = 0.5 * (from + to) + 0.5 * (to - from) * maps.root[j];
  distances[piece_points] = from;
  distances[piece_points + 1] = to;
  const PieceValues values = series.at(distances);
  PiecePolynomial out{};
  double highest = 0.0;
  double next = 0.0;
  for (int j = 0; j < piece_points; ++j) {
    for (int i = 0; i < piece_points; ++i) out.powers[i] += maps.to_powers[j][i] * values[j];
    highest += maps.to_last[j] * values[j];
    next += maps.to_last_but_one[j] * values[j];
  }
  double first = 0.0;
  double last = 0.0;
  for (int i = 0; i < piece_points; ++i) {
    first += i % 2 == 0 ? out.powers[i] : -out.powers[i];
    last += out.powers[i];
  }
  out.error = 2.0 * std::max({std::abs(highest) + std::abs(next), std::abs(first - values[piece_points]),
                              std::abs(last - values[piece_points + 1])});
  return out;
}

}  // namespace

struct Curve::Panel {
  double from;  // logarithm of the distance
  double to;
  int intervals;
  std::array<double, max_intervals + 1> series;
};

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
  std::vector<Panel> panels;
  resolve(function, spec.tolerance, panels);
  cut(panels, 0.5 * spec.tolerance * scale_);
}

/// Doubles the points of a panel until its bound is below half the tolerance or more of them would not help; returns
/// the bound.
double Curve::refine(const BatchFunction& function, double tolerance, Panel& panel) {
  const double middle = 0.5 * (panel.from + panel.to);
  const double half = 0.5 * (panel.to - panel.from);
  Samples values;
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
      for (int from = n / 2, to = n; from >= 0; --from, to -= 2) values[to] = values[from];
    for (int i = 0, j = first ? 0 : 1; i < count; ++i, j += first ? 1 : 2) {
      if (!std::isfinite(fresh[i]))
        throw std::invalid_argument(fmt::format("curve function must be finite; got {} at {}", fresh[i], points[i]));
      values[j] = fresh[i];
      scale_ = std::max(scale_, std::abs(fresh[i]));
    }
    chebyshev_series(values, n, panel.series);
    panel.intervals = n;
    const double bound = truncation_bound(panel.series, n);
    const double wanted = 0.5 * tolerance * scale_;
    if (bound > wanted && doubling_helps(panel.series, n, bound, wanted)) continue;
    return n < suspicious_intervals ? bound : std::max(bound, 2.0 * miss_near_lower_end(function, panel));
  }
}

/// Error of a panel's series half-way between its two lowest points, where the next singularity mostly is.
double Curve::miss_near_lower_end(const BatchFunction& function, const Panel& panel) {
  const int n = panel.intervals;
  const double x = std::cos(std::numbers::pi * (n - 0.5) / n);
  const double distance = std::exp(0.5 * (panel.from + panel.to) + 0.5 * (panel.to - panel.from) * x);
  const double point = std::clamp(origin_ + distance, lower_, upper_);
  double value = 0.0;
  function({&point, 1}, {&value, 1});
  ++evaluations_;
  double b1 = 0.0;
  double b2 = 0.0;
  for (int k = n; k > 0; --k) {
    const double b = panel.series[k] + 2.0 * x * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  return std::abs(panel.series[0] + x * b1 - b2 - value);
}

void Curve::resolve(const BatchFunction& function, double tolerance, std::vector<Panel>& panels) {
  struct Part {
    double from;
    double to;
  };
  std::vector<Part> left{{std::log(lower_ - origin_), std::log(upper_ - origin_)}};
  while (!left.empty()) {
    Panel panel{.from = left.back().from, .to = left.back().to, .intervals = 0, .series = {}};
    left.pop_back();
    const double bound = refine(function, tolerance, panel);
    if (bound <= 0.5 * tolerance * scale_) {
      error_bound_ = std::max(error_bound_, bound);
      panels.push_back(panel);
      continue;
    }
    if (evaluations_ > max_evaluations)
      throw std::domain_error(
          fmt::format("curve over [{}, {}]: tolerance {} not reached with {} points; error about {} near {}", lower_,
                      upper_, tolerance, evaluations_, bound / scale_, origin_ + std::exp(panel.from)));
    const double middle = 0.5 * (panel.from + panel.to);
    left.push_back({middle, panel.to});
    left.push_back({panel.from, middle});
  }
}

/// Pieces from the lower end on, each as long as its polynomial allows.
void Curve::cut(const std::vector<Panel>& panels, double tolerance) {
  constexpr double longer = 1.7;
  constexpr double shorter = 0.6;
  double worst = 0.0;
  double width = 0.5 * (lower_ - origin_);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    double start = i == 0 ? lower_ - origin_ : pieces_.back().end;
    const double last = i + 1 == panels.size() ? upper_ - origin_ : std::exp(panel.to);
    const LogarithmicSeries series{{panel.series.data(), static_cast<std::size_t>(panel.intervals) + 1},
                                   2.0 / (panel.to - panel.from),
                                   -(panel.from + panel.to) / (panel.to - panel.from)};
    while (start < last) {
      double end = start + width < last ? start + width : last;
      PiecePolynomial piece = interpolate(series, start, end);
      for (; piece.error > tolerance && end - start > 1e-6 * (last - start); piece = interpolate(series, start, end))
        end = start + shorter * (end - start);
      worst = std::max(worst, piece.error);
      pieces_.push_back(
          {.end = end, .centre = 0.5 * (start + end), .scale = 2.0 / (end - start), .powers = piece.powers});
      width = longer * (end - start);
      start = end;
    }
  }
  error_bound_ += worst;
  pieces_.back().end = std::numeric_limits<double>::infinity();
  number_cells();
}

/// As many cells of equal mantissa bits as there is room for, each with the first piece that reaches into it.
void Curve::number_cells() {
  const auto from = std::bit_cast<std::uint64_t>(lower_ - origin_);
  const auto to = std::bit_cast<std::uint64_t>(upper_ - origin_);
  shift_ = 40;
  while ((to >> shift_) - (from >> shift_) + 1 > max_cells) ++shift_;
  first_ = from >> shift_;
  std::uint16_t piece = 0;
  for (std::uint64_t cell = 0; cell < max_cells; ++cell) {
    const auto start = std::bit_cast<double>((first_ + cell) << shift_);
    while (start > pieces_[piece].end) ++piece;
    piece_of_cell_[cell] = piece;
  }
}

}  // namespace coilwright::magnetics
