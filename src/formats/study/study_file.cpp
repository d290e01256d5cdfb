#include "coilwright/formats/study/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/text/spelling.hpp"
#include "formats/actuator/design_reader.hpp"
#include "formats/actuator/operating_point_format.hpp"
#include "formats/study/crawler_block.hpp"
#include "formats/study/driver_block.hpp"
#include "formats/study/gripper_block.hpp"
#include "formats/study/spread_block.hpp"
#include "formats/study/study_changes.hpp"
#include "formats/study/wanted_quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace sizing;

// Bounds far beyond any hardware and any search, and near enough that nothing overflows.
constexpr std::size_t most_values = 1'000'000;  // of one variable
constexpr Rule largest_share = positive.and_also(Rule::at_most(1e3));

using simulation::QuantityTable;

// What a study builds from its actuator, by the keys of its blocks.
using Blocks = std::map<std::string, SystemBlock>;

Blocks read_blocks(ObjectReader& in) {
  Blocks out;
  using Reader = SystemBlock (*)(const Node&);
  for (const auto& [key, read] : std::initializer_list<std::pair<const char*, Reader>>{
           {"gripper", read_gripper_block}, {"crawler", read_crawler_block}, {"driver", read_driver_block}})
    if (const auto node = in.find(key)) out.emplace(key, read(*node));
  return out;
}

std::vector<BlockVariable> variables_of(const Blocks& blocks) {
  std::vector<BlockVariable> out;
  for (const auto& [key, block] : blocks) out.insert(out.end(), block.variables.begin(), block.variables.end());
  return out;
}

QuantityTable with_quantities_of(const Blocks& blocks, QuantityTable table) {
  for (const simulation::ResultQuantity& each : simulation::joint_quantities()) table = table.with(each);
  for (const auto& [key, block] : blocks)
    for (const simulation::ResultQuantity& each : block.quantities) table = table.with(each);
  return table;
}

double read_value(const Node& node, const Rule& rule, VariableKind kind) {
  return kind == VariableKind::integer ? static_cast<double>(node.integer<int>(rule)) : node.number(rule);
}

Choice read_choice(const Node& list, const Rule& rule, VariableKind kind) {
  Choice choice;
  for (const Node& node : list.elements(Length::from_to(1, most_values))) {
    const double value = read_value(node, rule, kind);
    if (!choice.values.empty() && value <= choice.values.back())
      throw node.error(fmt::format("must exceed the value before it ({})", choice.values.back()));
    choice.values.push_back(value);
  }
  return choice;
}

Interval read_interval(ObjectReader& in, const Rule& rule, VariableKind kind) {
  Interval interval;
  interval.lower = read_value(in.at("lower"), rule, kind);
  const Node upper = in.at("upper");
  interval.upper = read_value(upper, rule, kind);
  if (interval.upper < interval.lower) throw upper.error(fmt::format("must not be below lower ({})", interval.lower));
  const auto step = in.find("step");
  if (!step) return interval;
  interval.step = read_value(*step, kind == VariableKind::integer ? Rule::at_least(1) : positive, kind);
  const double range = interval.upper - interval.lower;
  if (interval.step > range) throw step->error(fmt::format("must not exceed upper - lower ({})", range));
  if (range / interval.step > most_values) throw step->error(fmt::format("must make at most {} values", most_values));
  return interval;
}

// {"lower", "upper", "step"} or {"values": [...]}.
std::variant<Interval, Choice> read_range(ObjectReader& in, const Rule& rule, VariableKind kind) {
  if (in.one_of({"lower", "values"}) == "lower") return read_interval(in, rule, kind);
  return read_choice(in.at("values"), rule, kind);
}

// A row of coils and magnets under what files call it: the letter of a configuration, or its parts in words.
NamedLayout read_configuration_value(const Node& node) {
  const actuator::Configuration letter = read_configuration(node);
  return {.name = std::string(actuator::name_of(letter)), .layout = actuator::layout_of(letter)};
}

// "C", ["coil", "magnet", "coil"], or {"layout": [...], "polarity": [...]}.
NamedLayout read_layout_value(const Node& node) {
  if (node.kind() == Node::Kind::text) return read_configuration_value(node);
  actuator::Layout layout =
      node.kind() == Node::Kind::array
          ? read_row(node, std::nullopt)
          : read_object(node, [](ObjectReader& in) { return read_row(in.at("layout"), in.find("polarity")); });
  return {.name = text_of(layout), .layout = std::move(layout)};
}

