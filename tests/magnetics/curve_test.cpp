#include "coilwright/magnetics/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace coilwright::magnetics {
namespace {

const ThickCoil coil(
    {.inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 12e-3, .turns_radial = 15, .turns_axial = 30});
const CylinderMagnet magnet({.radius = 10e-3, .length = 6e-3, .remanence = 1.44});
const HingeGeometry hinge{.coil_offset = 6.3e-3, .magnet_offset = 3.6e-3, .axis_offset = 11.5e-3};
constexpr double degree = std::numbers::pi / 180.0;

// The bound is the curve's own; direct evaluation must stay inside it, and it inside the tolerance asked for.
TEST(Curve, KeepsItsErrorBoundAgainstDirectEvaluation) {
  for (const Fidelity fidelity : {Fidelity::line_of_centres, Fidelity::exact}) {
    const double tolerance = fidelity == Fidelity::exact ? 1e-7 : 1e-8;
    const Curve::Spec spec{
        .lower = (fidelity == Fidelity::exact ? -1.0 : -3.0) * degree, .upper = 120 * degree, .tolerance = tolerance};
    const Curve curve = torque_curve(coil, magnet, hinge, fidelity, spec);
    if (std::getenv("SHOW"))
      printf("%d evaluations, bound %.2e\n", curve.evaluations(), curve.error_bound() / curve.scale());
    EXPECT_LE(curve.error_bound(), tolerance * curve.scale());
    double worst = 0.0;
    for (double angle = spec.lower; angle < spec.upper; angle += 0.913 * degree)
      worst =
          std::max(worst, std::abs(curve.value(angle) - hinge_torque_per_ampere(coil, magnet, hinge, fidelity, angle)));
    if (std::getenv("SHOW")) printf("true %.2e\n", worst / curve.scale());
    EXPECT_LE(worst, curve.error_bound());
  }
}

}  // namespace
}  // namespace coilwright::magnetics
