#include "coilwright/formats/actuator/actuator_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/actuator/as_built_format.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace actuator;

// Without shares of coils that it does not have: another configuration of the same search had them.
Design of_its_coils(Design design) {
  for (auto i = static_cast<std::size_t>(coil_count(design.layout)); i < design.coil.current_shares.size(); ++i)
    design.coil.current_shares[i] = 1.0;
  return design;
}

Json section_json(const Design& design, std::string_view section) {
  Json out = Json::object();
  for (const Parameter& parameter : parameters()) {
    if (parameter.section != section) continue;
    if (parameter.needed != nullptr && !parameter.needed(design)) continue;
    const double value = units::from_memory(parameter.get(design), parameter.key);
    if (!parameter.names().empty()) {
      out.set(std::string(parameter.key), parameter.names()[static_cast<std::size_t>(value)]);
      continue;
    }
    out.set(std::string(parameter.key), parameter.whole ? Json(static_cast<int>(value)) : Json(value));
  }
  return out;
}

Json calibration_json(const Design& design) {
  Json out = section_json(design, "calibration");
  const std::optional<HingeReference>& hinge = design.calibration.hinge;
  if (!hinge) return out;
  out.set("hinge_reference", rows_json(*hinge, hinge_reference_rows));
  return out;
}

// A value that was read, with whole numbers as a person writes them.
Json with_whole_numbers(Json value) {
  if (const auto* number = std::get_if<double>(&value.content())) {
    constexpr double exact = 9007199254740992.0;  // 2^53: beyond, a double skips integers
    if (*number == std::floor(*number) && std::abs(*number) < exact) return static_cast<std::int64_t>(*number);
  } else if (auto* array = std::get_if<Json::Array>(&value.content())) {
    for (Json& each : *array) each = with_whole_numbers(std::move(each));
  } else if (auto* object = std::get_if<Json::Object>(&value.content())) {
    for (auto& [key, each] : *object) each = with_whole_numbers(std::move(each));
  }
  return value;
}

Json lumped_json(const UpdatedLumpedModel& lumped) {
  Json out = Json::object();
  for (const text::Node& member : lumped.document.root().members())
    if (member.key() != "effects" && member.key() != "as_built" && member.key() != torque_correction_key &&
        member.key() != text::schema_key)
      out.set(member.key(), with_whole_numbers(member.value()));
  if (!lumped.effects.empty()) out.set("effects", to_json(lumped.effects));
  set_as_built(out, lumped.as_built);
  return out;
}

Json joint_json(const actuator::Hinge& hinge, const mechanics::Link& link) {
  Json out = rows_json(hinge, joint_rows);
  if (link.rotor_inertia > 0.0) out.set("rotor_inertia_kgm2", link.rotor_inertia);
  if (hinge.contact.stiffness > 0.0) out.set("contact", rows_json(hinge.contact, contact_rows));
  return out;
}

Json source_json(const actuator::TorqueTable& table) {
  return Json::object({Json::quantities("angle_deg", table.angles), Json::quantities("torque_Nmm_A", table.torques)});
}

Json source_json(const actuator::PairDimensions& pair) {
  Json out = Json::object({{"winding", winding_words[static_cast<std::size_t>(pair.coil.winding)]},
                           {"torque", fidelity_words[static_cast<std::size_t>(pair.fidelity)]},
                           {"coil", coil_json(pair.coil)},
                           {"magnet", magnet_json(pair.magnet)}});
  for (const auto& length : geometry_rows)
    out.set(Json::quantity(std::string(length.key), pair.geometry.*length.member));
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

Json to_json(std::span<const Effect> effects) {
  return Json::list(effects, [](const Effect& effect) {
    return Json::object({{"id", effect.kind->id()}, {"parameters", parameters_json(effect)}});
  });
}

Json parameters_json(const Effect& effect) {
  Json out = Json::object();
  for (std::size_t i = 0; i < effect.values.size(); ++i)
    out.set(Json::quantity(std::string(effect.kind->parameters()[i].key), effect.values[i]));
  return out;
}

Json to_json(const Design& design, const std::string& name, const std::optional<OperatingPoint>& operating_point) {
  Json out = Json::object({{"format", "actuator/1"},
                           {"name", name},
                           {"layout", Json::list(design.layout,
                                                 [](const Component& each) {
                                                   return each.kind == ComponentKind::coil ? "coil" : "magnet";
                                                 })},
                           {"polarity", Json::list(design.layout, &Component::polarity)},
                           {"coil", section_json(of_its_coils(design), "coil")},
                           {"magnet", section_json(design, "magnet")},
                           {"body", section_json(design, "body")},
                           {"surroundings", section_json(design, "surroundings")},
                           {"model", rows_json(design.choices, model_rows)},
                           {"calibration", calibration_json(design)}});
  if (design.bottom_silicone) out.set("bottom_layer_silicone", section_json(design, "bottom_layer_silicone"));
  if (!design.effects.empty()) out.set("effects", to_json(design.effects));
  set_as_built(out, design.as_built);
  if (operating_point) out.set("operating_point", to_json(*operating_point));
  return out;
}

Json to_json(const UpdatedActuator& actuator, const std::string& name) {
  if (const auto* design = std::get_if<Design>(&actuator)) return to_json(*design, name);
  return lumped_json(std::get<UpdatedLumpedModel>(actuator));
}

Json to_json(const actuator::LumpedModel& model, const std::string& name, const std::string& description) {
  Json out = Json::object({{"format", "lumped-model/1"}, {"name", name}});
  if (!description.empty()) out.set("description", description);
  out.set(Json::quantity(std::string(gravity_key), model.gravity));
  Json joints = Json::array();
  for (std::size_t j = 0; j < model.hinges.size(); ++j) joints.add(joint_json(model.hinges[j], model.links.at(j)));
  out.set("links", Json::list(model.links, [](const mechanics::Link& link) { return rows_json(link, link_rows); }));
  out.set("joints", std::move(joints));
  if (!model.pairs.empty()) out.set("magnetics", magnetics_json(model));
  if (!model.effects.empty()) out.set("effects", to_json(model.effects));
  set_as_built(out, model.as_built);
  return out;
}

}  // namespace coilwright::formats
