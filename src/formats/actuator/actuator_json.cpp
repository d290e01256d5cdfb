#include "coilwright/formats/actuator/actuator_json.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/formats/actuator/operating_point_json.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/as_built_format.hpp"
#include "formats/actuator/magnetic_parts_json.hpp"
#include "formats/actuator/torque_correction_format.hpp"

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

Json layout_json(const Layout& layout) {
  Json out = Json::array();
  for (const Component& component : layout) out.add(component.kind == ComponentKind::coil ? "coil" : "magnet");
  return out;
}

Json polarity_json(const Layout& layout) {
  Json out = Json::array();
  for (const Component& component : layout) out.add(component.polarity);
  return out;
}

std::string_view word(HingeLaw hinge) {
  switch (hinge) {
    case HingeLaw::slit:
      return "slit";
    case HingeLaw::slot:
      return "slot";
    case HingeLaw::beam:
      return "beam";
  }
  return "";
}

Json choices_json(const ModelChoices& choices) {
  return Json::object(
      {{"winding", winding_word(choices.winding)},
       {"torque", choices.torque == magnetics::Fidelity::exact ? "exact" : "line_of_centres"},
       {"face_contact", choices.faces == ContactChoice::walls ? "walls" : "hard_parts"},
       {"segment_mass", choices.masses == SegmentMass::rigid_bodies ? "rigid_bodies" : "on_axis_points"},
       {"hinge", word(choices.hinge)},
       {"damping", choices.damping == DampingLaw::loss_factor ? "loss_factor" : "proportional"},
       {"ampacity", choices.ampacity == AmpacityChoice::law ? "law" : "table"},
       {"film", choices.film == FilmChoice::calibrated ? "calibrated" : "still_air"}});
}

Json calibration_json(const Design& design) {
  Json out = section_json(design, "calibration");
  const std::optional<HingeReference>& hinge = design.calibration.hinge;
  if (!hinge) return out;
  Json reference = Json::object();
  const auto set = [&](const char* key, double value) { reference.set(key, units::from_memory(value, key)); };
  set("width_mm", hinge->width);
  set("bottom_layer_mm", hinge->bottom_layer);
  set("joint_stiffness_Nmm_rad", hinge->stiffness);
  set("joint_damping_Nmms_rad", hinge->damping);
  set("first_mode_Hz", hinge->first_mode);
  out.set("hinge_reference", std::move(reference));
  return out;
}

// Whole numbers as a person writes them.
Json number_json(double value) {
  constexpr double exact = 9007199254740992.0;  // 2^53: beyond, a double skips integers
  const bool whole = value == std::floor(value) && std::abs(value) < exact;
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json copy_of(const text::Node& node) {
  using Kind = text::Node::Kind;
  switch (node.kind()) {
    case Kind::null:
      return {};
    case Kind::boolean:
      return node.boolean();
    case Kind::number:
      return number_json(node.number());
    case Kind::text:
      return node.text();
    case Kind::array: {
      Json out = Json::array();
      for (const text::Node& element : node.elements()) out.add(copy_of(element));
      return out;
    }
    case Kind::object:
      break;
  }
  Json out = Json::object();
  for (const text::Node& member : node.members()) out.set(member.key(), copy_of(member));
  return out;
}

Json lumped_json(const UpdatedLumpedModel& lumped) {
  Json out = Json::object();
  for (const text::Node& member : lumped.document.root().members())
    if (member.key() != "effects" && member.key() != "as_built" && member.key() != torque_correction_key &&
        member.key() != text::schema_key)
      out.set(member.key(), copy_of(member));
  if (!lumped.effects.empty()) out.set("effects", to_json(lumped.effects));
  set_as_built(out, lumped.as_built);
  return out;
}

}  // namespace

Json to_json(std::span<const Effect> effects) {
  Json out = Json::array();
  for (const Effect& effect : effects) {
    Json values = Json::object();
    for (std::size_t i = 0; i < effect.values.size(); ++i) {
      const EffectParameter& parameter = effect.kind->parameters()[i];
      values.set(std::string(parameter.key), units::from_memory(effect.values[i], parameter.key));
    }
    out.add(Json::object({{"id", effect.kind->id()}, {"parameters", std::move(values)}}));
  }
  return out;
}

Json to_json(const Design& design, const std::string& name, const std::optional<OperatingPoint>& operating_point) {
  Json out = Json::object({{"format", "actuator/1"},
                           {"name", name},
                           {"layout", layout_json(design.layout)},
                           {"polarity", polarity_json(design.layout)},
                           {"coil", section_json(of_its_coils(design), "coil")},
                           {"magnet", section_json(design, "magnet")},
                           {"body", section_json(design, "body")},
                           {"surroundings", section_json(design, "surroundings")},
                           {"model", choices_json(design.choices)},
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

}  // namespace coilwright::formats
