#include "coilwright/formats/data/declared_actuator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <utility>
#include <variant>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/measurement/replay/declared_design.hpp"
#include "coilwright/measurement/replay/declared_lumped_model.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/data/calibrate_names.hpp"
#include "formats/data/design_targets.hpp"
#include "formats/data/lumped_targets.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Effect;
using measurement::replay::DeclaredDesign;
using measurement::replay::DeclaredLumpedModel;

const std::vector<Effect>& effects_of(const DesignContent& content) {
  return content.design.effects;
}
const std::vector<Effect>& effects_of(const LumpedModelContent& content) {
  return content.model.effects;
}

// Numbers of effects that a fit could move and that no name does.
std::vector<std::string> uncalibrated_numbers(const std::vector<actuator::Effect>& effects,
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

// The effects of the file and those that are added; one of a kind that is there already takes its place.
std::vector<Effect> joined(std::vector<Effect> declared, const std::vector<Effect>& added) {
  for (const Effect& effect : added) {
    const auto same = std::ranges::find(declared, effect.kind, &Effect::kind);
    if (same == declared.end())
      declared.push_back(effect);
    else
      *same = effect;
  }
  return declared;
}

DeclaredActuator declare(const std::shared_ptr<const Document>& file, DesignContent content, CalibrateNames& names) {
  try {
    const actuator::Assembly assembly = actuator::assemble_or_throw(content.design);
    const actuator::ModelSpec& spec = assembly.model.nominal_spec();
    thermal::Network heat = actuator::heat_network(content.design, assembly);
    std::vector<DesignNumber> numbers = design_numbers(*file, content.design, spec, names);
    const DeclaredDesign declared(std::move(content.design), content.measured, spec, std::move(numbers));
    return {.name = {},
            .model = {.calibration = declared.parameters(),
                      .build = [declared](std::span<const double> values) { return declared.spec_at(values); },
                      .heat = std::move(heat)},
            .updated = [declared](std::span<const double> values, const std::vector<Effect>& effects) {
              actuator::Design design = declared.design_at(values);
              design.effects = joined(std::move(design.effects), effects);
              return UpdatedActuator(std::move(design));
            }};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& reason) {
    throw InputError({.file = file->root().file(), .place = "/", .rule = reason.what()});
  }
}

DeclaredActuator declare(const std::shared_ptr<const Document>& file, LumpedModelContent content,
                         CalibrateNames& names) {
  LumpedNumbers found = lumped_numbers(*file, content.model, names);
  const DeclaredLumpedModel declared(std::move(content.model), std::move(content.magnetics), std::move(found.numbers));
  return {.name = {},
          .model = {.calibration = declared.parameters(),
                    .build = [declared](std::span<const double> values) { return declared.spec_at(values); }},
          .updated = [declared, file, in_file = std::move(found.in_file)](std::span<const double> values,
                                                                          const std::vector<Effect>& effects) {
            actuator::LumpedModel model = declared.model_at(values);
            std::vector<Effect> all = joined(model.effects, effects);
            return UpdatedActuator(UpdatedLumpedModel{.document = with_numbers_of(*file, in_file, std::move(model)),
                                                      .effects = std::move(all)});
          }};
}

DeclaredActuator declared_by(Document document, const Calibrate& calibrate, const actuator::EffectCatalogue& effects) {
  const auto file = std::make_shared<const Document>(std::move(document));
  ActuatorContent read = read_actuator_content(*file, effects);
  CalibrateNames names(calibrate, file->root().file());
  std::vector<std::string> uncalibrated = uncalibrated_numbers(
      std::visit([](const auto& content) { return effects_of(content); }, read.content), calibrate.names);
  DeclaredActuator out =
      std::visit([&](auto& content) { return declare(file, std::move(content), names); }, read.content);
  out.name = std::move(read.name);
  out.model.uncalibrated_effect_numbers = std::move(uncalibrated);
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
