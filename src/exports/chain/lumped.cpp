#include "coilwright/exports/kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "exports/chain/plain_model.hpp"

namespace coilwright::exports {
namespace {

using actuator::Effect;
using actuator::LumpedModel;
using actuator::Model;
using actuator::ModelSpec;

constexpr std::string_view tilt_effect = "base_tilt";

// The stages of `spec` by their numbers, without the effects.
LumpedModel numbers_of(const ModelSpec& spec) {
  const Model nominal(spec);
  LumpedModel out{.gravity = spec.chain.gravity(), .hinges = spec.hinges};
  out.links.assign(spec.chain.links().begin(), spec.chain.links().end());
  // To the tip: no link beyond counts from there, so this length does nothing to the motion.
  if (spec.tip.link == spec.chain.joints() - 1) out.links.back().length = spec.tip.along;
  std::vector<TorqueTable> tables = torque_tables(nominal);
  std::ranges::sort(tables, {}, &TorqueTable::joint);
  for (TorqueTable& table : tables)
    out.pairs.push_back(
        {.joint = table.joint,
         .source = actuator::TorqueTable{.angles = std::move(table.angles), .torques = std::move(table.torques)}});
  return out;
}

// A tilt of the chain as an effect, together with one that is among them.
void set_tilt(std::vector<Effect>& effects, double angle) {
  const actuator::EffectKind* kind = actuator::standard_effects().find(tilt_effect);
  const auto own = std::ranges::find_if(effects, [](const Effect& effect) { return effect.kind->id() == tilt_effect; });
  if (own != effects.end()) {
    angle += own->values.front();
    effects.erase(own);
  }
  const actuator::EffectParameter& rule = kind->parameters().front();
  if (!(angle >= rule.lower && angle <= rule.upper))
    throw std::invalid_argument(
        fmt::format("a lumped model is tilted by the effect {}, which must be from {:.6g} to {:.6g} deg; got {:.6g}",
                    tilt_effect, rule.lower * 180.0 / std::numbers::pi, rule.upper * 180.0 / std::numbers::pi,
                    angle * 180.0 / std::numbers::pi));
  if (angle != 0.0) effects.push_back({.kind = kind, .values = {angle}});
}

// What of a model's stages its numbers do not say.
std::vector<std::string> beyond_numbers(const Model& nominal) {
  std::vector<std::string> lines = distant_forces(nominal).lines;
  for (std::string& line : heat_of_a_design(nominal)) lines.push_back(std::move(line));
  for (std::string& line : shares_of_coils(nominal)) lines.push_back(std::move(line));
  if (nominal.coil_resistance())
    lines.push_back(fmt::format("the coils' resistance of {:.4g} Ohm, so that inputs are currents and no voltages",
                                *nominal.coil_resistance()));
  return lines;
}

// Several joints of one coil: in a lumped model each has a current of its own.
std::vector<std::string> shared_coils(const Model& nominal) {
  std::vector<std::string> lines;
  const auto& pairs = nominal.magnetics().hinge_pairs();
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t k = i + 1; k < pairs.size(); ++k)
      if (pairs[i].coil == pairs[k].coil)
        lines.push_back(fmt::format("that the currents of joints {} and {} are of one coil", pairs[i].joint + 1,
                                    pairs[k].joint + 1));
  return lines;
}

std::string description(const Origin& origin, const std::vector<std::string>& left_out) {
  std::string text = origin.made_by;
  if (!text.empty()) text += ". ";
  text += "Torque over angle as tables, to 1e-4 of the largest";
  if (left_out.empty()) return text + "; nothing is left out.";
  return fmt::format("{}. Left out: {}.", text, fmt::join(left_out, "; "));
}

}  // namespace

LumpedNumbers lumped_numbers(const Model& model) {
  ModelSpec spec = model.nominal_spec();
  std::vector<Effect> effects = std::exchange(spec.effects, {});
  std::optional<actuator::TorqueCorrection> correction = std::exchange(spec.torque_correction, std::nullopt);
  std::vector<std::string> left_out;

  // An effect that needs more than numbers is built into the curves where that is all it does.
  std::vector<Effect> kept;
  const LumpedModel bare = numbers_of(spec);
  const ModelSpec lumped_spec = actuator::spec_of(bare, actuator::magnetics_of(bare));
  for (Effect& effect : effects) {
    if (!effect.kind->inapplicable(lumped_spec)) {
      kept.push_back(std::move(effect));
      continue;
    }
    ModelSpec built_in = spec;
    const auto term = effect.kind->build(effect.values, built_in);
    if (term == nullptr && built_in.magnetics.distant_pairs().size() == spec.magnetics.distant_pairs().size())
      spec = std::move(built_in);
    else
      left_out.push_back(fmt::format("effect {}: {}", effect.kind->id(), effect.kind->description()));
  }

  const Model nominal(spec);
  LumpedNumbers out{.model = numbers_of(spec), .left_out = std::move(left_out)};
  if (spec.chain.gravity() > 0.0) set_tilt(kept, spec.chain.base_tilt());
  out.model.effects = std::move(kept);
  out.model.as_built.torque_correction = std::move(correction);
  for (std::string& line : beyond_numbers(nominal)) out.left_out.push_back(std::move(line));
  for (std::string& line : shared_coils(nominal)) out.left_out.push_back(std::move(line));
  return out;
}

std::vector<ExportedFile> lumped(const ModelSubject& subject, const ExportSettings&) {
  const LumpedNumbers numbers = lumped_numbers(subject.model);
  const std::string& name = subject.origin.name;
  return {{.name = "lumped_model.json",
           .text = formats::to_json(numbers.model, name, description(subject.origin, numbers.left_out)).text(),
           .left_out = numbers.left_out,
           .too_much = distant_forces(subject.model).too_much}};
}

}  // namespace coilwright::exports
