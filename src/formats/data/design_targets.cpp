#include "formats/data/calibrate_names.hpp"

#include <array>
#include <utility>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/actuator_reader.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Design;
using actuator::Hinge;
using actuator::ModelSpec;
using actuator::Parameter;
using measurement::replay::DesignParameter;
using measurement::replay::HingesNumber;
using measurement::replay::MeasuredNumber;

double usual_change(const Parameter& parameter) {
  if (parameter.name == "base_tilt_deg") return 0.1;  // rad
  if (parameter.name == "gravity_m_s2") return usual_gravity;
  return units::to_memory(1.0, parameter.key);
}

// All that a name may mean, one kind after the other.
class NumberResolver {
 public:
  NumberResolver(const Document& document, const Design& design, const ModelSpec& spec, CalibrateNames& names)
      : document_(document), design_(design), spec_(spec), names_(names) {}

  [[nodiscard]] DesignNumber resolve(std::size_t i) {
    const std::string& name = names_.name(i);
    if (name == "joint_stiffness") return of_hinges(i, &Hinge::stiffness, "joint_stiffness_Nmm_rad");
    if (name == "joint_damping") return of_hinges(i, &Hinge::damping, "joint_damping_Nmms_rad");
    const std::vector<std::string> steps = names_.steps(i);
    names_.claim(i, {name});
    if (const auto number = names_.effect_number(i, steps, design_.effects))
      return {.parameter = calibration_parameter(name, design_.effects[number->effect], number->parameter),
              .target = *number};
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
  DesignNumber of_hinges(std::size_t i, double Hinge::*member, const std::string& key) {
    names_.claim(i, {"/measured/" + key, "/calibration/" + names_.name(i) + "_factor"});
    // A design's factors are > 0, and so is what they make.
    return {.parameter = calibration_parameter(key, key, spec_.hinges.front().*member, positive, 1.0),
            .target = HingesNumber{member}};
  }

  DesignNumber of_measured(std::size_t i, const Node& node) const {
    for (const auto& each : measured_rows)
      if (each.key == node.key() && each.need != text::Need::fixed)
        return {.parameter = calibration_parameter(names_.name(i), each.key, node.quantity(), positive, 1.0),
                .target = MeasuredNumber{each.said}};
    throw names_.leads_nowhere(i);
  }

  DesignNumber of_parameter(std::size_t i, const Parameter& parameter) const {
    if (parameter.whole) throw names_.cannot_move(i, "this one is a whole number");
    Rule rule = rule_of(parameter);
    if (parameter.name == "base_tilt_deg") rule = rule.and_also(Rule::between(-180.0, 180.0));  // beyond, it repeats
    return {.parameter = calibration_parameter(names_.name(i), parameter.key, parameter.get(design_), rule,
                                               usual_change(parameter)),
            .target = DesignParameter{&parameter}};
  }

  const Document& document_;
  const Design& design_;
  const ModelSpec& spec_;
  CalibrateNames& names_;
};

}  // namespace

std::vector<DesignNumber> design_numbers(const Document& document, const Design& design, const ModelSpec& spec,
                                         CalibrateNames& names) {
  NumberResolver resolver(document, design, spec, names);
  std::vector<DesignNumber> numbers;
  for (std::size_t i = 0; i < names.size(); ++i) numbers.push_back(resolver.resolve(i));
  return numbers;
}

}  // namespace coilwright::formats
