#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <span>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// A function given to Curve: fills values[i] = f(points[i]). Refers to the callable, does not own it; no allocation.
class BatchFunction {
 public:
  template <class Callable>
  requires(!std::same_as<std::remove_cvref_t<Callable>, BatchFunction> &&
           std::invocable<const Callable&, std::span<const double>, std::span<double>>)
      BatchFunction(const Callable& callable)  // NOLINT(google-explicit-constructor): a view of any callable
      : callable_(std::addressof(callable)),
        call_([](const void* self, std::span<const double> points, std::span<double> values) {
          (*static_cast<const Callable*>(self))(points, values);
        }) {}

  void operator()(std::span<const double> points, std::span<double> values) const { call_(callable_, points, values); }

 private:
  const void* callable_;
  void (*call_)(const void*, std::span<const double>, std::span<double>);
};

/// Smooth function of one variable over [lower, upper] as piecewise polynomials: nanoseconds to evaluate, value and
/// derivative, no heap. Built through Chebyshev points until the coefficients have fallen below the tolerance.
class Curve {
 public:
  /// What to interpolate over, and how well.
  struct Spec {
    double lower{};      ///< finite, < upper
    double upper{};      ///< finite
    double tolerance{};  ///< of the largest magnitude of the function over the range; 1e-13 <= tolerance < 1
  };
  struct Sample {
    double value;
    double derivative;
  };

  /// Throws std::invalid_argument for a bad spec or when the function is not finite somewhere, std::domain_error when
  /// the tolerance is not reached with the most points there is room for (the function is not smooth enough).
  Curve(BatchFunction function, const Spec& spec);

  /// Value and derivative at x. Outside [lower, upper] the curve goes on as the straight line that continues it with
  /// the same slope: finite and smooth enough for a solver that steps over the end, but not physics.
  [[nodiscard]] Sample sample(double x) const noexcept {
    const double inside = x < lower_ ? lower_ : (x > upper_ ? upper_ : x);
    const double position = (inside - lower_) * pieces_per_unit_;
    int piece = static_cast<int>(position);
    piece = piece < pieces_ ? piece : pieces_ - 1;
    const double t = 2.0 * (position - piece) - 1.0;
    const Piece& c = coefficients_[static_cast<std::size_t>(piece)];
    double value = c[degree];
    double slope = 0.0;
    for (int k = degree - 1; k >= 0; --k) {
      slope = slope * t + value;
      value = value * t + c[static_cast<std::size_t>(k)];
    }
    slope *= 2.0 * pieces_per_unit_;
    return {value + slope * (x - inside), slope};
  }
  [[nodiscard]] double value(double x) const noexcept { return sample(x).value; }
  [[nodiscard]] double derivative(double x) const noexcept { return sample(x).derivative; }

  [[nodiscard]] double lower() const noexcept { return lower_; }
  [[nodiscard]] double upper() const noexcept { return upper_; }
  /// Bound on |value(x) - f(x)| inside the range, in the function's unit, from the decay of the coefficients.
  [[nodiscard]] double error_bound() const noexcept { return error_bound_; }
  /// Largest magnitude met while building, in the function's unit.
  [[nodiscard]] double scale() const noexcept { return scale_; }
  /// Evaluations of the function that building took.
  [[nodiscard]] int evaluations() const noexcept { return evaluations_; }

 private:
  static constexpr int degree = 9;
  static constexpr int max_pieces = 32;
  using Piece = std::array<double, degree + 1>;

  void cut(std::span<const double> series, double tolerance);

  double lower_;
  double upper_;
  double pieces_per_unit_ = 0.0;
  int pieces_ = 0;
  int evaluations_ = 0;
  double error_bound_ = 0.0;
  double scale_ = 0.0;
  std::array<Piece, max_pieces> coefficients_;
};

/// hinge_torque_per_ampere over the joint angle, rad -> N m/A.
[[nodiscard]] Curve torque_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                                 Fidelity fidelity, const Curve::Spec& spec);

/// axial_force over the distance of the centres, m -> N per ampere (both senses positive: attraction is negative).
[[nodiscard]] Curve force_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const Curve::Spec& spec);
/// The same for two magnets, m -> N.
[[nodiscard]] Curve force_curve(const CylinderMagnet& first, const CylinderMagnet& second, const Curve::Spec& spec);
/// The same for two coils, m -> N per ampere squared.
[[nodiscard]] Curve force_curve(const ThickCoil& first, const ThickCoil& second, const Curve::Spec& spec);

}  // namespace coilwright::magnetics
