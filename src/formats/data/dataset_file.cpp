#include "coilwright/formats/data/dataset_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "coilwright/measurement/data/copied_runs.hpp"
#include "coilwright/measurement/data/data_quality.hpp"
#include "coilwright/measurement/data/hold_out.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/text/spelling.hpp"
#include "formats/data/layout_format.hpp"
#include "formats/data/run_entry.hpp"
#include "formats/data/run_words.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::Dataset;
using measurement::data::Run;
using measurement::data::RunKind;

// Far beyond any set that a rig fills, and near enough that a wrong file is refused at once.
constexpr std::size_t most_runs = 10'000;

std::vector<std::string> read_calibrate(ObjectReader& in) {
  const auto node = in.find("calibrate");
  if (!node) return {"joint_stiffness", "joint_damping"};
  std::vector<std::string> names;
  std::set<std::string_view> met;
  for (const Node& element : node->elements()) {
    const std::string& name = element.text();
    if (name != "joint_stiffness" && name != "joint_damping" && !name.starts_with('/'))
      throw element.error(R"(must be "joint_stiffness", "joint_damping" or a JSON pointer into the actuator file)");
    if (!met.insert(name).second) throw element.error("must not be there twice");
    names.push_back(name);
  }
  return names;
}

using measurement::replay::Tolerances;

Tolerances read_tolerances(const Node& node) {
  Tolerances out;
  if (node.kind() != Node::Kind::object) {
    if (node.kind() == Node::Kind::text && node.text() == "exact") return Tolerances::exact();
    throw node.error(R"(must be "exact" or an object)");
  }
  const std::vector<std::string_view> names = measurement::replay::tolerance_names();
  for (const Node& each : node.members()) {
    if (std::ranges::count(names, each.key()) == 0 && !each.key().starts_with('/'))
      throw each.error_without_value(fmt::format(R"(must be called "{}" or by a JSON pointer into the actuator file)",
                                                 fmt::join(names, R"(", ")")));
    out.named.push_back({.name = each.key(), .deviation = each.number(non_negative)});
  }
  return out;
}

std::vector<measurement::identification::Belief> read_beliefs(const Node& node,
                                                              const actuator::EffectCatalogue& effects) {
  std::vector<std::string> known;
  for (const actuator::EffectKind* kind : effects.kinds()) known.emplace_back(kind->id());
  std::vector<measurement::identification::Belief> out;
  for (const Node& each : node.members()) {
    if (std::ranges::find(known, each.key()) == known.end())
      throw each.error_without_value("must be called by the id of an effect (coilwright list effects)" +
                                     did_you_mean(each.key(), known));
    out.push_back({.effect = each.key(), .probability = each.number(Rule::above(0.0).and_also(Rule::below(1.0)))});
  }
  return out;
}

Dataset read_runs(const Node& node, const LayoutEntry& layout, const measurement::data::InputUncertainty& usual,
                  std::vector<std::filesystem::path>& files) {
  std::map<std::filesystem::path, std::filesystem::path> met;
  std::set<std::filesystem::path> input_files;
  std::map<std::string, std::vector<measurement::data::Warning>> warnings;
  std::set<std::string> used;
  std::vector<Run> validate;
  Dataset data;
  for (const Node& element : node.elements(Length::from_to(1, most_runs))) {
    RunInSet entry = read_run_in_set(element, met, layout.layout, usual);
    Run& run = entry.file.run;
    used.merge(entry.file.used);
    warnings.emplace(run.name, std::move(entry.file.warnings));
    if (entry.file.objection) throw InputError(entry.file.objection->error);
    if (entry.input_file) input_files.insert(*entry.input_file);
    if (run.kind == RunKind::still)
      data.still.push_back(std::move(run));
    else
      (entry.validate ? validate : data.fit).push_back(std::move(run));
  }
  for (const auto& [source, place] : layout.named)
    if (!used.contains(source)) throw place.error_without_value("fits no file of the set");
  for (const auto& [real, named] : met) files.push_back(named);
  files.insert(files.end(), input_files.begin(), input_files.end());
  if (data.fit.empty()) throw node.error_without_value("needs at least one fit run");
  data.warnings = measurement::data::copied_runs(data.fit, validate);
  data.validate = measurement::data::SealedRuns(std::move(validate));
  data = measurement::data::with_runs_held_out(std::move(data));
  for (const std::vector<Run>* runs : {&data.fit, &data.still})
    for (const Run& run : *runs) {
      std::ranges::move(warnings.at(run.name), std::back_inserter(data.warnings));
      std::ranges::move(measurement::data::data_quality_warnings(run), std::back_inserter(data.warnings));
    }
  return data;
}

DatasetFile read_document(const Document& document, const actuator::EffectCatalogue& known) {
  return read_object(document.root(), [&](ObjectReader& in) {
    in.literal("format", "measured-data/1");
    DatasetFile out{.file = document.root().file()};
    std::string name = in.name();
    if (const auto actuator = in.find_not_null("actuator")) out.actuator = actuator->path();
    out.calibrate = read_calibrate(in);
    if (const auto tolerances = in.find_not_null("tolerances")) out.tolerances = read_tolerances(*tolerances);
    if (const auto beliefs = in.find_not_null("effect_probabilities")) out.beliefs = read_beliefs(*beliefs, known);
    const LayoutEntry layout = read_layout(in, {});
    const measurement::data::InputUncertainty usual = read_input_uncertainty(in);
    const Node runs = in.at("runs");
    in.finish();
    out.data = read_runs(runs, layout, usual, out.run_files);
    out.data.name = std::move(name);
    return out;
  });
}

}  // namespace

DatasetFile read_dataset(const std::filesystem::path& path, const actuator::EffectCatalogue& known) {
  std::error_code unreadable;
  if (!std::filesystem::is_directory(path, unreadable)) return read_document(read_json(path), known);
  const std::filesystem::path file = path / "dataset.json";
  if (!std::filesystem::exists(file, unreadable))
    throw InputError({.file = path.string(),
                      .rule = "has no dataset.json: coilwright init dataset --from RECORDS makes one of your records"});
  return read_document(read_json(file), known);
}

DatasetFile parse_dataset(std::string_view text, std::string file, const actuator::EffectCatalogue& known) {
  return read_document(parse_json(text, std::move(file)), known);
}

}  // namespace coilwright::formats
