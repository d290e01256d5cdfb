#include "formats/actuator/magnetic_parts.hpp"

#include <fmt/format.h>

namespace coilwright::formats {

using namespace text;
using magnetics::CurrentDistribution;
using magnetics::CylinderMagnet;
using magnetics::ThickCoil;

namespace {

// Bounds far beyond any hardware, and near enough that nothing computed from the numbers overflows or takes for ever.
constexpr Rule dimension = positive.and_also(Rule::at_most(1e6));  // mm
constexpr Rule remanence = positive.and_also(Rule::at_most(100));  // T
constexpr Rule turns = Rule::between(1, 10'000);                   // layers, or turns in a layer

}  // namespace

CylinderMagnet read_magnet(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    return CylinderMagnet({.radius = in.quantity("radius_mm", dimension),
                           .length = in.quantity("length_mm", dimension),
                           .remanence = in.quantity("remanence_T", remanence)});
  });
}

ThickCoil read_coil(const Node& node, CurrentDistribution winding) {
  return read_object(node, [winding](ObjectReader& in) {
    const double inner = in.number("inner_radius_mm", dimension);
    const Node outer = in.at("outer_radius_mm");
    if (outer.number(dimension) <= inner) throw outer.error(fmt::format("must exceed inner_radius_mm ({})", inner));
    return ThickCoil({.inner_radius = in.quantity("inner_radius_mm"),
                      .outer_radius = outer.quantity(),
                      .length = in.quantity("length_mm", dimension),
                      .turns_radial = in.integer("turns_radial", turns),
                      .turns_axial = in.integer("turns_axial", turns),
                      .winding = winding});
  });
}

CurrentDistribution read_winding(ObjectReader& in) {
  return in.choice_or("winding", CurrentDistribution::uniform,
                      {{"paper_shells", CurrentDistribution::paper_shells},
                       {"layer_centres", CurrentDistribution::layer_centres},
                       {"uniform", CurrentDistribution::uniform}});
}

}  // namespace coilwright::formats
