#include "coilwright/winding/winding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "coilwright/winding/copper.hpp"
#include "coilwright/winding/inductance.hpp"

namespace coilwright::winding {
namespace {

void require_turns(std::string_view field, int turns) {
  if (turns < 1) throw std::invalid_argument(fmt::format("{}: must be >= 1; got {}", field, turns));
}

void require_room(std::string_view field, double size) {
  if (!(size > 0.0)) throw std::invalid_argument(fmt::format("{}: must be > 0; got {}", field, size));
}

// Radial space of one layer on its own: a nested layer is thinner than its wire only where it meets another.
double outermost_layer(const Winding& winding) {
  return std::max(winding.radial_pitch(), winding.wire().insulated_diameter);
}

double mean_layer_radius(const Winding& winding) {
  return winding.inner_radius() + 0.5 * outermost_layer(winding) +
         0.5 * (winding.spec().turns_radial - 1) * winding.radial_pitch();
}

}  // namespace

Winding::Winding(const Spec& spec) : spec_{spec} {
  require_turns("turns_radial", spec.turns_radial);
  require_turns("turns_axial", spec.turns_axial);
  if (spec.turns_radial > std::numeric_limits<int>::max() / spec.turns_axial) {
    throw std::invalid_argument(fmt::format("turns_radial * turns_axial: must be at most {}; got {} * {}",
                                            std::numeric_limits<int>::max(), spec.turns_radial, spec.turns_axial));
  }
  require_room("wire.bare_diameter", spec.wire.bare_diameter);
  const double smallest = smallest_mandrel_radius * spec_.wire.insulated_diameter;
  if (!(std::isfinite(spec.inner_radius) && spec.inner_radius >= smallest)) {
    throw std::invalid_argument(
        fmt::format("inner_radius: must be finite and >= {:.6g} m ({} insulated diameters of {}); got {}", smallest,
                    smallest_mandrel_radius, spec.wire.name(), spec.inner_radius));
  }
}

int Winding::turns() const noexcept {
  return spec_.turns_radial * spec_.turns_axial;
}
double Winding::axial_pitch() const noexcept {
  return spec_.packing.axial() * spec_.wire.insulated_diameter;
}
double Winding::radial_pitch() const noexcept {
  return spec_.packing.radial() * spec_.wire.insulated_diameter;
}
double Winding::inner_radius() const noexcept {
  return spec_.inner_radius;
}

double Winding::outer_radius() const noexcept {
  return spec_.inner_radius + outermost_layer(*this) + (spec_.turns_radial - 1) * radial_pitch();
}

double Winding::length() const noexcept {
  const bool staggered = spec_.packing.nested() && spec_.turns_radial > 1;
  return (spec_.turns_axial + (staggered ? 0.5 : 0.0)) * axial_pitch();
}

double Winding::mean_radius() const noexcept {
  return 0.5 * (inner_radius() + outer_radius());
}

double Winding::wire_length() const noexcept {
  // Radii of layer centres are evenly spaced, so their mean stands for the sum.
  return 2.0 * std::numbers::pi * turns() * mean_layer_radius(*this);
}

double Winding::copper_mass() const noexcept {
  return copper_density * spec_.wire.copper_section() * wire_length();
}

double Winding::copper_fraction() const noexcept {
  return turns() * spec_.wire.copper_section() / ((outer_radius() - inner_radius()) * length());
}

double Winding::resistance(double temperature) const {
  return spec_.wire.resistance_per_length * wire_length() * copper_resistance_ratio(temperature);
}

double Winding::inductance() const {
  return winding::inductance(
      {.inner_radius = inner_radius(), .outer_radius = outer_radius(), .length = length(), .turns = turns()});
}

Fit fit(const Winding& winding, const Room& room) {
  require_room("room.outer_radius", room.outer_radius);
  require_room("room.length", room.length);
  return {.radial_excess = winding.outer_radius() - room.outer_radius, .axial_excess = winding.length() - room.length};
}

double layer_radius(const Winding& winding, int layer) {
  if (layer < 0 || layer >= winding.spec().turns_radial) {
    throw std::invalid_argument(
        fmt::format("layer: must be from 0 to {}; got {}", winding.spec().turns_radial - 1, layer));
  }
  return winding.inner_radius() + 0.5 * outermost_layer(winding) + layer * winding.radial_pitch();
}

}  // namespace coilwright::winding
