#include "cli/actuator_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <new>
#include <system_error>
#include <utility>
#include <variant>

#include "cli/options.hpp"
#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/simulation/supply.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::cli {

std::string bytes_of(const std::string& path) {
  return text::read_text(path, text::json_size_limit).text;
}

void add_actuator_options(CLI::App& command, ActuatorOptions& options) {
  command
      .add_option("ACTUATOR.json", options.file, "File of a design (actuator/1) or of a lumped model (lumped-model/1)")
      ->required();
  command
      .add_option("--set", options.assignments,
                  "NAME=VALUE: change one number of the design, for example gap_mm=1.2, or the "
                  "configuration (configuration=C); may be repeated")
      ->allow_extra_args(false);
}

formats::ActuatorFile read_actuator(const ActuatorOptions& options) {
  // What size, diagnose and pick write is named by its folder as readily as by its file.
  std::error_code none;
  const std::filesystem::path inside = std::filesystem::path(options.file) / actuator_name;
  if (std::filesystem::is_directory(options.file, none) && std::filesystem::is_regular_file(inside, none))
    throw text::InputError(
        {.file = options.file, .rule = fmt::format("must be a file, and is a folder; is {} meant?", inside.string())});
  formats::ActuatorFile file = formats::read_actuator(options.file);
  if (options.assignments.empty()) return file;
  actuator::Design design = formats::design_of(file, options.file, "--set changes designs only");
  require_names_once(options.assignments);
  for (const std::string& assignment : options.assignments)
    design = formats::with_assignment(std::move(design), assignment);
  file.content = std::move(design);
  return file;
}

BuiltDesign built_design(const formats::ActuatorFile& file, const ActuatorOptions& options, std::string_view reason) {
  const actuator::Design& design = formats::design_of(file, options.file, reason);
  return {.design = design, .assembly = assemble(design, options)};
}

DrivenModel read_driven_model(const ActuatorOptions& options) {
  formats::ActuatorFile file = read_actuator(options);
  if (auto* model = std::get_if<actuator::Model>(&file.content)) return {.model = std::move(*model)};
  actuator::Assembly assembly = assemble(std::get<actuator::Design>(file.content), options);
  const std::optional<double> drives =
      file.operating_point ? simulation::driven_cold(assembly, file.operating_point->supply) : std::nullopt;
  return {.model = std::move(assembly.model), .coil = assembly.coil, .supply_drives = drives};
}

actuator::Model read_model(const ActuatorOptions& options) {
  return read_driven_model(options).model;
}

actuator::Assembly assemble(const actuator::Design& design, const ActuatorOptions& options) {
  const std::string changes =
      options.assignments.empty() ? "" : fmt::format(" (with {})", fmt::join(options.assignments, ", "));
  try {
    return actuator::assemble_or_throw(design);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& reason) {
    throw text::InputError({.file = options.file, .rule = reason.what() + changes});
  }
}

}  // namespace coilwright::cli
