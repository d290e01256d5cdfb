#include "formats/actuator/magnetic_parts.hpp"

#include <fmt/format.h>

#include "formats/actuator/choice_words.hpp"

namespace coilwright::formats {

using namespace text;
using magnetics::CylinderMagnet;
using magnetics::ThickCoil;

namespace {

constexpr Rule turns = Rule::between(1, 10'000);  // layers, or turns in a layer

}  // namespace

CylinderMagnet::Spec read_magnet(const Node& node, const Rule& remanence) {
  return read_object(node, [&remanence](ObjectReader& in) {
    const auto spec = read_numbers(in, magnet_keys);
    (void)in.quantity("remanence_T", remanence);
    (void)CylinderMagnet(spec);
    return spec;
  });
}

ThickCoil::Spec read_coil(const Node& node, CurrentDistribution winding) {
  return read_object(node, [winding](ObjectReader& in) {
    auto spec = read_numbers(in, coil_keys);
    if (spec.outer_radius <= spec.inner_radius)
      throw in.at("outer_radius_mm")
          .error(fmt::format("must exceed inner_radius_mm ({})", in.number("inner_radius_mm")));
    // A wall thinner than any wire, or than what a double can tell from none.
    if (is_thinner_than_any(spec.outer_radius - spec.inner_radius))
      throw in.at("outer_radius_mm")
          .error(fmt::format("must exceed inner_radius_mm ({}) by at least {}", in.number("inner_radius_mm"),
                             part_dimension.lower()));
    spec.turns_radial = in.integer("turns_radial", turns);
    spec.turns_axial = in.integer("turns_axial", turns);
    spec.winding = winding;
    (void)ThickCoil(spec);
    return spec;
  });
}

CurrentDistribution read_winding(ObjectReader& in, CurrentDistribution otherwise) {
  return choice_or(in, "winding", otherwise, winding_words);
}

Json magnet_json(const CylinderMagnet::Spec& magnet) {
  return numbers_json(magnet, magnet_keys);
}

Json coil_json(const ThickCoil::Spec& coil) {
  Json out = numbers_json(coil, coil_keys);
  out.set("turns_radial", coil.turns_radial).set("turns_axial", coil.turns_axial);
  return out;
}

}  // namespace coilwright::formats
