#include "coilwright/formats/actuator/pair_json.hpp"

#include <array>
#include <utility>

#include "coilwright/units/unit.hpp"
#include "formats/actuator/magnetic_parts_json.hpp"

namespace coilwright::formats {
namespace {

using text::Json;

Json pose_json(const magnetics::Pose& pose) {
  std::array<double, 3> place{};
  std::array<double, 3> axis{};
  for (int i = 0; i < 3; ++i) {
    place[static_cast<std::size_t>(i)] = units::from_memory(pose.position[i], "position_mm");
    axis[static_cast<std::size_t>(i)] = pose.axis[i];
  }
  return Json::object({{"position_mm", Json::numbers(place)}, {"axis", Json::numbers(axis)}});
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
                           {"winding", winding_word(coil.winding())}});
  Json list = Json::array();
  for (const magnetics::Pose& pose : poses) list.add(pose_json(pose));
  out.set("poses", std::move(list));
  return out;
}

}  // namespace coilwright::formats
