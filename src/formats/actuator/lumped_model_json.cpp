#include "coilwright/formats/actuator/lumped_model_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/as_built_format.hpp"
#include "formats/actuator/lumped_model_reader.hpp"
#include "formats/actuator/magnetic_parts_json.hpp"

namespace coilwright::formats {
namespace {

using text::Json;

Json in_unit(const std::vector<double>& values, std::string_view key) {
  Json out = Json::array();
  for (const double value : values) out.add(units::from_memory(value, key));
  return out;
}

Json joint_json(const actuator::Hinge& hinge, const mechanics::Link& link) {
  Json out = numbers_json(hinge, joint_numbers);
  if (link.rotor_inertia > 0.0) out.set("rotor_inertia_kgm2", link.rotor_inertia);
  if (hinge.contact.stiffness > 0.0) out.set("contact", numbers_json(hinge.contact, contact_numbers));
  return out;
}

Json source_json(const actuator::TorqueTable& table) {
  return Json::object(
      {{"angle_deg", in_unit(table.angles, "angle_deg")}, {"torque_Nmm_A", in_unit(table.torques, "torque_Nmm_A")}});
}

Json source_json(const actuator::PairDimensions& pair) {
  Json out = Json::object({{"winding", winding_word(pair.coil.winding)},
                           {"torque", pair.fidelity == magnetics::Fidelity::exact ? "exact" : "line_of_centres"},
                           {"coil", coil_json(pair.coil)},
                           {"magnet", magnet_json(pair.magnet)}});
  for (const GeometryKey& key : geometry_keys)
    out.set(std::string(key.ours), units::from_memory(pair.geometry.*key.member, key.ours));
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
  Json out = Json::array();
  for (const actuator::LumpedPair* pair : of_joint)
    out.add(pair == nullptr ? Json()
                            : std::visit([](const auto& source) { return source_json(source); }, pair->source));
  return out;
}

}  // namespace

Json to_json(const actuator::LumpedModel& model, const std::string& name, const std::string& description) {
  Json out = Json::object({{"format", "lumped-model/1"}, {"name", name}});
  if (!description.empty()) out.set("description", description);
  out.set(std::string(gravity_key), units::from_memory(model.gravity, gravity_key));
  Json links = Json::array();
  for (const mechanics::Link& link : model.links) links.add(numbers_json(link, link_numbers));
  Json joints = Json::array();
  for (std::size_t j = 0; j < model.hinges.size(); ++j) joints.add(joint_json(model.hinges[j], model.links.at(j)));
  out.set("links", std::move(links)).set("joints", std::move(joints));
  if (!model.pairs.empty()) out.set("magnetics", magnetics_json(model));
  if (!model.effects.empty()) out.set("effects", to_json(model.effects));
  set_as_built(out, model.as_built);
  return out;
}

}  // namespace coilwright::formats
