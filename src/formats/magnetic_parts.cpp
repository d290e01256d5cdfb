#include "magnetic_parts.hpp"

#include <fmt/format.h>

namespace coilwright::formats {

using magnetics::CylinderMagnet;
using magnetics::ThickCoil;
using magnetics::Winding;

CylinderMagnet read_magnet(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    return CylinderMagnet({.radius = in.quantity("radius_mm", positive),
                           .length = in.quantity("length_mm", positive),
                           .remanence = in.quantity("remanence_T", positive)});
  });
}

ThickCoil read_coil(const Node& node, Winding winding) {
  return read_object(node, [winding](ObjectReader& in) {
    const double inner = in.number("inner_radius_mm", positive);
    const Node outer = in.at("outer_radius_mm");
    if (outer.number(positive) <= inner) throw outer.error(fmt::format("must exceed inner_radius_mm ({})", inner));
    return ThickCoil({.inner_radius = in.quantity("inner_radius_mm"),
                      .outer_radius = outer.quantity(),
                      .length = in.quantity("length_mm", positive),
                      .turns_radial = in.integer("turns_radial", Rule::at_least(1)),
                      .turns_axial = in.integer("turns_axial", Rule::at_least(1)),
                      .winding = winding});
  });
}

Winding read_winding(ObjectReader& in) {
  return in.choice_or("winding", Winding::uniform,
                      {{"paper_shells", Winding::paper_shells},
                       {"layer_centres", Winding::layer_centres},
                       {"uniform", Winding::uniform}});
}

}  // namespace coilwright::formats
