#include "coilwright/thermal/paths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check.hpp"

namespace coilwright::thermal {

RingConduction ring_conduction(const Ring& ring) {
  require_not_negative({"inner_radius"}, ring.inner_radius);
  require(std::isfinite(ring.outer_radius) && ring.outer_radius > ring.inner_radius, {"outer_radius"},
          "finite and above inner_radius", ring.outer_radius);
  require_positive({"length"}, ring.length);
  require_positive({"conductivity"}, ring.conductivity);
  const double hole = ring.inner_radius * ring.inner_radius;
  const double section = ring.outer_radius * ring.outer_radius - hole;  // over pi
  const double turn = ring.inner_radius > 0.0 ? std::log(ring.outer_radius / ring.inner_radius) : 0.0;
  // Rises above the outer surface per heat, over 1 / (4 pi k section length).
  const double mean = 0.5 * section - hole + 2.0 * hole * hole * turn / section;
  const double highest = section - 2.0 * hole * turn;
  const double unit = 1.0 / (4.0 * std::numbers::pi * ring.conductivity * section * ring.length);
  const double along = ring.conductivity * std::numbers::pi * section / ring.length;
  return {.to_side = 1.0 / (unit * mean),
          .to_end = 6.0 * along,
          .hot_spot_by_side = unit * (highest - mean),
          .hot_spot_by_ends = 1.0 / (24.0 * along)};
}

double across_wires(double copper_share, double filler) {
  require(copper_share >= 0.0 && copper_share < 1.0, {"copper_share"}, ">= 0 and below 1", copper_share);
  require_positive({"filler"}, filler);
  return filler * (1.0 + copper_share) / (1.0 - copper_share);
}

// Admittance at the root, over conductivity times section, as a function of u = (h P + c A s) / (k A), the square of
// the inverse decay length: g(u) = (f + b) / (1 + b p), f = m tanh(m L), p = tanh(m L) / m, m = sqrt(u), b = h / k.
SolidEndNode solid_end_node(const SolidEnd& bar) {
  require_positive({"length"}, bar.length);
  require_positive({"section"}, bar.section);
  require_positive({"perimeter"}, bar.perimeter);
  require_positive({"conductivity"}, bar.conductivity);
  require_positive({"heat_capacity"}, bar.heat_capacity);
  require_positive({"heat_transfer"}, bar.heat_transfer);
  const double u = bar.heat_transfer * bar.perimeter / (bar.conductivity * bar.section);
  const double m = std::sqrt(u);
  const double b = bar.heat_transfer / bar.conductivity;
  const double body = std::tanh(m * bar.length);
  const double rest = 1.0 - body * body;
  const double p = body / m;
  const double f_slope = 0.5 * (p + bar.length * rest);
  const double p_slope = (f_slope - p) / u;
  const double f_bend = 0.5 * (p_slope - bar.length * bar.length * p * rest);
  const double p_bend = (f_bend - 2.0 * p_slope) / u;
  const double below = 1.0 + b * p;
  const double g = (m * body + b) / below;
  const double g_slope = (f_slope - g * b * p_slope) / below;
  const double g_bend = (f_bend - 2.0 * g_slope * b * p_slope - g * b * p_bend) / below;
  // A node's admittance a - a^2 / (a + e + C s) has the same three numbers for the share a / (a + e) below.
  // Above 0 for every bar, and near it for one as short as warm throughout, where rounding could turn it.
  const double curvature = std::max(1e-6, -0.5 * g_bend * g / (g_slope * g_slope));
  const double share = 1.0 / (1.0 + curvature);
  const double to_root = bar.conductivity * bar.section * g / (1.0 - share);
  return {.to_root = to_root,
          .to_ambient = to_root * (1.0 - share) / share,
          .heat_capacity = bar.heat_capacity * bar.section * g_slope / (share * share)};
}

double open_face_share(double angle, double height_over_width) {
  require(angle >= 0.0 && angle <= std::numbers::pi, {"angle"}, "from 0 to pi rad", angle);
  require_positive({"height_over_width"}, height_over_width);
  const double mouth = std::sin(0.5 * angle);
  const double sides = 0.4 * height_over_width * std::sin(angle);
  return mouth + (1.0 - mouth) * sides / (1.0 + sides);
}

double still_air_film(const StillAir& place) {
  require_positive({"height"}, place.height);
  require(place.ambient > -273.15 && std::isfinite(place.ambient), {"ambient"}, "finite and above -273.15",
          place.ambient);
  require(place.surface_temperature >= place.ambient && std::isfinite(place.surface_temperature),
          {"surface_temperature"}, "finite and not below ambient", place.surface_temperature);
  constexpr double stefan_boltzmann = 5.670374e-8;  // W/(m2 K4)
  constexpr double emissivity = 0.9;                // of silicone rubber
  constexpr double gravity = 9.81;                  // m/s2
  constexpr double prandtl = 0.70;
  const double cold = place.ambient + 273.15;
  const double warm = place.surface_temperature + 273.15;
  const double mean = 0.5 * (cold + warm);
  const double viscosity = 15.89e-6 * std::pow(mean / 300.0, 1.77);    // kinematic, m2/s
  const double conductivity = 26.3e-3 * std::pow(mean / 300.0, 0.86);  // W/(m K)
  const double rayleigh =
      gravity * (warm - cold) / mean * std::pow(place.height, 3) * prandtl / (viscosity * viscosity);
  const double nusselt =
      0.68 + 0.670 * std::pow(rayleigh, 0.25) / std::pow(1.0 + std::pow(0.492 / prandtl, 9.0 / 16.0), 4.0 / 9.0);
  return nusselt * conductivity / place.height +
         emissivity * stefan_boltzmann * (warm * warm + cold * cold) * (warm + cold);
}

double equivalent_air_gap(const Wedge& wedge) {
  require_not_negative({"angle"}, wedge.angle);
  require_positive({"core_radius"}, wedge.core_radius);
  const bool outside = std::isfinite(wedge.hinge_distance) && wedge.hinge_distance > wedge.core_radius;
  require(outside, {"hinge_distance"}, "finite and above core_radius", wedge.hinge_distance);
  const double rho = wedge.core_radius / wedge.hinge_distance;
  // 2 (1 - sqrt(1 - rho^2)) / rho^2 without its cancellation at small rho.
  const double crowding = 2.0 / (1.0 + std::sqrt(1.0 - rho * rho));
  return wedge.angle * wedge.hinge_distance / crowding;
}

}  // namespace coilwright::thermal
