#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/export/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/exports/kinds.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using exports::ExportedFile;
using exports::ExportKind;
using exports::ExportSetting;
using text::InputError;

// Bytes of what the files say about where they come from.
constexpr std::size_t longest_name = 80;
constexpr std::size_t longest_origin = 1000;

struct ExportOptions {
  ActuatorOptions actuator;
  std::string kind;
  std::string out;
  std::deque<std::optional<double>> settings;  // one per row of export_settings(), in the unit of its name
  bool incomplete{false};
  bool force{false};
  bool json{false};
};

// "lead_mm" on the command line.
std::string option_name(const ExportSetting& setting) {
  std::string name = fmt::format("--{}", setting.name);
  std::ranges::replace(name, '_', '-');
  return name;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const ExportKind& kind : exports::export_kinds()) names.emplace_back(kind.name);
  return names;
}

std::string list_of_kinds() {
  std::string text = "Kinds:\n";
  for (const ExportKind& kind : exports::export_kinds()) {
    text += fmt::format("  {:<10} {}", kind.name, kind.gives);
    std::vector<std::string> options;
    for (const ExportSetting& setting : exports::export_settings())
      if (std::ranges::count(kind.settings, setting.name) > 0) options.push_back(option_name(setting));
    if (!options.empty()) text += fmt::format(" ({})", fmt::join(options, ", "));
    text += '\n';
  }
  return text;
}

exports::ExportSettings settings_of(const ExportOptions& options, const ExportKind& kind) {
  exports::ExportSettings out;
  for (std::size_t i = 0; i < options.settings.size(); ++i) {
    if (!options.settings[i]) continue;
    const ExportSetting& setting = exports::export_settings()[i];
    if (std::ranges::count(kind.settings, setting.name) == 0)
      throw InputError({.file = option_name(setting), .rule = fmt::format("is no setting of {}", kind.name)});
    out.*setting.value = units::to_memory(*options.settings[i], setting.name);
  }
  return out;
}

exports::Subject subject_of(const ExportOptions& options) {
  formats::ActuatorFile file = read_actuator(options.actuator);
  std::string made_by = fmt::format("coilwright {}: {}", COILWRIGHT_VERSION, options.actuator.file);
  for (const std::string& assignment : options.actuator.assignments) made_by += " --set " + assignment;
  exports::Origin origin{.name = text::one_line(file.name, longest_name),
                         .made_by = text::one_line(made_by, longest_origin)};
  if (auto* model = std::get_if<actuator::Model>(&file.content))
    return exports::ModelSubject{.origin = std::move(origin), .model = std::move(*model)};
  auto& design = std::get<actuator::Design>(file.content);
  actuator::Assembly assembly = assemble(design, options.actuator);
  return exports::DesignSubject{.origin = std::move(origin),
                                .design = std::move(design),
                                .assembly = std::move(assembly),
                                .operating_point = file.operating_point};
}

std::vector<ExportedFile> files_of(const ExportOptions& options, const ExportKind& kind) {
  const exports::ExportSettings settings = settings_of(options, kind);
  const exports::Subject subject = subject_of(options);
  try {
    return exports::export_files(kind, subject, settings);
  } catch (const std::invalid_argument& rule) {
    throw InputError({.file = options.actuator.file, .rule = rule.what()});
  }
}

void run_export(const ExportOptions& options) {
  const ExportKind& kind = *exports::find_export_kind(options.kind);
  const std::vector<ExportedFile> files = files_of(options, kind);
  for (const ExportedFile& file : files)
    if (!file.too_much.empty() && !options.incomplete)
      throw InputError({.file = options.actuator.file,
                        .rule = file.too_much + "; --incomplete writes what would move otherwise all the same"});
  const std::filesystem::path out(options.out);
  std::vector<std::filesystem::path> outputs;
  for (const ExportedFile& file : files) outputs.push_back(out / file.name);
  keep_inputs({options.actuator.file}, outputs);
  text::OutputFolder folder(out.has_filename() ? out : out.parent_path());
  for (const ExportedFile& file : files) folder.write(file.name, file.text);
  keep_others(folder, options.force);
  folder.commit();
  if (options.json) {
    text::Json left_out = text::Json::array();
    for (const ExportedFile& file : files)
      for (const std::string& line : file.left_out)
        left_out.add(text::Json::object({{"file", file.name}, {"what", line}}));
    std::cout << written_json(outputs).set("use", kind.use).set("left_out", std::move(left_out)).text();
    return;
  }
  for (const std::filesystem::path& output : outputs) std::cout << printed(output) << '\n';
  std::cout << kind.use << '\n';
  for (const ExportedFile& file : files)
    for (const std::string& line : file.left_out) std::cerr << file.name << " leaves out " << line << ".\n";
}

}  // namespace

void add_export_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = add_command(app, "export");
  add_actuator_options(*command, options->actuator);
  command
      ->add_option("--as", options->kind,
                   fmt::format("Kind of export, see below. One of {}", fmt::join(kind_names(), ", ")))
      ->required()
      ->check(word_rule(kind_names()));
  command->add_option("--out", options->out, "Folder for the files; it is created if it does not exist")
      ->required()
      ->check(not_empty());
  add_flag(*command, "--incomplete", options->incomplete,
           "Write a model also where forces between parts that are not neighbours, which it cannot have, are more "
           "than a twentieth of those between neighbours; effects that it cannot have are told in any case");
  for (const ExportSetting& setting : exports::export_settings())
    add_number(*command, option_name(setting), options->settings.emplace_back(),
               text::Rule::between(setting.lowest, setting.highest), std::string(setting.text));
  add_force_option(*command, options->force);
  add_written_json_option(*command, options->json);
  command->footer(list_of_kinds() +
                  "\nExample:\n"
                  "  coilwright export configs/actuators/finger.json --as workshop --out results/workshop");
  command->callback([options] { run_export(*options); });
}

}  // namespace coilwright::cli
