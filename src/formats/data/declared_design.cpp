#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <utility>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/actuator/design_reader.hpp"
#include "formats/data/declared_parts.hpp"
#include "formats/data/recent_results.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Design;
using actuator::Effect;
using actuator::Hinge;
using actuator::ModelSpec;
using actuator::Parameter;
using measurement::replay::CalibrationParameter;

// What a number changes, from the cheapest to the dearest.
enum class Touches {
  hinges,    // one value for all joints, in the model
  effects,   // of the design
  gravity,   // or the tilt of the base: the chain alone
  geometry,  // everything is assembled anew
  measured   // calibrated anew from the file, and then assembled
};

struct Movable {
  CalibrationParameter parameter;
  Touches touches{};
  double Hinge::*member{};    // hinges
  EffectNumber effect{};      // effects
  const Parameter* number{};  // gravity, geometry
  std::string pointer{};      // measured
  units::Unit unit{};         // measured
};

double usual_change(const Parameter& parameter) {
  if (parameter.name == "base_tilt_deg") return 0.1;  // rad
  if (parameter.name == "gravity_m_s2") return usual_gravity;
  return units::to_memory(1.0, parameter.key);
}

class Finder {
 public:
  Finder(const Document& document, const Design& design, const ModelSpec& spec, CalibrateNames& names)
      : document_(document), design_(design), spec_(spec), names_(names) {}

  [[nodiscard]] Movable find(std::size_t i) {
    const std::string& name = names_.name(i);
    if (name == "joint_stiffness" || name == "joint_damping") return of_hinges(i, name);
    const std::vector<std::string> steps = names_.steps(i);
    names_.claim(i, {name});
    if (const auto number = names_.effect_number(i, steps, design_.effects))
      return {.parameter = calibration_parameter(name, design_.effects[number->effect], number->parameter),
              .touches = Touches::effects,
              .effect = *number};
    const auto there = follow(document_.root(), steps);
    if (there && there->kind() != Node::Kind::number)
      throw names_.error(i, "must lead to a number, and leads to " + there->shown());
    if (steps.front() == "measured" && there) return of_measured(i, *there);
    if (steps.size() == 2)
      for (const Parameter& parameter : actuator::parameters())
        if (parameter.section == steps[0] && parameter.key == steps[1]) return of_parameter(i, parameter);
    if (there) throw names_.cannot_move(i, "this one is a choice");
    throw names_.leads_nowhere(i);
  }

 private:
  Movable of_hinges(std::size_t i, const std::string& name) {
    const bool stiffness = name == "joint_stiffness";
    const std::string key = name + (stiffness ? "_Nmm_rad" : "_Nmms_rad");
    names_.claim(i, {"/measured/" + key, "/calibration/" + name + "_factor"});
    const auto member = stiffness ? &Hinge::stiffness : &Hinge::damping;
    // A design's factors are > 0, and so is what they make.
    return {.parameter = calibration_parameter(key, key, spec_.hinges.front().*member, positive, 1.0),
            .touches = Touches::hinges,
            .member = member};
  }

  Movable of_measured(std::size_t i, const Node& node) const {
    const auto name = units::split_unit(node.key());
    if (!name) throw names_.leads_nowhere(i);
    return {.parameter = calibration_parameter(names_.name(i), node.key(), node.quantity(), positive, 1.0),
            .touches = Touches::measured,
            .pointer = names_.name(i),
            .unit = name->unit};
  }

  Movable of_parameter(std::size_t i, const Parameter& parameter) const {
    if (parameter.whole) throw names_.cannot_move(i, "this one is a whole number");
    const bool chain = parameter.name == "gravity_m_s2" || parameter.name == "base_tilt_deg";
    Rule rule = rule_of(parameter);
    if (parameter.name == "base_tilt_deg") rule = rule.and_also(Rule::between(-180.0, 180.0));  // beyond, it repeats
    return {.parameter = calibration_parameter(names_.name(i), parameter.key, parameter.get(design_), rule,
                                               usual_change(parameter)),
            .touches = chain ? Touches::gravity : Touches::geometry,
            .number = &parameter};
  }

  const Document& document_;
  const Design& design_;
  const ModelSpec& spec_;
  CalibrateNames& names_;
};

// What build() and updated() share.
class DeclaredDesign {
 public:
  DeclaredDesign(Document document, Design design, const actuator::Assembly& assembly, CalibrateNames names,
                 actuator::EffectCatalogue known)
      : document_(std::move(document)), design_(std::move(design)), known_effects_(std::move(known)) {
    Finder finder(document_, design_, assembly.model.nominal_spec(), names);
    for (std::size_t i = 0; i < names.size(); ++i) movables_.push_back(finder.find(i));
    std::vector<double> dear;
    for (const Movable& movable : movables_)
      if (is_dear(movable)) dear.push_back(movable.parameter.declared);
    (void)assembled_.get(dear, [&] { return assembly.model.nominal_spec(); });
  }

