#include "coilwright/magnetics/curve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/pair_curve.hpp"
#include "degree.hpp"
#include "magnetics/prototype.hpp"

namespace coilwright::magnetics {
namespace {

const HingeGeometry hinge{.coil_offset = 6.3e-3, .magnet_offset = 3.6e-3, .axis_offset = 11.5e-3};

// The bound is the curve's own; direct evaluation must stay inside it, and it inside the tolerance asked for.
TEST(Curve, KeepsItsErrorBoundAgainstDirectEvaluation) {
  for (const Fidelity fidelity : {Fidelity::line_of_centres, Fidelity::exact}) {
    const double tolerance = fidelity == Fidelity::exact ? 1e-7 : 1e-8;
    const Curve::Spec spec{
        .lower = (fidelity == Fidelity::exact ? -1.0 : -3.0) * degree, .upper = 120 * degree, .tolerance = tolerance};
    const Curve curve = torque_curve(prototype, prototype_magnet, hinge, fidelity, spec);
    EXPECT_LE(curve.error_bound(), tolerance * curve.scale());
    double worst = 0.0;
    for (double angle = spec.lower; angle < spec.upper; angle += 0.913 * degree)
      worst = std::max(worst, std::abs(curve.value(angle) -
                                       hinge_torque_per_ampere(prototype, prototype_magnet, hinge, fidelity, angle)));
    EXPECT_LE(worst, curve.error_bound());
  }
}

TEST(Curve, KeepsItsErrorBoundForForcesOverDistance) {
  const ThickCoil shells({.inner_radius = 4.1e-3,
                          .outer_radius = 7.3e-3,
                          .length = 8.7e-3,
                          .turns_radial = 9,
                          .turns_axial = 22,
                          .winding = CurrentDistribution::paper_shells});
  const Curve::Spec spec{.lower = 10.6e-3, .upper = 90e-3, .tolerance = 1e-9};
  const auto check = [&](const Curve& curve, auto force) {
    EXPECT_LE(curve.error_bound(), spec.tolerance * curve.scale());
    for (double z = spec.lower; z < spec.upper; z += 0.37e-3)
      ASSERT_NEAR(curve.value(z), force(z), curve.error_bound()) << z;
    EXPECT_NEAR(curve.value(spec.upper), force(spec.upper), curve.error_bound());
  };
  check(force_curve(prototype, prototype_magnet, spec),
        [](double z) { return axial_force(prototype, 1.0, prototype_magnet, z); });
  check(force_curve(prototype_magnet, prototype_magnet, spec),
        [](double z) { return axial_force(prototype_magnet, prototype_magnet, z); });
  check(force_curve(shells, shells, spec), [&](double z) { return axial_force(shells, 1.0, shells, 1.0, z); });
}

// The value alone takes a shorter way: it ends at the same bits, inside the range, at its ends and beyond.
TEST(Curve, HasTheSameValueWithAndWithoutItsDerivative) {
  const Curve curve = force_curve(prototype, prototype_magnet, {.lower = 10e-3, .upper = 90e-3, .tolerance = 1e-9});
  for (double z = 8e-3; z < 100e-3; z += 0.131e-3) ASSERT_EQ(curve.value(z), curve.sample(z).value) << z;
  for (const double z : {10e-3, 90e-3}) EXPECT_EQ(curve.value(z), curve.sample(z).value) << z;
}

// Central difference of the function itself: h^2 = 1e-8 of the third derivative and 1e-14 / h of rounding; the
// interpolant's derivative loses up to the square of its degree per piece, 81 * 2 / width.
TEST(Curve, HasTheDerivativeOfItsFunction) {
  const auto f = [](double x) { return std::exp(-x) * std::sin(3.0 * x) + 0.3; };
  const auto batch = [&](std::span<const double> x, std::span<double> y) {
    std::transform(x.begin(), x.end(), y.begin(), f);
  };
  const Curve curve(batch, {.lower = 0.2, .upper = 2.9, .tolerance = 1e-10, .boundary_layer_width = 0.4});
  for (double x = 0.21; x < 2.89; x += 0.0317)
    EXPECT_NEAR(curve.derivative(x), (f(x + 1e-4) - f(x - 1e-4)) / 2e-4, 3e-7) << x;
  EXPECT_EQ(curve.lower(), 0.2);
  EXPECT_EQ(curve.upper(), 2.9);
}

TEST(Curve, GoesOnAsAStraightLineOutsideItsRange) {
  const Curve curve = force_curve(prototype, prototype_magnet, {.lower = 11e-3, .upper = 40e-3, .tolerance = 1e-8});
  const Curve::Sample first = curve.sample(11e-3);
  EXPECT_DOUBLE_EQ(curve.value(10.2e-3), first.value - 0.8e-3 * first.derivative);
  EXPECT_DOUBLE_EQ(curve.derivative(10.2e-3), first.derivative);
  const Curve::Sample last = curve.sample(40e-3);
  EXPECT_DOUBLE_EQ(curve.value(41e-3), last.value + 1e-3 * last.derivative);
}

// A negative lower end, a range of one piece and a constant are ordinary inputs.
TEST(Curve, TakesAnyRange) {
  const auto line = [](std::span<const double> x, std::span<double> y) {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = 2.5 - 0.7 * x[i];
  };
  const Curve wide(line, {.lower = -300.0, .upper = 1e-3, .tolerance = 1e-9});
  EXPECT_NEAR(wide.value(-123.4), 2.5 + 0.7 * 123.4, 1e-9 * wide.scale());
  const auto constant = [](std::span<const double>, std::span<double> y) { std::fill(y.begin(), y.end(), 4.2); };
  EXPECT_NEAR(Curve(constant, {.lower = -2.0, .upper = -1.9, .tolerance = 1e-9}).value(-1.93), 4.2, 1e-8);
}

TEST(Curve, SaysWhatIsWrongWithItsInputs) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  using Error = std::invalid_argument;
  const auto making = [](Curve::Spec spec) { return [spec] { (void)force_curve(prototype, prototype_magnet, spec); }; };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(making({.lower = nan, .upper = 1.0, .tolerance = 1e-8}),
              ThrowsMessage<Error>("curve lower must be finite; got nan"));
  EXPECT_THAT(making({.lower = 0.02, .upper = 0.01, .tolerance = 1e-8}),
              ThrowsMessage<Error>("curve upper must be finite and > lower (0.02); got 0.01"));
  EXPECT_THAT(making({.lower = 0.01, .upper = 0.02, .tolerance = 0.0}),
              ThrowsMessage<Error>("curve tolerance must be >= 1e-13 and < 1; got 0"));
  EXPECT_THAT(making({.lower = 0.01, .upper = 0.02, .tolerance = 1e-8, .boundary_layer_width = -1.0}),
              ThrowsMessage<Error>("curve boundary_layer_width must be finite and >= 0; got -1"));
  const auto gap = [=](std::span<const double> x, std::span<double> y) {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] > 1.5 ? nan : 1.0;
  };
  EXPECT_THAT([&] { (void)Curve(gap, {.lower = 1.0, .upper = 2.0, .tolerance = 1e-8}); },
              ThrowsMessage<Error>(HasSubstr("curve function must be finite; got nan at 2")));
}

TEST(Curve, GivesUpOnAFunctionThatIsNotSmooth) {
  const auto step = [](std::span<const double> x, std::span<double> y) {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] > 1.4 ? 1.0 : 0.0;
  };
  EXPECT_THAT([&] { (void)Curve(step, {.lower = 1.0, .upper = 2.0, .tolerance = 1e-8}); },
              testing::ThrowsMessage<std::domain_error>(testing::HasSubstr("tolerance 1e-08 not reached with 10")));
}

TEST(Curve, PassesANotANumberOn) {
  const auto square = [](std::span<const double> x, std::span<double> y) {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] * x[i];
  };
  const Curve curve(square, {.lower = 0.7, .upper = 2.3, .tolerance = 1e-8});
  EXPECT_TRUE(std::isnan(curve.value(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace coilwright::magnetics
