#include "formats/actuator/actuator_reader.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <vector>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/calibration_doubts.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/design/dimensions.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"
#include "coilwright/winding/wire.hpp"
#include "formats/actuator/as_built_format.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;

constexpr double most_turns = 10'000.0;
constexpr double absolute_zero = -273.15;  // degC

// For which the relation between a hardness and a modulus holds: Shore A by Gent, Shore 00 by Hertz.
constexpr Rule shore_a = Rule::between(20.0, 80.0);
constexpr Rule shore_00 = Rule::between(10.0, 70.0);
// Of IEC 60317-0-1, winding::least_bare_diameter and winding::largest_bare_diameter; and whatever lies over that.
constexpr Rule wire_mm = Rule::between(0.018, 5.0);
constexpr Rule wire_overall_mm = Rule::between(0.02, 10.0);
constexpr Rule modulus_MPa = Rule::between(1e-3, 100.0);

using actuator::ComponentKind;
using actuator::Design;

// Whether a file carries factors that were found under the hinge law of the first version, which wrote no law. What it
// leaves out was another default then.
bool calibrated_by_first_version(const Node& actuator) {
  if (!actuator.find("calibration")) return false;
  const auto choices = actuator.find("model");
  return !choices || !choices->find("hinge");
}

void set_defaults_of_first_version(Design& design) {
  design.choices.hinge = actuator::HingeLaw::beam;
  design.choices.damping = actuator::DampingLaw::proportional;
  design.choices.faces = actuator::ContactChoice::hard_parts;
  design.body.loss_time = 10.3e-3;
  design.body.constant_damping = 0.0;
  design.choices.ampacity = actuator::AmpacityChoice::table;
}

void read_section(ObjectReader& in, std::string_view section, Design& design) {
  const auto node = in.find(section);
  if (!node) return;
  ObjectReader keys(*node);
  std::vector<const actuator::Parameter*> given;
  for (const actuator::Parameter& parameter : actuator::parameters()) {
    if (parameter.section != section) continue;
    const auto value = keys.find(parameter.key);
    if (!value) continue;
    for (const actuator::Parameter* other : given)
      if (const auto conflict = conflict_between(parameter, *other)) throw value->error_without_value(*conflict);
    given.push_back(&parameter);
    if (!parameter.names().empty())
      parameter.set(design, read_name(*value, parameter));
    else if (parameter.whole)
      parameter.set(design, value->integer<int>(rule_of(parameter)));
    else
      parameter.set(design, units::to_memory(value->number(rule_of(parameter)), parameter.key));
  }
  if (section == "calibration")
    if (const auto reference = keys.find("hinge_reference"))
      design.calibration.hinge = read_object(*reference, [](ObjectReader& joint) {
        return read_rows(joint, hinge_reference_rows, actuator::HingeReference{});
      });
  keys.finish();
}

actuator::ModelChoices read_choices(const Node& node, const actuator::ModelChoices& usual) {
  return read_object(node, [&usual](ObjectReader& in) { return read_rows(in, model_rows, usual); });
}

actuator::Measured read_measured(const Node& node) {
  return read_object(node, [](ObjectReader& in) { return read_rows(in, measured_rows, actuator::Measured{}); });
}

// A slip of the unit makes a measured value a thousand times what the dimensions give, which no silicone does that is
// softer than its hardness says. A damping may be declared as next to nothing.
void require_plausible(const Design& design) {
  constexpr double most = 100.0;
  if (!actuator::construction_faults(design).empty()) return;
  for (const actuator::CalibrationDoubt& each : actuator::calibration_doubts(design))
    if (each.quantity != "joint damping" && (each.factor > most || each.factor < 1.0 / most))
      throw std::invalid_argument(
          fmt::format("{} is {:.3g} times what dimensions and materials give: is it in the unit of its key?",
                      each.quantity, each.factor));
}

// "configuration", or "layout" with an optional "polarity".
actuator::Layout read_row_of_design(ObjectReader& in) {
  if (in.one_of({"configuration", "layout"}) == "configuration")
    return actuator::layout_of(read_configuration(in.at("configuration")));
  return read_row(in.at("layout"), in.find("polarity"));
}

}  // namespace

std::string name_rule(const actuator::Parameter& parameter, std::string_view text) {
  const std::vector<std::string> names(parameter.names().begin(), parameter.names().end());
  return must_be_one_of(names) + did_you_mean(text, names);
}

double read_name(const Node& node, const actuator::Parameter& parameter) {
  const std::string& text = node.text();
  if (const std::optional<double> value = actuator::value_named(parameter, text)) return *value;
  throw node.error(name_rule(parameter, text));
}

