#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"

namespace coilwright::cli {

/// The actuator of a command, and what is changed of it on the command line.
struct ActuatorOptions {
  std::string file;
  std::vector<std::string> assignments;  ///< "gap_mm=1.2"
};

/// What commands that write a data set or a diagnosis call the actuator in their folder.
inline constexpr const char* actuator_name = "actuator.json";

/// The bytes of the file at `path`, to be written as they are. Throws InputError where it cannot be read.
[[nodiscard]] std::string bytes_of(const std::string& path);

/// What an answer rests on that knows no temperature, as a last line of text.
inline constexpr std::string_view cold_note =
    "A design's coils and magnets are taken at 20 degC; warm, its magnets push less (evaluate says by how much).\n";

/// ACTUATOR.json and --set.
void add_actuator_options(CLI::App& command, ActuatorOptions& options);

/// The file with the assignments made. Throws InputError, also for assignments to a lumped model.
[[nodiscard]] formats::ActuatorFile read_actuator(const ActuatorOptions& options);

/// A design and what it assembles to.
struct BuiltDesign {
  actuator::Design design;
  actuator::Assembly assembly;
};

/// The design in `file`, assembled. Throws InputError naming the file where it has a lumped model ("is a lumped model:
/// " and `reason`), or a design that cannot be built.
[[nodiscard]] BuiltDesign built_design(const formats::ActuatorFile& file, const ActuatorOptions& options,
                                       std::string_view reason);

/// A model with what is known of its coils and its supply where it is that of a design.
struct DrivenModel {
  actuator::Model model;
  std::optional<actuator::CoilElectrics> coil{};
  /// Current in every coil that the supply of the file's operating point drives at most, coils at 20 degC, A; nothing
  /// where no voltage is stated.
  std::optional<double> supply_drives{};
};

/// The model in the file of `options`, or of the design in it. Throws as read_actuator() and assemble().
[[nodiscard]] DrivenModel read_driven_model(const ActuatorOptions& options);

/// The model of that alone.
[[nodiscard]] actuator::Model read_model(const ActuatorOptions& options);

/// A design of that file, assembled. Throws InputError naming the file when it cannot be.
[[nodiscard]] actuator::Assembly assemble(const actuator::Design& design, const ActuatorOptions& options);

}  // namespace coilwright::cli
