#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/front/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/packed_files.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

constexpr std::string_view ending = ".schema.json";

std::vector<std::string> schema_names() {
  std::vector<std::string> names;
  for (const PackedFile& file : schemas()) names.emplace_back(file.name.substr(0, file.name.size() - ending.size()));
  return names;
}

struct SchemaOptions {
  std::string name;
  std::string out;
  bool force{false};
  bool json{false};
};

void run_schema(const SchemaOptions& options) {
  if (options.out.empty()) {
    for (const PackedFile& file : schemas())
      if (file.name == options.name + std::string(ending)) std::cout << file.text;
    return;
  }
  text::OutputFolder folder(options.out);
  for (const PackedFile& file : schemas()) folder.write(file.name, file.text);
  keep_others(folder, options.force);
  folder.commit();
  if (options.json) {
    std::vector<std::filesystem::path> files;
    for (const PackedFile& file : schemas()) files.push_back(folder.path() / file.name);
    std::cout << written_json(files).text();
    return;
  }
  std::cout << fmt::format("{}/{}{}, and the schemas that it refers to\n", printed(folder.path()), options.name,
                           ending);
}

}  // namespace

void add_schema_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<SchemaOptions>();
  const std::vector<std::string> names = schema_names();
  CLI::App* command = add_command(app, "schema");
  command->add_option("NAME", options->name, fmt::format("One of {}", fmt::join(names, ", ")))
      ->required()
      ->check(word_rule(names));
  command->add_option("--out", options->out, "Folder to write all schemas to instead: some refer to others");
  add_force_option(*command, options->force);
  add_written_json_option(*command, options->json);
  command->footer(
      "An editor completes and checks a file whose first key is \"$schema\" with the path of its schema.\n\n"
      "Example:\n"
      "  coilwright schema study --out schemas");
  command->callback([options] { run_schema(*options); });
}

}  // namespace coilwright::cli
