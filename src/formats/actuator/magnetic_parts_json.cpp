#include "formats/actuator/magnetic_parts_json.hpp"

#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {

using magnetics::CurrentDistribution;
using text::Json;

Json magnet_json(const magnetics::CylinderMagnet::Spec& magnet) {
  return numbers_json(magnet, magnet_keys);
}

Json coil_json(const magnetics::ThickCoil::Spec& coil) {
  Json out = numbers_json(coil, coil_keys);
  out.set("turns_radial", coil.turns_radial).set("turns_axial", coil.turns_axial);
  return out;
}

std::string_view winding_word(CurrentDistribution winding) {
  switch (winding) {
    case CurrentDistribution::paper_shells:
      return "paper_shells";
    case CurrentDistribution::layer_centres:
      return "layer_centres";
    case CurrentDistribution::uniform:
      return "uniform";
  }
  return "";
}

}  // namespace coilwright::formats
