#include "formats/actuator/magnetic_parts.hpp"

#include <fmt/format.h>

#include "formats/actuator/choice_words.hpp"

namespace coilwright::formats {

using namespace text;
using magnetics::CurrentDistribution;
using magnetics::CylinderMagnet;
using magnetics::ThickCoil;

CylinderMagnet::Spec read_magnet(const Node& node, const Rule& remanence) {
  return read_object(node, [&remanence](ObjectReader& in) {
    const auto spec = read_rows(in, magnet_rows, CylinderMagnet::Spec{});
    (void)in.quantity("remanence_T", remanence);
    (void)CylinderMagnet(spec);
    return spec;
  });
}

ThickCoil::Spec read_coil(const Node& node, CurrentDistribution winding) {
  return read_object(node, [winding](ObjectReader& in) {
    auto spec = read_rows(in, coil_rows, ThickCoil::Spec{});
    if (spec.outer_radius <= spec.inner_radius)
      throw in.at("outer_radius_mm")
          .error(fmt::format("must exceed inner_radius_mm ({})", in.number("inner_radius_mm")));
    // A wall thinner than any wire, or than what a double can tell from none.
    if (is_thinner_than_any(spec.outer_radius - spec.inner_radius))
      throw in.at("outer_radius_mm")
          .error(fmt::format("must exceed inner_radius_mm ({}) by at least {}", in.number("inner_radius_mm"),
                             part_dimension.lower()));
    spec.winding = winding;
    (void)ThickCoil(spec);
    return spec;
  });
}

CurrentDistribution read_winding(ObjectReader& in, CurrentDistribution otherwise) {
  const auto said = value_of(in, winding_row);
  return said ? static_cast<CurrentDistribution>(*said) : otherwise;
}

Json magnet_json(const CylinderMagnet::Spec& magnet) {
  return rows_json(magnet, magnet_rows);
}

Json coil_json(const ThickCoil::Spec& coil) {
  return rows_json(coil, coil_rows);
}

}  // namespace coilwright::formats
