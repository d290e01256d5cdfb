#include "coilwright/report/actuator_json.hpp"

#include <string_view>

#include "coilwright/actuator/parameters.hpp"
#include "coilwright/formats/units.hpp"

namespace coilwright::report {
namespace {

using namespace actuator;

Json section_json(const Design& design, std::string_view section) {
  Json out = Json::object();
  for (const Parameter& parameter : parameters()) {
    if (parameter.section != section) continue;
    const formats::Unit unit{.suffix = parameter.key, .dimension = "", .denominator = parameter.denominator};
    const double value = formats::from_si(parameter.get(design), unit);
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

std::string_view word(magnetics::Winding winding) {
  switch (winding) {
    case magnetics::Winding::paper_shells:
      return "paper_shells";
    case magnetics::Winding::layer_centres:
      return "layer_centres";
    case magnetics::Winding::uniform:
      return "uniform";
  }
  return "";
}

Json choices_json(const ModelChoices& choices) {
  return Json::object(
      {{"winding", word(choices.winding)},
       {"torque", choices.torque == magnetics::Fidelity::exact ? "exact" : "line_of_centres"},
       {"face_contact", choices.faces == FaceContact::walls ? "walls" : "hard_parts"},
       {"segment_mass", choices.masses == SegmentMass::rigid_bodies ? "rigid_bodies" : "on_axis_points"}});
}

}  // namespace

Json to_json(const Design& design, const std::string& name) {
  return Json::object({{"format", "actuator/1"},
                       {"name", name},
                       {"layout", layout_json(design.layout)},
                       {"polarity", polarity_json(design.layout)},
                       {"coil", section_json(design, "coil")},
                       {"magnet", section_json(design, "magnet")},
                       {"body", section_json(design, "body")},
                       {"surroundings", section_json(design, "surroundings")},
                       {"model", choices_json(design.choices)},
                       {"calibration", section_json(design, "calibration")}});
}

}  // namespace coilwright::report
