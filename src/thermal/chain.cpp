#include "coilwright/thermal/chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check.hpp"

namespace coilwright::thermal {
namespace {

// Shape factor's constant for a cylinder centred in a square bar; with it, the bar's side is at least this many
// diameters, or the core would stand out of the body.
constexpr double square_bar = 1.08;

double side_of(const HeatChain& chain) {
  return std::sqrt(chain.width * chain.height);
}
double perimeter_of(const HeatChain& chain) {
  return 2.0 * (chain.width + chain.height);
}
double section_of(const HeatChain& chain) {
  return chain.width * chain.height;
}

void check_segment(const HeatChain& chain, std::size_t index) {
  const HeatSegment& segment = chain.segments[index];
  const auto field = [index](std::string_view member) { return Field{"segments", index, member}; };
  require_positive(field("length"), segment.length);
  const double widest = 0.5 * std::min(chain.width, chain.height);
  if (!(segment.core_radius > 0.0 && segment.core_radius < widest)) {
    reject(field("core_radius"), fmt::format("> 0 and below {:.6g} m, half the body's smaller side", widest),
           segment.core_radius);
  }
  require_not_negative(field("solid_end"), segment.solid_end);
}

void check_gap(const Gap& gap, std::size_t index) {
  const auto field = [index](std::string_view member) { return Field{"gaps", index, member}; };
  require_not_negative(field("silicone"), gap.silicone);
  require_not_negative(field("air"), gap.air);
  require(gap.silicone + gap.air > 0.0, field("silicone"), "> 0 where there is no air", gap.silicone);
}

void check(const HeatChain& chain) {
  require_positive({"width"}, chain.width);
  require_positive({"height"}, chain.height);
  require_positive({"heat_transfer"}, chain.heat_transfer);
  require_positive({"silicone_conductivity"}, chain.silicone_conductivity);
  require_positive({"air_conductivity"}, chain.air_conductivity);
  const std::size_t segments = chain.segments.size();
  require_count({"segments"}, segments, 1, most_nodes);
  require_count({"gaps"}, chain.gaps.size(), segments - 1, segments - 1);
  for (std::size_t i = 0; i < segments; ++i) check_segment(chain, i);
  for (std::size_t i = 0; i < chain.gaps.size(); ++i) check_gap(chain.gaps[i], i);
}

double through_sides(const HeatChain& chain, const HeatSegment& segment) {
  const double shape =
      2.0 * std::numbers::pi * segment.length / std::log(square_bar * side_of(chain) / (2.0 * segment.core_radius));
  const double inside = chain.silicone_conductivity * shape;
  const double outside = chain.heat_transfer * perimeter_of(chain) * segment.length;
  return inside * outside / (inside + outside);
}

double through_fin(const HeatChain& chain, const HeatSegment& segment) {
  if (segment.solid_end == 0.0) return 0.0;
  const double section = section_of(chain);
  const double decay =
      std::sqrt(chain.heat_transfer * perimeter_of(chain) / (chain.silicone_conductivity * section));  // 1/m
  const double tip = chain.heat_transfer / (decay * chain.silicone_conductivity);  // end face, dimensionless
  const double body = std::tanh(decay * segment.solid_end);
  return chain.silicone_conductivity * section * decay * (body + tip) / (1.0 + tip * body);
}

double through_gap(const HeatChain& chain, std::size_t index) {
  const Gap& gap = chain.gaps[index];
  const double radius = std::min(chain.segments[index].core_radius, chain.segments[index + 1].core_radius);
  const double resistance = gap.silicone / chain.silicone_conductivity + gap.air / chain.air_conductivity;  // m2 K/W
  return std::numbers::pi * radius * radius / resistance;
}

}  // namespace

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

Network build_network(const HeatChain& chain) {
  check(chain);
  Network::Spec spec{
      .nodes = {}, .links = {}, .ambient = chain.ambient, .temperature_coefficient = chain.temperature_coefficient};
  spec.nodes.reserve(chain.segments.size());
  spec.links.reserve(chain.gaps.size());
  for (const HeatSegment& segment : chain.segments) {
    spec.nodes.push_back({.kind = segment.kind,
                          .ambient_conductance = through_sides(chain, segment) + through_fin(chain, segment),
                          .heat_capacity = segment.heat_capacity,
                          .resistance = segment.resistance,
                          .temperature_limit = segment.temperature_limit});
  }
  for (std::size_t i = 0; i < chain.gaps.size(); ++i) spec.links.push_back(through_gap(chain, i));
  return Network(std::move(spec));
}

}  // namespace coilwright::thermal
