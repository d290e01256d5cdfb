#include "actuator/parts/axial_curves.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cstddef>
#include <span>
#include <utility>

namespace coilwright::actuator {
namespace {

// W(z) = integral of the force from z to infinity; beyond the curve the force is that of two dipoles, which leaves z F
// / 3.
magnetics::Curve energy_of(const magnetics::Curve& force, double tolerance) {
  constexpr unsigned most_halvings = 6;
  constexpr double quadrature_tolerance = 1e-7;
  const double far = force.upper();
  const double tail = far * force.value(far) / 3.0;
  const auto energy = [&](std::span<const double> distances, std::span<double> energies) {
    // Over u = 1/z the integrand F z^2 is flat at the far end; where parts touch it is steep, hence the halving.
    const auto integrand = [&](double u) { return force.value(1.0 / u) / (u * u); };
    for (std::size_t i = 0; i < distances.size(); ++i)
      energies[i] = tail + boost::math::quadrature::gauss_kronrod<double, 21>::integrate(
                               integrand, 1.0 / far, 1.0 / distances[i], most_halvings, quadrature_tolerance);
  };
  return magnetics::Curve(energy, {.lower = force.lower(),
                                   .upper = far,
                                   .tolerance = tolerance,
                                   .boundary_layer_width = force.boundary_layer_width()});
}

}  // namespace

AxialCurves axial_curves(magnetics::Curve force, double tolerance) {
  AxialCurves curves;
  curves.energy = std::make_shared<const magnetics::Curve>(energy_of(force, tolerance));
  curves.force = std::make_shared<const magnetics::Curve>(std::move(force));
  return curves;
}

}  // namespace coilwright::actuator
