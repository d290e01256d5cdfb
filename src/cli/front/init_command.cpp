#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/front/init_command.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/packed_files.hpp"
#include "cli/programs.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;
using text::Json;

constexpr std::string_view actuator_file = "actuator.json";

struct Start {
  std::string_view word;
  std::vector<std::string_view> files;
  std::string_view next;  // the command to run in that folder
};

std::vector<Start> kinds_of_start() {
  return {{.word = "study", .files = {"study.json", actuator_file}, .next = "coilwright size study.json --out results"},
          {.word = "actuator", .files = {actuator_file}, .next = "coilwright evaluate actuator.json --current-A 1"},
          {.word = "dataset",
           .files = {"dataset.json", "step_0.7A.csv", "step_1.4A.csv", "sine_2Hz.csv", actuator_file},
           .next = "coilwright diagnose . --out results"}};
}

std::string_view text_of(std::string_view name) {
  const auto files = starts();
  return std::ranges::find(files, name, &PackedFile::name)->text;
}

struct InitOptions {
  std::string what;
  std::string out = ".";
  std::vector<std::string> from;
  bool json = false;
};

// A data set about files that are there: its records are not written.
formats::DatasetDraft draft_of(const InitOptions& options, Start& start, const DraftDataset& draft) {
  if (options.what != "dataset") throw CLI::ValidationError("--from", "is for init dataset only");
  start.files = {"dataset.json", actuator_file};
  const std::vector<fs::path> files(options.from.begin(), options.from.end());
  return draft(files, options.out, std::string(actuator_file));
}

void print_sentences(std::string_view title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  std::cout << title << ":\n";
  for (const std::string& each : sentences) std::cout << "  " << each << '\n';
}

void run_init(const InitOptions& options, const DraftDataset& draft_dataset) {
  const std::vector<Start> kinds = kinds_of_start();
  Start start = *std::ranges::find(kinds, options.what, &Start::word);
  std::optional<formats::DatasetDraft> draft;
  if (!options.from.empty()) draft = draft_of(options, start, draft_dataset);
  const fs::path out = options.out;
  // An actuator that is there is the one that a study or a data set is to be about.
  const bool keeps_actuator = options.what != "actuator" && fs::exists(out / actuator_file);
  const auto is_written = [&](std::string_view name) { return !(keeps_actuator && name == actuator_file); };
  for (const std::string_view name : start.files)
    if (is_written(name) && fs::exists(fs::symlink_status(out / name)))
      throw text::OutputError((out / name).lexically_normal(), "it exists, and init replaces no file",
                              text::OutputError::Stage::preparing);
  text::OutputFolder folder(out);
  for (const std::string_view name : start.files)
    if (is_written(name)) folder.write(name, draft && name != actuator_file ? draft->document.text() : text_of(name));
  folder.commit(start.files.front());
  if (options.json) {
    Json written = Json::array();
    for (const std::string_view name : start.files)
      if (is_written(name)) written.add((out / name).lexically_normal().string());
    Json told = Json::object({{"written", std::move(written)}, {"next", start.next}});
    if (draft) told.set("guessed", Json::list(draft->guessed)).set("to_be_said", Json::list(draft->asked));
    std::cout << told.text();
    return;
  }
  for (const std::string_view name : start.files)
    std::cout << printed((out / name).lexically_normal())
              << (is_written(name) ? "\n" : " was there already, and stays as it is\n");
  if (draft) {
    if (!keeps_actuator) draft->asked.emplace_back("the actuator: actuator.json is an example, change it to yours");
    print_sentences("Guessed, to be checked in dataset.json", draft->guessed);
    print_sentences("To be said by you", draft->asked);
  }
  const std::string there = out.lexically_normal() == "." ? "" : " in " + printed(out.lexically_normal());
  std::cout << fmt::format("Next{}: {}\n", there, start.next);
}

}  // namespace

void add_init(CLI::App& app, const Outcome& outcome, const DraftDataset& draft) {
  auto options = std::make_shared<InitOptions>();
  std::vector<std::string> words;
  for (const Start& start : kinds_of_start()) words.emplace_back(start.word);
  CLI::App* command = add_command(app, "init");
  command->add_option("WHAT", options->what, "One of study, actuator, dataset")->required()->check(word_rule(words));
  command->add_option("--out", options->out, "Folder for the files; it is created if it does not exist (default .)");
  command
      ->add_option("--from", options->from,
                   "Records of yours (CSV) that a data set is to be about: its dataset.json says "
                   "what their columns seem to be")
      ->check(file_rule());
  add_json_option(*command, options->json, "text");
  command->footer(
      "The files run as they are: change them. No file that is there is replaced; an actuator.json that is there is\n"
      "the one that the study or the data set is about. The records of the data set are synthetic: they are the\n"
      "actuator's, with friction in its hinges.\n\n"
      "Examples:\n"
      "  coilwright init study --out my_study\n"
      "  coilwright init dataset --from step.csv sine.csv");
  command->callback([options, &outcome, draft] {
    if (!options->from.empty() && !draft) go_on_in("records", outcome.arguments);
    run_init(*options, draft);
  });
}

}  // namespace coilwright::cli
