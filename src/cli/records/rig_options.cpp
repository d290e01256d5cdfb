#include "cli/records/rig_options.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

std::filesystem::path folder_of(const RigOptions& options) {
  const std::filesystem::path out(options.out);
  return out.has_filename() ? out : out.parent_path();
}

// The file itself where the set declares it unchanged.
std::string declared_text(const RigOptions& options, const RigActuator& actuator, const RigResult& result) {
  if (result.declared)
    return formats::to_json(*result.declared, fmt::format("{}, one joint on the {}", actuator.name, result.rig)).text();
  if (options.actuator.assignments.empty()) return bytes_of(options.actuator.file);
  return formats::to_json(actuator.design, actuator.name).text();
}

void write(const RigOptions& options, const RigActuator& actuator, const RigResult& result) {
  text::OutputFolder folder(folder_of(options));
  std::vector<formats::RunWithRole> in_roles;
  for (const measurement::data::Run& run : result.runs) {
    in_roles.push_back({.run = run, .validate = false});
    formats::write_run(folder.open(run.name), run);
  }
  const std::string name = fmt::format("{}, {}", actuator.name, result.rig);
  folder.write("dataset.json", formats::dataset_json(name, actuator_name, in_roles).text());
  folder.write(actuator_name, declared_text(options, actuator, result));
  take_folder(folder, "dataset.json", options.force);
  keep_other_provenance(folder.path(), options.force);
  results::write_provenance(folder, {.command = "rig " + result.rig,
                                     .inputs = {results::record_of(options.actuator.file)},
                                     .changes = options.actuator.assignments});
  folder.commit("dataset.json");
}

magnetics::Fidelity fidelity_of(const RigOptions& options, const actuator::Design& design) {
  if (options.fidelity.empty()) return design.choices.torque;
  return options.fidelity == "exact" ? magnetics::Fidelity::exact : magnetics::Fidelity::line_of_centres;
}

}  // namespace

void add_rig_options(CLI::App& rig, RigOptions& options) {
  add_actuator_options(rig, options.actuator);
  rig.get_option("ACTUATOR.json")->description("File of a design (actuator/1)")->check(file_rule());
  rig.add_option("--out", options.out,
                 "Folder for a data set (measured-data/1) of the readings; it is created if it does not exist")
      ->check(not_empty());
  add_word(rig, "--fidelity", options.fidelity, {"exact", "line_of_centres"},
           "By which force the readings in the data set are: exact or line_of_centres. Default: as the actuator "
           "says");
  add_force_option(rig, options.force);
  add_json_option(rig, options.json);
}

void add_list(CLI::App& rig, const std::string& name, std::vector<double>& values, const std::string& text,
              const text::Rule& rule) {
  rig.add_option(name, values, text)->delimiter(',')->allow_extra_args(false)->check(number_rule(rule));
}

std::vector<double> all_to_memory(const std::vector<double>& values, const char* name) {
  std::vector<double> out;
  for (const double value : values) out.push_back(units::to_memory(value, name));
  return out;
}

RigActuator read_rig_actuator(const RigOptions& options) {
  formats::ActuatorFile file = read_actuator(options.actuator);
  std::string name = file.name.empty() ? "actuator" : file.name;
  return {.name = std::move(name),
          .design = built_design(std::move(file), options.actuator,
                                 "a rig takes a design (actuator/1), whose parts are known")
                        .design};
}

void run_rig(const RigOptions& options,
             const std::function<RigResult(const actuator::Design& design, magnetics::Fidelity fidelity)>& readings) {
  std::optional<text::OutputFolder> trial;
  if (!options.out.empty()) {
    std::vector<std::filesystem::path> outputs = run_files_in(folder_of(options));
    outputs.push_back(folder_of(options) / "dataset.json");
    keep_inputs({options.actuator.file}, outputs);
    trial.emplace(folder_of(options));
  }
  const RigActuator actuator = read_rig_actuator(options);
  const RigResult result = [&] {
    try {
      return readings(actuator.design, fidelity_of(options, actuator.design));
    } catch (const std::invalid_argument& mistake) {
      throw text::InputError({.file = options.actuator.file, .rule = mistake.what()});
    } catch (const std::runtime_error& reason) {
      throw std::runtime_error(fmt::format("{}: {}", options.actuator.file, reason.what()));
    }
  }();
  if (!options.out.empty()) write(options, actuator, result);
  std::cout << (options.json ? result.json.text() : result.text);
  if (options.out.empty() || options.json) return;
  std::cout << fmt::format("{} {} in {}; put measured columns in place of the predicted ones, and diagnose it\n",
                           result.runs.size(), result.runs.size() == 1 ? "run" : "runs", printed(folder_of(options)));
}

}  // namespace coilwright::cli
