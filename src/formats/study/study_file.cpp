#include "coilwright/formats/study/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/simulation/supply.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/study/study_keys.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace sizing;

// A bound far beyond any hardware, and near enough that nothing overflows.
constexpr Rule largest_share = positive.and_also(Rule::at_most(1e3));

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
    study.current = FixedCurrent{in.number("current_A", current_rule)};
  } else {
    study.current = ShareOfLimit{in.number("share_of_current_limit", largest_share)};
  }
  in.finish();
}

// A voltage that is not stated has nothing to scatter about, nor has what a crawler's cell sets anew in each build.
void require_operation_scatters(const Node& spread, const Study& study) {
  if (const auto scatter = spread.find("supply_voltage_V"); scatter && !study.operating.supply.voltage)
    throw scatter->error_without_value("scatters nothing: give operating_point.supply_voltage_V, the voltage meant");
  if (!std::holds_alternative<sizing::DrivenCurrent>(study.current)) return;
  for (const auto& [key, cause] : {std::pair("current_A", "crawler_cell_voltage_V"), std::pair("duty", "crawler_duty")})
    if (const auto scatter = spread.find(key))
      throw scatter->error_without_value(
          fmt::format("scatters nothing: it is what the crawler gives; let {} scatter", cause));
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

// What the supply cannot drive through the warm coils is no operating point. As a limit like any other, results have
// its margin, and say where it binds.
void limit_by_supply(Study& study) {
  if (!study.operating.supply.voltage) return;
  const simulation::ResultQuantity& load = simulation::supply_load();
  const auto own = std::ranges::find_if(study.limits, [&](const Limit& limit) {
    return limit.quantity.name == load.name && limit.side == Limit::Side::at_most;
  });
  if (own == study.limits.end())
    study.limits.push_back({.quantity = load, .value = 1.0});
  else
    own->value = std::min(own->value, 1.0);
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

Study read_study_file(const Document& document, const StudyReading& reading) {
  return read_object(document.root(), [&](ObjectReader& in) {
    in.literal("format", "study/1");
    Study study;
    study.name = in.at("name").name();
    (void)in.text_or("description", "");
    const Blocks blocks = read_blocks(in);
    if (const auto driver = blocks.find("driver"); driver != blocks.end()) study.driver = driver->second.driver;
    study.variables = read_variables(in.at("variables"), variables_of(blocks));
    // Only a current that varies leaves nothing to say.
    const auto operation = varies_current(study) ? in.find("operating_point") : in.at("operating_point");
    if (operation) read_operation(*operation, blocks, study);
    StudyQuantities wanted{.known = with_quantities_of(blocks, reading.quantities),
                           .listed = reading.quantities,
                           .spread = {},
                           .of_builds = {}};
    if (study.operating.supply.voltage) {
      wanted.known = wanted.known.with(simulation::supply_load());
      wanted.listed = wanted.listed.with(simulation::supply_load());
    }
    if (const auto spread = in.find("spread")) {
      study.spread = read_spread(*spread, variables_of(blocks), reading.posterior);
      if (const auto* driven = std::get_if<DrivenCurrent>(&study.current)) study.spread->driven = *driven;
      study.spread->driver = study.driver;
      wanted.spread.emplace(*study.spread);
    }
    study.objectives = read_objectives(in.at("objectives"), wanted);
    if (const auto limits = in.find("constraints")) study.limits = read_limits(*limits, wanted);
    if (const auto columns = in.find("columns")) read_columns(*columns, wanted);
    study.quantities = wanted.listed;
    if (!operation || !operation->find("cases")) study.operating.cases = poses_of_use(study);
    limit_by_supply(study);
    if (const auto search = in.find("search")) study.search = read_search(*search);
    study.base =
        changed(read_base(in.at("actuator"), reading.effects, reading.actuator), study, in.node(), reading.changes);
    if (study.spread) require_operation_scatters(*in.find("spread"), study);
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

sizing::Study read_study(const std::filesystem::path& path, const StudyReading& reading) {
  return read_study_file(changed(read_json(path), reading.changes), reading);
}

sizing::Study parse_study(std::string_view text, std::string file, const StudyReading& reading) {
  return read_study_file(changed(parse_json(text, std::move(file)), reading.changes), reading);
}

StudyFile parse_study_file(std::string_view text, std::string file, const StudyReading& reading) {
  const Document document = changed(parse_json(text, std::move(file)), reading.changes);
  sizing::Study study = read_study_file(document, reading);
  const Node root = document.root();
  const auto spread = root.find("spread");
  const auto posterior = spread ? spread->find("posterior") : std::nullopt;
  return {.study = std::move(study),
          .actuator = root.find("actuator")->path(),
          .posterior = posterior ? std::optional(posterior->path()) : std::nullopt,
          .builds_a_system = std::ranges::any_of(root.keys(), is_block)};
}

void require_objectives(const sizing::Study& study, const ObjectiveCount& count, const std::string& file) {
  const std::size_t given = study.objectives.size();
  if (given < count.least || given > count.most)
    throw InputError(
        {.file = file, .place = "/objectives", .rule = std::string(count.rule), .value = fmt::format("{}", given)});
}

}  // namespace coilwright::formats
