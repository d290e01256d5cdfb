#include "coilwright/winding/packing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "coilwright/winding/wire.hpp"

namespace coilwright::winding {
namespace {

constexpr int prototype_gauge = 28;
constexpr double prototype_axial_pitch = 12e-3 / 30;    // l_c / N_z of the paper's Table II, m
constexpr double prototype_radial_pitch = 6.5e-3 / 15;  // (R_c - r_c) / N_r, m

// The wires nearest to each other in neighbouring layers are half an axial pitch and one layer apart; those two layers
// apart lie above each other. Neither may come closer than a diameter.
double tightest_layers(double axial) {
  return std::max(0.5, std::sqrt(std::max(0.0, 1.0 - 0.25 * axial * axial)));
}

}  // namespace

Packing::Packing(const Spec& spec) : spec_{spec} {
  if (!(std::isfinite(spec.axial) && spec.axial >= 1.0)) {
    throw std::invalid_argument(
        fmt::format("packing.axial: must be finite and >= 1 (turns of a layer do not overlap); got {}", spec.axial));
  }
  // Callers who write sqrt(3)/2 themselves may be a few roundings below the one computed here.
  const double tightest = tightest_layers(spec.axial);
  if (!(std::isfinite(spec.radial) && spec.radial >= tightest * (1.0 - 1e-12))) {
    throw std::invalid_argument(
        fmt::format("packing.radial: must be finite and >= {:.6g} (layers do not overlap at axial {:.6g}); got {}",
                    tightest, spec.axial, spec.radial));
  }
}

Packing::Packing() : Packing(prototype()) {}

Packing Packing::prototype() {
  static const double diameter = gauge(prototype_gauge).insulated_diameter;
  return Packing{{.axial = prototype_axial_pitch / diameter, .radial = prototype_radial_pitch / diameter}};
}

Packing Packing::orthocyclic() {
  return Packing{{.axial = 1.0, .radial = 0.5 * std::numbers::sqrt3}};
}

Packing Packing::square() {
  return Packing{{.axial = 1.0, .radial = 1.0}};
}

}  // namespace coilwright::winding