// {"values": [...]} of rows of coils and magnets.
template <class ReadValue>
LayoutVariable read_layouts(const Node& node, const std::string& name, const ReadValue& read_value) {
  return read_object(node, [&](ObjectReader& in) {
    LayoutVariable variable{.name = name, .values = {}};
    for (const Node& element : in.elements("values", Length::at_least(1))) {
      NamedLayout value = read_value(element);
      if (std::ranges::count(variable.values, value.layout, &NamedLayout::layout) > 0)
        throw element.kind() == Node::Kind::text ? element.error("must not be there twice")
                                                 : element.error_without_value("must not be there twice");
      variable.values.push_back(std::move(value));
    }
    return variable;
  });
}

// The row of the study's own actuator, built in otherwise: [[1, 1, 1], [1, -1, 1]].
LayoutVariable read_polarities(const Node& node, const actuator::Layout& base) {
  return read_layouts(node, "polarity", [&base](const Node& element) {
    actuator::Layout layout = base;
    read_polarity(element, layout);
    return NamedLayout{.name = text_of(layout), .layout = std::move(layout)};
  });
}

constexpr std::array layout_names{"configuration", "layout", "polarity"};

// {"values": ["N42", "N52"]}.
ParameterVariable read_named(const Node& node, const actuator::Parameter& parameter) {
  return read_object(node, [&parameter](ObjectReader& in) {
    Choice choice;
    for (const Node& word : in.elements("values", Length::at_least(1))) {
      const double value = read_name(word, parameter);
      if (std::ranges::count(choice.values, value) > 0) throw word.error("must not be there twice");
      choice.values.push_back(value);
    }
    return ParameterVariable{.parameter = &parameter, .range = std::move(choice)};
  });
}

StudyVariable read_variable(const Node& node, const std::string& name, const std::vector<BlockVariable>& of_blocks) {
  if (name == "configuration") return read_layouts(node, name, read_configuration_value);
  if (name == "layout") return read_layouts(node, name, read_layout_value);
  if (name == "polarity") return LayoutVariable{.name = name, .values = {}};  // of a row that is read later
  if (name == "current_A")
    return read_object(node, [](ObjectReader& in) {
      return CurrentVariable{read_range(in, current_rule(), VariableKind::continuous)};
    });
  if (const auto found = std::ranges::find(of_blocks, name, &BlockVariable::name); found != of_blocks.end())
    return read_object(node, [&](ObjectReader& in) {
      return SettingVariable{
          .name = name, .base = found->base, .range = read_range(in, found->rule, VariableKind::continuous)};
    });
  const actuator::Parameter* parameter = actuator::find_parameter(name);
  if (parameter == nullptr) {
    std::vector<std::string> names(layout_names.begin(), layout_names.end());
    names.emplace_back("current_A");
    for (const BlockVariable& known : of_blocks) names.push_back(known.name);
    for (const actuator::Parameter& known : actuator::parameters()) names.emplace_back(known.name);
    throw node.error_without_value("is not a variable of a design" + did_you_mean(name, names));
  }
  if (!parameter->names().empty()) return read_named(node, *parameter);
  return read_object(node, [parameter](ObjectReader& in) {
    const VariableKind kind = parameter->whole ? VariableKind::integer : VariableKind::continuous;
    return ParameterVariable{.parameter = parameter, .range = read_range(in, rule_of(*parameter), kind)};
  });
}

// Two variables that set the same: which of them would count?
void require_compatible(const Node& node, const StudyVariable& one, const StudyVariable& other) {
  if (std::holds_alternative<LayoutVariable>(one) && std::holds_alternative<LayoutVariable>(other))
    throw node.error_without_value(
        fmt::format("must not vary beside \"{}\": give whole rows, as values of \"layout\" ({{\"layout\": [...], "
                    "\"polarity\": [...]}})",
                    name_of(one)));
  const auto* first = std::get_if<ParameterVariable>(&one);
  const auto* second = std::get_if<ParameterVariable>(&other);
  if (first == nullptr || second == nullptr) return;
  if (const auto conflict = conflict_between(*second->parameter, *first->parameter))
    throw node.error_without_value(*conflict);
}

std::vector<StudyVariable> read_variables(const Node& node, const std::vector<BlockVariable>& of_blocks) {
  node.expect_object();
  std::vector<StudyVariable> variables;
  for (const std::string& name : node.keys()) {
    variables.push_back(read_variable(*node.find(name), name, of_blocks));
    for (std::size_t i = 0; i + 1 < variables.size(); ++i)
      require_compatible(*node.find(name), variables[i], variables.back());
  }
  if (variables.empty()) throw node.error_without_value("needs at least one variable");
  return variables;
}

