#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <variant>

#include "cli/bench/bench.hpp"
#include "cli/packed_files.hpp"
#include "cli/search/list/listings.hpp"
#include "coilwright/actuator/design/effect_number.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/drive/coil_bank.hpp"
#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/actuator/parameter_rule.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using actuator::Parameter;
using text::Json;

// The numbers of an operating point that `evaluate` takes.
struct OperatingKnob {
  std::string_view name;
  std::optional<double> formats::OperatingWords::*word;
};
constexpr std::array operating_knobs{
    OperatingKnob{"current_A", &formats::OperatingWords::current},
    OperatingKnob{"duty", &formats::OperatingWords::duty},
    OperatingKnob{"supply_voltage_V", &formats::OperatingWords::supply_voltage},
    OperatingKnob{"supply_resistance_Ohm", &formats::OperatingWords::supply_resistance},
    OperatingKnob{"grasp_opening_deg", &formats::OperatingWords::grasp_opening},
    OperatingKnob{"grasp_height_mm", &formats::OperatingWords::grasp_height}};
constexpr std::array<std::string_view, 4> configurations{"A", "B", "C", "D"};

// "A" to "D", or the parts of a row that has no letter.
std::string row_name(const actuator::Layout& layout) {
  for (const actuator::Configuration each :
       {actuator::Configuration::A, actuator::Configuration::B, actuator::Configuration::C, actuator::Configuration::D})
    if (actuator::layout_of(each) == layout) return std::string(name_of(each));
  std::vector<std::string> parts;
  for (const actuator::Component& part : layout)
    parts.push_back(fmt::format("{}{}", part.polarity < 0 ? "-" : "",
                                part.kind == actuator::ComponentKind::coil ? "coil" : "magnet"));
  return fmt::format("{}", fmt::join(parts, " "));
}

Json knob(std::string_view name, std::string_view group, std::string_view key, std::string_view meaning) {
  const auto split = units::split_unit(key);
  return Json::object(
      {{"name", name}, {"group", group}, {"unit", split ? Json(split->unit.suffix) : Json()}, {"meaning", meaning}});
}

void set_rule(Json& out, const text::Rule& rule, bool whole) {
  out.set("whole", whole);
  out.set("lower", text::number_or_null(rule.lower()));
  out.set("upper", text::number_or_null(rule.upper()));
  out.set("range", range_in_words(rule));
}

Json words_json(std::span<const std::string_view> words) {
  return Json::list(words);
}

void add_operating_knobs(Json& out) {
  const text::Document schema =
      text::parse_json(packed_text(schemas(), "actuator.schema.json"), "actuator.schema.json");
  const text::Node properties =
      schema.root().find("properties").value().find("operating_point").value().find("properties").value();
  const auto add = [&](std::string_view name, std::span<const std::string_view> words) {
    const text::Node fact = properties.find(name).value();
    Json one = knob(name, "operating point", name, fact.find("description").value().text());
    if (!words.empty()) {
      one.set("words", words_json(words));
    } else {
      const auto number = [&](const char* key) -> Json {
        const auto found = fact.find(key);
        return found ? Json(found->number()) : Json();
      };
      const Json above = number("exclusiveMinimum");
      one.set("whole", false);
      one.set("lower", std::holds_alternative<double>(above.content()) ? above : number("minimum"));
      one.set("upper", number("maximum"));
    }
    out.add(std::move(one));
  };
  for (const OperatingKnob& each : operating_knobs) add(each.name, {});
  add("wiring", drive::bank_wiring_words);
}

}  // namespace

Json knobs(const Bench& bench) {
  Json out = Json::array();
  add_operating_knobs(out);
  Json row = knob("configuration", "row", "configuration", "Row of coils and magnets, base to tip");
  row.set("words", words_json(configurations));
  out.add(std::move(row));
  const Listing meanings = parameter_listing();
  const std::span<const Parameter> all = actuator::parameters();
  for (std::size_t i = 0; i < all.size(); ++i) {
    Json one = knob(all[i].name, all[i].section, all[i].key, std::get<std::string>(meanings.rows[i].back()));
    if (all[i].names().empty())
      set_rule(one, formats::rule_of(all[i]), all[i].whole);
    else
      one.set("words", words_json(all[i].names()));
    out.add(std::move(one));
  }
  const auto& design = std::get<actuator::Design>(bench.file.content);
  for (const actuator::Effect& effect : design.effects)
    for (std::size_t i = 0; i < effect.values.size(); ++i) {
      const actuator::EffectParameter& number = effect.kind->parameters()[i];
      Json one =
          knob(effect_number_name(effect, i), fmt::format("effect {}", effect.kind->id()), number.key, number.text);
      set_rule(one, formats::rule_of(number), false);
      out.add(std::move(one));
    }
  return out;
}

Json knob_values(const Turned& turned) {
  Json out = formats::to_json(turned.point);
  out.set("configuration", row_name(turned.design.layout));
  for (const Parameter& each : actuator::parameters()) {
    if (each.needed != nullptr && !each.needed(turned.design)) continue;
    if (each.section == "bottom_layer_silicone" && !turned.design.bottom_silicone) continue;
    const double value = units::from_memory(each.get(turned.design), each.key);
    if (!each.names().empty())
      out.set(std::string(each.name), each.names()[static_cast<std::size_t>(value)]);
    else
      out.set(std::string(each.name), each.whole ? Json(static_cast<int>(value)) : Json(value));
  }
  for (const actuator::Effect& effect : turned.design.effects)
    for (std::size_t i = 0; i < effect.values.size(); ++i)
      out.set(effect_number_name(effect, i), units::from_memory(effect.values[i], effect.kind->parameters()[i].key));
  return out;
}

Turned turned(const Bench& bench, const std::vector<std::string>& changes) {
  actuator::Design design = std::get<actuator::Design>(bench.file.content);
  formats::OperatingWords said;
  for (const std::string& change : changes) {
    const text::NameAndValue each = text::split_assignment(change, change, "gap_mm=1.2");
    const auto known = std::ranges::find(operating_knobs, each.name, &OperatingKnob::name);
    if (known != operating_knobs.end()) {
      said.*(known->word) = text::number_of(change, each.value);
    } else if (each.name == "wiring") {
      const auto word = std::ranges::find(drive::bank_wiring_words, each.value);
      if (word == drive::bank_wiring_words.end()) throw text::argument_error(change, "must be parallel or series");
      said.wiring = static_cast<actuator::Wiring>(word - drive::bank_wiring_words.begin());
    } else {
      design = formats::with_assignment(std::move(design), change);
    }
  }
  formats::ActuatorFile file = bench.file;
  file.content = design;
  return {.design = std::move(design), .point = formats::operating_point_of(file, said, bench.shown, "")};
}

std::string actuator_text(const Bench& bench, const Turned& turned) {
  return formats::to_json(turned.design, bench.file.name, turned.point).text();
}

}  // namespace coilwright::cli
