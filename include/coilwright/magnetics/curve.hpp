#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace coilwright::magnetics {

/// A function for Curve that fills values[i] = f(points[i]). It refers to the callable without owning it and allocates
/// nothing.
class BatchFunction {
 public:
  /// Refers to `callable`, which must outlive this object and be callable with (points, values).
  template <class Callable>
  requires(!std::same_as<std::remove_cvref_t<Callable>, BatchFunction> &&
           std::invocable<const Callable&, std::span<const double>, std::span<double>>)
      BatchFunction(const Callable& callable)  // NOLINT(google-explicit-constructor): a view of any callable
      : callable_(std::addressof(callable)),
        call_([](const void* self, std::span<const double> points, std::span<double> values) {
          (*static_cast<const Callable*>(self))(points, values);
        }) {}

  /// Calls the function for all points.
  void operator()(std::span<const double> points, std::span<double> values) const { call_(callable_, points, values); }

 private:
  const void* callable_;
  void (*call_)(const void*, std::span<const double>, std::span<double>);
};

/// Function of one variable over [lower, upper] as piecewise polynomials. Value and derivative take nanoseconds and no
/// allocation. It is built through Chebyshev points in the logarithm of the distance from a point below `lower`. The
/// range is halved where the coefficients fall too slowly, so a steep or weakly singular end costs points only there.
/// Pieces are as long as the tolerance allows.
class Curve {
 public:
  /// Range and accuracy of an interpolation.
  struct Spec {
    double lower{};                 ///< finite, < upper
    double upper{};                 ///< finite
    double tolerance{};             ///< of the largest magnitude of the function over the range; >= 1e-13, < 1
    double boundary_layer_width{};  ///< > 0: how far below `lower` the function's variation is concentrated, in the
                                    ///< unit of x; 0 stands for upper - lower: no particular concentration
  };
  /// The largest number of evaluations of the function before a curve gives up.
  static constexpr int max_evaluations = 1000;
  /// Value and slope at one place.
  struct Sample {
    double value;       ///< in the function's unit
    double derivative;  ///< per unit of x
  };

  /// Builds the curve. Throws std::invalid_argument for a bad spec or if the function is not finite somewhere, and
  /// std::domain_error if `max_evaluations` points do not reach the tolerance (the function jumps, or is noisier than
  /// the tolerance).
  Curve(BatchFunction function, const Spec& spec);

  /// Value and derivative at x. Outside [lower, upper] the curve continues as a straight line with the same slope:
  /// finite and smooth enough for a solver that steps over the end, but not physics. The derivative is that of the
  /// interpolant, so its error is larger than the value's by the usual order. NaN for NaN.
  [[nodiscard]] Sample sample(double x) const noexcept {
    // Written so that a NaN picks a piece too (and comes out as NaN): the number of the piece is an index.
    const double inside = x > lower_ ? (x < upper_ ? x : upper_) : lower_;
    const Piece& piece = piece_at(inside);
    const double t = (inside - origin_ - piece.centre) * piece.scale;
    const double w = t * t;
    const auto& c = piece.powers;
    // Even and odd powers apart, each with its derivative by w: four short chains instead of one long one.
    double even = c[degree - 1];
    double even_slope = 0.0;
    double odd = c[degree];
    double odd_slope = 0.0;
    for (int k = degree - 3; k >= 0; k -= 2) {
      const auto i = static_cast<std::size_t>(k);
      even_slope = even_slope * w + even;
      even = even * w + c[i];
      odd_slope = odd_slope * w + odd;
      odd = odd * w + c[i + 1];
    }
    const double slope = (odd + 2.0 * (t * even_slope + w * odd_slope)) * piece.scale;
    return {even + t * odd + slope * (x - inside), slope};
  }
  /// Value at x, in half the time of sample() inside the range.
  [[nodiscard]] double value(double x) const noexcept {
    if (!(x >= lower_ && x <= upper_)) return sample(x).value;
    const Piece& piece = piece_at(x);
    const double t = (x - origin_ - piece.centre) * piece.scale;
    const double w = t * t;
    const auto& c = piece.powers;
    double even = c[degree - 1];
    double odd = c[degree];
    for (int k = degree - 3; k >= 0; k -= 2) {
      const auto i = static_cast<std::size_t>(k);
      even = even * w + c[i];
      odd = odd * w + c[i + 1];
    }
    return even + t * odd;
  }
  [[nodiscard]] double derivative(double x) const noexcept { return sample(x).derivative; }  ///< see sample

  [[nodiscard]] double lower() const noexcept { return lower_; }
  [[nodiscard]] double upper() const noexcept { return upper_; }
  /// Distance below `lower` within which the variation is concentrated, as given or chosen, in the unit of x.
  [[nodiscard]] double boundary_layer_width() const noexcept { return lower_ - origin_; }
  /// Bound on |value(x) - f(x)| inside the range, in the function's unit, from the decay of the coefficients.
  [[nodiscard]] double error_bound() const noexcept { return error_bound_; }
  /// Largest magnitude seen while building, in the function's unit.
  [[nodiscard]] double scale() const noexcept { return scale_; }
  /// Number of evaluations of the function that building took.
  [[nodiscard]] int evaluations() const noexcept { return evaluations_; }

 private:
  static constexpr int degree = 9;  // odd: as many even powers as odd ones
  static constexpr std::size_t max_cells = 64;
  struct Panel;  // part of the range with its Chebyshev series
  struct Piece {
    double end;     // distance at which it ends; of the last one infinity
    double centre;  // of the distance
    double scale;   // 1 / half width
    std::array<double, degree + 1> powers;
  };

  // Where `inside` the range lies. Exponent and first bits of the distance number a cell, which knows the first piece
  // that reaches into it; mostly that is the one.
  [[nodiscard]] const Piece& piece_at(double inside) const noexcept {
    const double distance = inside - origin_;
    const auto cell = static_cast<std::size_t>((std::bit_cast<std::uint64_t>(distance) >> shift_) - first_);
    const Piece* piece = pieces_.data() + piece_of_cell_[cell];
    while (distance > piece->end) ++piece;
    return *piece;
  }

  void resolve(const BatchFunction& function, double tolerance, std::vector<Panel>& panels);
  [[nodiscard]] double refine(const BatchFunction& function, double tolerance, Panel& panel);
  [[nodiscard]] double miss_near_lower_end(const BatchFunction& function, const Panel& panel);
  void cut(const std::vector<Panel>& panels, double tolerance);
  void number_cells();

  double lower_;
  double upper_;
  double origin_;
  int shift_ = 0;
  std::uint64_t first_ = 0;
  int evaluations_ = 0;
  double error_bound_ = 0.0;
  double scale_ = 0.0;
  std::vector<Piece> pieces_;
  std::array<std::uint16_t, max_cells> piece_of_cell_{};
};

}  // namespace coilwright::magnetics
