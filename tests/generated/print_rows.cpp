// Prints the schemas of all numbers that have rows, by what they are of, for scripts/generate.py.
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/parameter_rule.hpp"
#include "coilwright/formats/systems/task_rows.hpp"
#include "coilwright/text/json/rows.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/actuator_reader.hpp"

namespace {

using namespace coilwright;
using text::Json;
using text::schema_of;

Json schema_of_effect_number(const actuator::EffectParameter& number) {
  Json out = schema_of({.key = number.key, .rule = formats::rule_of(number), .meaning = number.text}, std::nullopt);
  if (number.choices.empty()) return out;
  std::vector<double> choices;
  for (const double choice : number.choices) choices.push_back(units::from_memory(choice, number.key));
  return Json::object({{"description", std::string(number.text) + "."}, {"enum", Json::numbers(choices)}});
}

// Each with all that it may have; "required" are those without which it is none.
Json effects() {
  Json out = Json::array();
  for (const actuator::EffectKind* kind : actuator::standard_effects().kinds()) {
    const actuator::EffectKind* further = kind->with_further_numbers();
    Json properties = Json::object();
    for (const auto& each : (further == nullptr ? kind : further)->parameters())
      properties.set(std::string(each.key), schema_of_effect_number(each));
    out.add(Json::object({{"id", kind->id()},
                          {"description", kind->description()},
                          {"properties", std::move(properties)},
                          {"required", Json::list(kind->parameters(), &actuator::EffectParameter::key)}}));
  }
  return out;
}

// By section; the descriptions are the schema's own.
Json parameters() {
  Json out = Json::array();
  const actuator::Design usual;
  for (const actuator::Parameter& each : actuator::parameters())
    out.add(Json::object({{"section", each.section},
                          {"key", each.key},
                          {"rule", schema_of({.key = each.key,
                                              .rule = each.names().empty() ? formats::rule_of(each) : text::finite,
                                              .whole = each.whole,
                                              .words = each.names()},
                                             each.get(usual))}}));
  return out;
}

}  // namespace

int main() {
  using namespace formats;
  const std::vector<text::Row<systems::gripper::GripperTask>> grip =
      grip_rows({.object = {.shape = systems::gripper::ObjectShape::box}});
  std::cout << Json::object({{"grip", schema_of(std::span(grip))},
                             {"crawl", schema_of(crawl_rows())},
                             {"drive", schema_of(drive_rows())},
                             {"driver", schema_of(driver_rows())},
                             {"model", schema_of(std::span(model_rows))},
                             {"operating_point", schema_of(std::span(operating_rows))},
                             {"measured", schema_of(std::span(measured_rows))},
                             {"hinge_reference", schema_of(std::span(hinge_reference_rows))},
                             {"link", schema_of(std::span(link_rows))},
                             {"joint", schema_of(std::span(joint_rows))},
                             {"rotor", schema_of(std::span(rotor_rows))},
                             {"contact", schema_of(std::span(contact_rows))},
                             {"coil", schema_of(std::span(coil_rows))},
                             {"magnet", schema_of(std::span(magnet_rows))},
                             {"effects", effects()},
                             {"parameters", parameters()}})
                   .text();
}
