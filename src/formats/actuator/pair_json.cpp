#include "coilwright/formats/actuator/pair_json.hpp"

#include "formats/actuator/choice_words.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using text::Json;

Json pose_json(const magnetics::Pose& pose) {
  return Json::object(
      {Json::quantities("position_mm", {pose.position.data(), 3}), {"axis", Json::numbers({pose.axis.data(), 3})}});
}

}  // namespace

Json to_json(const magnetics::DrivenCoil& driven, const magnetics::CylinderMagnet& magnet,
             std::span<const magnetics::Pose> poses) {
  const magnetics::ThickCoil& coil = driven.coil;
  Json out = Json::object({{"coil", coil_json({.inner_radius = coil.inner_radius(),
                                               .outer_radius = coil.outer_radius(),
                                               .length = coil.length(),
                                               .turns_radial = coil.turns_radial(),
                                               .turns_axial = coil.turns_axial(),
                                               .winding = coil.winding()})},
                           {"magnet", magnet_json({.radius = magnet.radius(),
                                                   .length = magnet.length(),
                                                   .remanence = magnet.remanence(),
                                                   .recoil_permeability = magnet.recoil_permeability()})},
                           {"current_A", driven.current},
                           {"winding", word_for(winding_words, coil.winding())}});
  out.set("poses", Json::list(poses, pose_json));
  return out;
}

}  // namespace coilwright::formats
