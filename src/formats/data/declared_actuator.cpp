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
#include "coilwright/measurement/replay/tolerance_plan.hpp"
#include "coilwright/text/json/json_pointer.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/data/calibrate_names.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Effect;
using measurement::replay::DeclaredDesign;
using measurement::replay::DeclaredLumpedModel;
using measurement::replay::MovedBy;
using measurement::replay::PlannedNumber;
using measurement::replay::ToleranceFault;
using measurement::replay::TolerancePlan;

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

std::string place_of_tolerance(const Calibrate& calibrate, std::string_view name) {
  return std::string(calibrate.tolerances_pointer) + pointer_step(name);
}

// The names that lead into the file or mean all joints; differences stand behind them.
CalibrateNames names_in_file(const TolerancePlan& plan, const Calibrate& calibrate, const std::string& actuator) {
  std::vector<CalibrateName> names;
  for (const PlannedNumber& number : plan.numbers) {
    if (number.difference) continue;
    CalibrateName& name = names.emplace_back(CalibrateName{.name = number.name, .place = {}});
    name.is_value = number.by == MovedBy::calibrate;
    // Those that are calibrated come first.
    if (name.is_value) name.place = fmt::format("{}/{}", calibrate.pointer, names.size() - 1);
    if (number.by == MovedBy::tolerances) name.place = place_of_tolerance(calibrate, number.name);
  }
  return {std::move(names), calibrate.file, actuator};
}

// A declared model in which the planned numbers move.
DeclaredActuator declare(const std::shared_ptr<const Document>& file, DesignContent content,
                         const actuator::ModelSpec& drawn, const TolerancePlan& plan, CalibrateNames names) {
  if (plan.force_curve) content.design.as_built.force_curve = plan.force_curve;
  std::vector<DesignNumber> numbers = with_tolerances(design_numbers(*file, content.design, drawn, names), plan);
  const DeclaredDesign declared(std::move(content.design), content.measured, drawn, std::move(numbers));
  return {.name = {},
          .model = {.calibration = declared.parameters(),
                    .build = [declared](std::span<const double> values) { return declared.spec_at(values); },
                    .held_exact = plan.held_exact},
          .updated = [declared](std::span<const double> values, const std::vector<Effect>& effects) {
            actuator::Design design = declared.design_at(values);
            design.effects = joined(std::move(design.effects), effects);
            return UpdatedActuator(std::move(design));
          }};
}

DeclaredActuator declare(const std::shared_ptr<const Document>& file, LumpedModelContent content,
                         const TolerancePlan& plan, CalibrateNames names) {
  if (plan.force_curve) content.model.as_built.force_curve = plan.force_curve;
  LumpedNumbers found = lumped_numbers(*file, content.model, names);
  const DeclaredLumpedModel declared(std::move(content.model), std::move(content.magnetics),
                                     with_tolerances(std::move(found.numbers), plan));
  return {.name = {},
          .model = {.calibration = declared.parameters(),
                    .build = [declared](std::span<const double> values) { return declared.spec_at(values); },
                    .held_exact = plan.held_exact},
          .updated = [declared, file, in_file = std::move(found.in_file)](std::span<const double> values,
                                                                          const std::vector<Effect>& effects) {
            actuator::LumpedModel model = declared.model_at(values);
            std::vector<Effect> all = joined(model.effects, effects);
            const actuator::AsBuilt as_built = model.as_built;
            return UpdatedActuator(UpdatedLumpedModel{.document = with_numbers_of(*file, in_file, std::move(model)),
                                                      .effects = std::move(all),
                                                      .as_built = as_built});
          }};
}

// What `declare` makes of the plan, once defaults that act alike have been left out of it.
template <class Declare>
DeclaredActuator declared_by_plan(TolerancePlan plan, const Declare& declare) {
  DeclaredActuator all = declare(plan);
  const bool defaults = std::ranges::count(plan.numbers, MovedBy::defaults, &PlannedNumber::by) > 0;
  return defaults ? declare(measurement::replay::without_duplicates(std::move(plan), all.model)) : all;
}

DeclaredActuator declare(const std::shared_ptr<const Document>& file, const DesignContent& content,
                         const Calibrate& calibrate) {
  try {
    const actuator::Assembly assembly = actuator::assemble_or_throw(content.design);
    actuator::Design drawn_design = content.design;
    drawn_design.as_built = {};
    const actuator::ModelSpec drawn = actuator::assemble_or_throw(drawn_design).model.nominal_spec();
    DeclaredActuator out = declared_by_plan(
        tolerance_plan(calibrate.names, calibrate.tolerances, content.design, content.measured, drawn),
        [&](const TolerancePlan& plan) {
          return declare(file, content, drawn, plan, names_in_file(plan, calibrate, file->root().file()));
        });
    out.model.heat = actuator::heat_network(content.design, assembly);
    return out;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const ToleranceFault&) {
    throw;
  } catch (const std::exception& reason) {
    throw InputError({.file = file->root().file(), .place = "/", .rule = reason.what()});
  }
}

DeclaredActuator declare(const std::shared_ptr<const Document>& file, const LumpedModelContent& content,
                         const Calibrate& calibrate) {
  return declared_by_plan(tolerance_plan(calibrate.names, calibrate.tolerances, content.model),
                          [&](const TolerancePlan& plan) {
                            return declare(file, content, plan, names_in_file(plan, calibrate, file->root().file()));
                          });
}

DeclaredActuator declared_by(Document document, const Calibrate& calibrate, const actuator::EffectCatalogue& effects) {
  const auto file = std::make_shared<const Document>(std::move(document));
  ActuatorContent read = read_actuator_content(*file, effects);
  std::vector<std::string> uncalibrated = uncalibrated_numbers(
      std::visit([](const auto& content) { return effects_of(content); }, read.content), calibrate.names);
  try {
    DeclaredActuator out =
        std::visit([&](const auto& content) { return declare(file, content, calibrate); }, read.content);
    out.name = std::move(read.name);
    out.model.uncalibrated_effect_numbers = std::move(uncalibrated);
    return out;
  } catch (const ToleranceFault& fault) {
    throw InputError({.file = calibrate.file,
                      .place = place_of_tolerance(calibrate, fault.name()),
                      .rule = fault.what(),
                      .value = fault.value()});
  }
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