  [[nodiscard]] std::vector<CalibrationParameter> parameters() const {
    std::vector<CalibrationParameter> all;
    for (const Movable& movable : movables_) all.push_back(movable.parameter);
    return all;
  }

  [[nodiscard]] ModelSpec spec_at(std::span<const double> values) {
    const Design design = design_at(values);
    ModelSpec spec = *assembled_at(design, values);
    spec.chain = spec.chain.under_gravity(design.surroundings.gravity, design.surroundings.base_tilt);
    spec.effects = design.effects;
    for (std::size_t i = 0; i < movables_.size(); ++i)
      if (movables_[i].touches == Touches::hinges)
        for (Hinge& hinge : spec.hinges) hinge.*movables_[i].member = values[i];
    return spec;
  }

  [[nodiscard]] UpdatedActuator updated(std::span<const double> values, const std::vector<Effect>& effects) {
    Design design = design_at(values);
    const std::shared_ptr<const ModelSpec> spec = assembled_at(design, values);
    for (std::size_t i = 0; i < movables_.size(); ++i) {
      if (movables_[i].touches != Touches::hinges) continue;
      double& factor = movables_[i].member == &Hinge::stiffness ? design.calibration.joint_stiffness
                                                                : design.calibration.joint_damping;
      factor *= values[i] / spec->hinges.front().*movables_[i].member;
    }
    design.effects = joined(std::move(design.effects), effects);
    return design;
  }

 private:
  static bool is_dear(const Movable& movable) {
    return movable.touches == Touches::geometry || movable.touches == Touches::measured;
  }

  Design design_at(std::span<const double> values) {
    if (values.size() != movables_.size())
      throw std::invalid_argument(
          fmt::format("calibration must have {} values; got {}", movables_.size(), values.size()));
    Design design = measured_at(values);
    for (std::size_t i = 0; i < movables_.size(); ++i) {
      const Movable& movable = movables_[i];
      if (movable.number != nullptr) movable.number->set(design, values[i]);
      if (movable.touches == Touches::effects)
        design.effects[movable.effect.effect].values[movable.effect.parameter] = values[i];
    }
    return design;
  }

  // The file's design, calibrated by other measured values.
  Design measured_at(std::span<const double> values) {
    std::map<std::string, double> numbers;
    std::vector<double> measured;
    for (std::size_t i = 0; i < movables_.size(); ++i) {
      if (movables_[i].touches != Touches::measured) continue;
      numbers[movables_[i].pointer] = units::from_si(values[i], movables_[i].unit);
      measured.push_back(values[i]);
    }
    if (numbers.empty()) return design_;
    return *calibrated_.get(measured, [&] { return read_with(numbers); });
  }

  Design read_with(const std::map<std::string, double>& numbers) const {
    const Document changed = document_.with_numbers(numbers);
    try {
      return std::get<Design>(read_actuator_content(changed, known_effects_).content);
    } catch (const InputError& mistake) {
      throw std::invalid_argument(mistake.what());
    }
  }

  std::shared_ptr<const ModelSpec> assembled_at(const Design& design, std::span<const double> values) {
    std::vector<double> dear;
    for (std::size_t i = 0; i < movables_.size(); ++i)
      if (is_dear(movables_[i])) dear.push_back(values[i]);
    return assembled_.get(dear, [&] { return actuator::assemble_or_throw(design).model.nominal_spec(); });
  }

  Document document_;
  Design design_;
  actuator::EffectCatalogue known_effects_;
  std::vector<Movable> movables_;
  RecentResults<Design> calibrated_;
  RecentResults<ModelSpec> assembled_;
};

}  // namespace

DeclaredActuator declare(Document document, Design design, CalibrateNames names,
                         const actuator::EffectCatalogue& known) {
  const std::string file = document.root().file();
  try {
    const actuator::Assembly assembly = actuator::assemble_or_throw(design);
    thermal::Network heat = actuator::heat_network(design, assembly);
    const auto model = std::make_shared<DeclaredDesign>(std::move(document), design, assembly, std::move(names), known);
    return {.name = {},
            .model = {.calibration = model->parameters(),
                      .build = [model](std::span<const double> values) { return model->spec_at(values); },
                      .heat = std::move(heat)},
            .updated = [model](std::span<const double> values, const std::vector<Effect>& effects) {
              return model->updated(values, effects);
            }};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& reason) {
    throw InputError({.file = file, .place = "/", .rule = reason.what()});
  }
}

}  // namespace coilwright::formats
