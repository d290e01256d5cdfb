#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <optional>
#include <sstream>

#include "cli/parts/merge/parts.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

// What a table of many has of each; all else stays where it is.
struct DiagnosedSet {
  std::string set;
  std::string verdict;
  std::vector<std::string> effects{};
  std::string folder;
};

text::Node required(const text::Node& node, std::string_view key) {
  if (const std::optional<text::Node> found = node.find(key)) return *found;
  throw node.error_without_value(fmt::format("needs \"{}\"", key));
}

DiagnosedSet diagnosed_set(const PartFolder& part) {
  const text::Document document = document_of(part, "diagnosis.json");
  const text::Document provenance = document_of(part, results::provenance_name);
  const text::Node inputs = required(provenance.root(), "inputs");
  const std::filesystem::path set(required(inputs.elements(text::Length::at_least(1)).front(), "file").text());
  DiagnosedSet out{.set = set.parent_path().string(),
                   .verdict = required(document.root(), "verdict").text(),
                   .folder = part.path.string()};
  for (const text::Node& effect : required(document.root(), "effects").elements())
    out.effects.push_back(required(effect, "id").text());
  return out;
}

text::Json to_json(const DiagnosedSet& set) {
  return text::Json::object(
      {{"set", set.set}, {"verdict", set.verdict}, {"effects", text::Json::list(set.effects)}, {"folder", set.folder}});
}

}  // namespace

ExitCode merge_diagnoses(const MergeOptions& options, const Parts& parts) {
  require_figures_of_parts(parts, this_machine());
  std::vector<DiagnosedSet> sets;
  for_each_part(parts, [&](std::size_t, const PartFolder& part) { sets.push_back(diagnosed_set(part)); });
  std::ostringstream table;
  text::CsvWriter csv(table, {"set", "verdict", "effects", "folder"});
  for (const DiagnosedSet& each : sets) {
    const std::string effects = fmt::format("{}", fmt::join(each.effects, " "));
    csv.row({each.set, each.verdict, effects, each.folder});
  }
  text::OutputFolder folder(options.out);
  folder.write("diagnoses.csv", table.str());
  take_folder(folder, "diagnoses.csv", options.force);
  folder.commit("diagnoses.csv");
  std::cout << (options.json ? text::Json::list(sets, [](const DiagnosedSet& each) { return to_json(each); }).text()
                             : table.str());
  return ExitCode::done;
}

}  // namespace coilwright::cli