SearchOptions read_search(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    SearchOptions options;
    if (const auto algorithm = in.find("algorithm")) {
      try {
        options.algorithm = algorithm_named(algorithm->text());
      } catch (const std::invalid_argument& mistake) {
        throw algorithm->error_without_value(mistake.what());
      }
    }
    options.max_evaluations = static_cast<std::size_t>(in.integer_or<std::int64_t>(
        "max_evaluations", static_cast<std::int64_t>(options.max_evaluations), Rule::between(1, 1e9)));
    options.seed = static_cast<std::uint64_t>(in.integer_or<std::int64_t>("seed", 1, non_negative));
    return options;
  });
}

actuator::Design read_base(const Node& node, const actuator::EffectCatalogue& effects, const InputText* text) {
  std::error_code error;
  if (text == nullptr && !std::filesystem::exists(node.path(), error))
    throw node.error(fmt::format("must name the file of an actuator, and there is no {}", node.path().string()));
  ActuatorFile file =
      text != nullptr ? parse_actuator(text->text, text->file, effects) : read_actuator(node.path(), effects);
  if (!std::holds_alternative<actuator::Design>(file.content))
    throw node.error("must be a design (actuator/1): a lumped model has no geometry to vary");
  return std::get<actuator::Design>(std::move(file.content));
}

// A correction was fitted to the motions of one finger.
void require_corrected_geometry(const Study& study, const Node& actuator) {
  if (!study.base.as_built.torque_correction) return;
  for (const StudyVariable& variable : study.variables) {
    // Neither the current nor what stands beside the finger changes it.
    if (std::holds_alternative<CurrentVariable>(variable) || std::holds_alternative<SettingVariable>(variable))
      continue;
    const auto* number = std::get_if<ParameterVariable>(&variable);
    if (number != nullptr && number->parameter->section == "surroundings") continue;
    throw actuator.error_without_value(fmt::format(
        "has a nameless torque correction, which holds for the finger that was measured alone: {} must not vary",
        name_of(variable)));
  }
}

bool varies_current(const Study& study) {
  return std::ranges::any_of(study.variables,
                             [](const StudyVariable& v) { return std::holds_alternative<CurrentVariable>(v); });
}

// The current that the crawler's cell drives, with the duty of its pulses.
void read_driven(ObjectReader& in, const Blocks& blocks, Study& study) {
  in.literal("current_of", "crawler");
  const auto crawler = blocks.find("crawler");
  if (crawler == blocks.end())
    throw in.at("current_of").error_without_value("needs the block \"crawler\" in the study");
  if (const auto duty = in.find("duty")) throw duty->error_without_value("is the crawler's, with its current");
  study.current = crawler->second.driven;
}

void read_operation(const Node& node, const Blocks& blocks, Study& study) {
  ObjectReader in(node);
  read_operating_conditions(in, study.operating);
  if (varies_current(study)) {
    for (const std::string_view key : {"current_A", "share_of_current_limit", "current_of"})
      if (const auto fixed = in.find(key))
        throw fixed->error_without_value("sets the current, which is a variable of this study too");
    in.finish();
    return;
  }
  const std::string key = blocks.contains("crawler") || node.find("current_of")
                              ? in.one_of({"current_A", "share_of_current_limit", "current_of"})
                              : in.one_of({"current_A", "share_of_current_limit"});
  if (key == "current_of") {
    read_driven(in, blocks, study);
  } else if (key == "current_A") {
    study.current = FixedCurrent{in.number("current_A", current_rule())};
  } else {
    study.current = ShareOfLimit{in.number("share_of_current_limit", largest_share)};
  }
  in.finish();
}

// Shares of coils that there are, and that have drivers of their own.
void require_shares_suit(const Study& study, const Node& root) {
  const int coils = coil_count(study.base.layout);
  bool varies_layout = false;
  bool shares = !has_one_current(study.base);
  for (const StudyVariable& variable : study.variables) {
    varies_layout = varies_layout || std::holds_alternative<LayoutVariable>(variable);
    const auto* number = std::get_if<ParameterVariable>(&variable);
    shares = shares || (number != nullptr && number->parameter->rule == actuator::ParameterRule::share);
  }
  for (int i = coils; i < actuator::most_current_shares && !varies_layout; ++i)
    if (const auto variable = root.find("variables")->find(fmt::format("current_share_{}", i + 1)))
      throw variable->error_without_value(fmt::format("must be of a coil that there is: the actuator has {}", coils));
  const auto of_share = std::ranges::find_if(study.variables, [](const StudyVariable& variable) {
    const auto* number = std::get_if<ParameterVariable>(&variable);
    return number != nullptr && number->parameter->rule == actuator::ParameterRule::share;
  });
  if (root.find("driver") && of_share != study.variables.end())
    throw root.find("variables")
        ->find(name_of(*of_share))
        ->error_without_value("would give coils currents of their own, and the driver drives them all alike");
  if (shares && study.operating.supply.wiring == actuator::Wiring::series)
    throw root.find("operating_point")
        ->find("wiring")
        ->error_without_value("must be parallel where coils have shares of the current: in series there is one");
}

