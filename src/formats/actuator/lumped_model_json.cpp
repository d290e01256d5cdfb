#include "coilwright/formats/actuator/lumped_model_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "formats/actuator/as_built_format.hpp"
#include "formats/actuator/choice_words.hpp"
#include "formats/actuator/lumped_model_reader.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using text::Json;

Json joint_json(const actuator::Hinge& hinge, const mechanics::Link& link) {
  Json out = numbers_json(hinge, joint_numbers);
  if (link.rotor_inertia > 0.0) out.set("rotor_inertia_kgm2", link.rotor_inertia);
  if (hinge.contact.stiffness > 0.0) out.set("contact", numbers_json(hinge.contact, contact_numbers));
  return out;
}

Json source_json(const actuator::TorqueTable& table) {
  return Json::object({Json::quantities("angle_deg", table.angles), Json::quantities("torque_Nmm_A", table.torques)});
}

Json source_json(const actuator::PairDimensions& pair) {
  Json out = Json::object({{"winding", word_for(winding_words, pair.coil.winding)},
                           {"torque", word_for(fidelity_words, pair.fidelity)},
                           {"coil", coil_json(pair.coil)},
                           {"magnet", magnet_json(pair.magnet)}});
  for (const GeometryKey& key : geometry_keys)
    out.set(Json::quantity(std::string(key.ours), pair.geometry.*key.member));
  return out;
}

Json magnetics_json(const actuator::LumpedModel& model) {
  std::vector<const actuator::LumpedPair*> of_joint(model.links.size(), nullptr);
  for (const actuator::LumpedPair& pair : model.pairs) {
    if (pair.joint < 0 || static_cast<std::size_t>(pair.joint) >= of_joint.size())
      throw std::invalid_argument(
          fmt::format("pair: joint must be from 0 to {}; got {}", of_joint.size() - 1, pair.joint));
    const actuator::LumpedPair*& place = of_joint[static_cast<std::size_t>(pair.joint)];
    if (place != nullptr) throw std::invalid_argument(fmt::format("pair: joint {} has one already", pair.joint));
    place = &pair;
  }
  return Json::list(of_joint, [](const actuator::LumpedPair* pair) {
    return pair == nullptr ? Json() : std::visit([](const auto& source) { return source_json(source); }, pair->source);
  });
}

}  // namespace

Json to_json(const actuator::LumpedModel& model, const std::string& name, const std::string& description) {
  Json out = Json::object({{"format", "lumped-model/1"}, {"name", name}});
  if (!description.empty()) out.set("description", description);
  out.set(Json::quantity(std::string(gravity_key), model.gravity));
  Json joints = Json::array();
  for (std::size_t j = 0; j < model.hinges.size(); ++j) joints.add(joint_json(model.hinges[j], model.links.at(j)));
  out.set("links",
          Json::list(model.links, [](const mechanics::Link& link) { return numbers_json(link, link_numbers); }));
  out.set("joints", std::move(joints));
  if (!model.pairs.empty()) out.set("magnetics", magnetics_json(model));
  if (!model.effects.empty()) out.set("effects", to_json(model.effects));
  set_as_built(out, model.as_built);
  return out;
}

}  // namespace coilwright::formats