Rule rule_of(const actuator::Parameter& parameter) {
  // What has a table, a relation or a lowest value of its own.
  if (parameter.name == "wire_gauge_AWG") return Rule::between(winding::thickest_gauge, winding::thinnest_gauge);
  if (parameter.name == "poisson_ratio") return Rule::between(0.0, 0.5);
  if (parameter.key == "shore_hardness_A") return shore_a;
  if (parameter.key == "shore_hardness_00") return shore_00;
  if (parameter.key == "youngs_modulus_MPa") return modulus_MPa;
  if (parameter.name == "wire_diameter_mm") return wire_mm;
  if (parameter.name == "wire_overall_mm") return wire_overall_mm;
  if (parameter.name == "remanence_T") return design_remanence;
  if (parameter.name == "coercivity_kA_m")
    return Rule::between(1e-3 * actuator::least_coercivity, 1e-3 * actuator::most_coercivity);
  if (parameter.key.ends_with("_coefficient_pct_K"))
    return Rule::between(-1e2 * actuator::most_coefficient, 1e2 * actuator::most_coefficient);
  if (parameter.name == "recoil_permeability") return recoil_rule;
  if (parameter.name == "squareness") return Rule::between(actuator::least_squareness, actuator::most_squareness);
  if (parameter.name == "gravity_m_s2") return Rule::between(0.0, actuator::most_gravity);
  if (parameter.name == "ambient_degC") return Rule::between(actuator::coldest_ambient, actuator::hottest_ambient);
  if (parameter.key.ends_with("_degC")) return Rule::above(absolute_zero).and_also(Rule::at_most(largest_number));
  switch (parameter.rule) {
    case actuator::ParameterRule::positive:
      return positive.and_also(Rule::at_most(largest_number));
    case actuator::ParameterRule::length:
      return part_length(parameter.key);
    case actuator::ParameterRule::not_negative:
      return Rule::between(0.0, largest_number);
    case actuator::ParameterRule::at_least_one:
      return Rule::between(1.0, most_turns);
    case actuator::ParameterRule::share:
      return Rule::between(-1.0, 1.0);
    case actuator::ParameterRule::any:
      break;
  }
  return Rule::between(-largest_number, largest_number);
}

actuator::Configuration read_configuration(const Node& node) {
  using actuator::Configuration;
  return node.choice<Configuration>(
      {{"A", Configuration::A}, {"B", Configuration::B}, {"C", Configuration::C}, {"D", Configuration::D}});
}

actuator::Layout read_row(const Node& list, const std::optional<Node>& polarity) {
  actuator::Layout layout;
  for (const Node& part : list.elements(Length::at_least(1)))
    layout.push_back(
        {.kind = part.choice<ComponentKind>({{"coil", ComponentKind::coil}, {"magnet", ComponentKind::magnet}})});
  if (polarity) read_polarity(*polarity, layout);
  try {
    actuator::check_layout(layout);
  } catch (const std::invalid_argument& mistake) {
    throw list.error_without_value(mistake.what());
  }
  return layout;
}

void read_polarity(const Node& node, actuator::Layout& layout) {
  const std::vector<Node> elements = node.elements(Length::exactly(layout.size()));
  for (std::size_t i = 0; i < elements.size(); ++i) {
    layout[i].polarity = elements[i].integer<int>();
    if (layout[i].polarity != 1 && layout[i].polarity != -1) throw elements[i].error("must be 1 or -1");
  }
}

DesignContent read_design(ObjectReader& in, const actuator::EffectCatalogue& known) {
  DesignContent content;
  Design& design = content.design;
  if (calibrated_by_first_version(in.node())) set_defaults_of_first_version(design);
  design.layout = read_row_of_design(in);
  for (const std::string_view section : {"coil", "magnet", "body", "bottom_layer_silicone", "surroundings"})
    read_section(in, section, design);
  if (const int number = share_without_coil(design); number > 0)
    throw in.at("coil")
        .find(fmt::format("current_share_{}", number))
        ->error(fmt::format("must be of a coil that there is: the layout has {}", coil_count(design.layout)));
  if (const auto choices = in.find("model")) design.choices = read_choices(*choices, design.choices);
  if (const actuator::ConstructionFaults broken = actuator::construction_faults(design); !broken.empty())
    throw in.node().error_without_value(broken.front().rule);
  const auto measured = in.find("measured");
  if (measured && in.find("calibration"))
    throw in.node().error_without_value(R"(gives "measured" and "calibration"; only one of them may be there)");
  read_section(in, "calibration", design);
  design.effects = read_effects(in, known);
  design.as_built = read_as_built(in);
  if (const auto& correction = design.as_built.torque_correction; correction && correction->joint)
    if (const auto joints = design.layout.size() - 1; static_cast<std::size_t>(*correction->joint) >= joints)
      throw in.at("torque_correction").find("joint")->error(fmt::format("must be from 1 to {}", joints));
  if (const auto point = in.find("operating_point")) content.operating_point = read_operating_point(*point);
  if (measured) {
    try {
      content.measured = read_measured(*measured);
      design.calibration = actuator::calibrate(design, content.measured);
      require_plausible(design);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const InputError&) {
      throw;
    } catch (const std::exception& mistake) {
      throw measured->error_without_value(mistake.what());
    }
  }
  return content;
}

}  // namespace coilwright::formats