// A letter instead of a row that has none would make another actuator of the study's own.
void require_lettered(const Study& study, const Node& variables) {
  const auto configuration = variables.find("configuration");
  if (!configuration) return;
  using enum actuator::Configuration;
  for (const actuator::Configuration each : {A, B, C, D})
    if (actuator::layout_of(each) == study.base.layout) return;
  throw configuration->error_without_value(
      fmt::format("would give up the actuator's own row ({}), which is none of the configurations: let \"layout\" vary "
                  "({{\"values\": [[\"coil\", \"magnet\", \"coil\"], ...]}}), or \"polarity\"",
                  text_of(study.base.layout)));
}

void require_suitable(const Blocks& blocks, const actuator::Design& base, const Node& root) {
  for (const auto& [key, block] : blocks) {
    try {
      block.require_suitable(base);
    } catch (const std::invalid_argument& rule) {
      throw root.find(key)->error_without_value(rule.what());
    }
  }
}

Study read_study_file(const Document& document, const QuantityTable& quantities,
                      const actuator::EffectCatalogue& effects, const StudyChanges& changes,
                      const StudyTexts& texts = {}) {
  return read_object(document.root(), [&](ObjectReader& in) {
    in.literal("format", "study/1");
    Study study;
    study.name = in.text("name");
    (void)in.text_or("description", "");
    const Blocks blocks = read_blocks(in);
    study.variables = read_variables(in.at("variables"), variables_of(blocks));
    // Only a current that varies leaves nothing to say.
    const auto operation = varies_current(study) ? in.find("operating_point") : in.at("operating_point");
    if (operation) read_operation(*operation, blocks, study);
    StudyQuantities wanted{
        .known = with_quantities_of(blocks, quantities), .listed = quantities, .spread = {}, .of_builds = {}};
    if (const auto spread = in.find("spread")) {
      study.spread = read_spread(*spread, variables_of(blocks), texts.posterior);
      if (const auto* driven = std::get_if<DrivenCurrent>(&study.current)) study.spread->driven = *driven;
      wanted.spread.emplace(*study.spread);
    }
    study.objectives = read_objectives(in.at("objectives"), wanted);
    if (const auto limits = in.find("constraints")) study.limits = read_limits(*limits, wanted);
    if (const auto columns = in.find("columns")) read_columns(*columns, wanted);
    study.quantities = wanted.listed;
    if (!operation || !operation->find("cases")) study.operating.cases = poses_of_use(study);
    if (const auto search = in.find("search")) study.search = read_search(*search);
    study.base = changed(read_base(in.at("actuator"), effects, texts.actuator), study, changes);
    if (study.spread) require_suits(*in.find("spread"), *study.spread, study.base, variables_of(blocks));
    for (StudyVariable& variable : study.variables)
      if (name_of(variable) == "polarity")
        variable = read_polarities(*in.at("variables").find("polarity"), study.base.layout);
    require_lettered(study, in.at("variables"));
    require_corrected_geometry(study, in.at("actuator"));
    require_suitable(blocks, study.base, in.node());
    require_shares_suit(study, in.node());
    return study;
  });
}

}  // namespace

sizing::Study read_study(const std::filesystem::path& path, const QuantityTable& quantities,
                         const actuator::EffectCatalogue& effects, const StudyChanges& changes) {
  return read_study_file(changed(read_json(path), changes), quantities, effects, changes);
}

sizing::Study parse_study(std::string_view text, std::string file, const QuantityTable& quantities,
                          const actuator::EffectCatalogue& effects, const StudyChanges& changes) {
  return parse_study_file(text, std::move(file), changes, quantities, effects).study;
}

StudyFile parse_study_file(std::string_view text, std::string file, const StudyChanges& changes,
                           const QuantityTable& quantities, const actuator::EffectCatalogue& effects) {
  const Document document = changed(parse_json(text, std::move(file)), changes);
  sizing::Study study = read_study_file(document, quantities, effects, changes);
  const Node root = document.root();
  const auto spread = root.find("spread");
  const auto posterior = spread ? spread->find("posterior") : std::nullopt;
  return {.study = std::move(study),
          .actuator = root.find("actuator")->path(),
          .posterior = posterior ? std::optional(posterior->path()) : std::nullopt,
          .builds_a_system = root.find("gripper") || root.find("crawler")};
}

sizing::Study parse_study(std::string_view text, std::string file, const StudyTexts& texts,
                          const StudyChanges& changes) {
  return read_study_file(changed(parse_json(text, std::move(file)), changes), simulation::standard_quantities(),
                         actuator::standard_effects(), changes, texts);
}

}  // namespace coilwright::formats
