#include "coilwright/formats/data/declared_actuator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formats/actuator/actuator_reader.hpp"
#include "formats/data/declared_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;

const std::vector<actuator::Effect>& effects_of(const std::variant<actuator::Design, LumpedModel>& content) {
  return std::visit([](const auto& one) -> const std::vector<actuator::Effect>& { return one.effects; }, content);
}

// Numbers of effects that a fit could move and that no name does.
std::vector<std::string> held_numbers(const std::vector<actuator::Effect>& effects,
                                      std::span<const std::string> names) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    for (const actuator::EffectParameter& number : effects[i].kind->parameters()) {
      std::string pointer = fmt::format("/effects/{}/parameters/{}", i, number.key);
      if (number.choices.empty() && std::ranges::find(names, pointer) == names.end())
        out.push_back(fmt::format("{} of {}", std::move(pointer), effects[i].kind->id()));
    }
  }
  return out;
}

DeclaredActuator declared_by(Document document, const Calibrate& calibrate, const actuator::EffectCatalogue& effects) {
  ActuatorContent read = read_actuator_content(document, effects);
  CalibrateNames names(calibrate, document.root().file());
  std::vector<std::string> held = held_numbers(effects_of(read.content), calibrate.names);
  DeclaredActuator out = std::visit(
      [&](auto& content) { return declare(std::move(document), std::move(content), std::move(names), effects); },
      read.content);
  out.name = std::move(read.name);
  out.model.uncalibrated_effect_numbers = std::move(held);
  return out;
}

}  // namespace

DeclaredActuator read_declared_actuator(const std::filesystem::path& actuator, const Calibrate& calibrate,
                                        const actuator::EffectCatalogue& effects) {
  return declared_by(read_json(actuator), calibrate, effects);
}

DeclaredActuator parse_declared_actuator(std::string_view text, std::string file, const Calibrate& calibrate,
                                         const actuator::EffectCatalogue& effects) {
  return declared_by(parse_json(text, std::move(file)), calibrate, effects);
}

}  // namespace coilwright::formats
