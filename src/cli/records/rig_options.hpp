#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/actuator_input.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/measurement/data/run.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/rule.hpp"

namespace coilwright::cli {

/// What every rig is told.
struct RigOptions {
  ActuatorOptions actuator;
  std::string out;       ///< folder of the data set; empty: none is written
  std::string fidelity;  ///< of the readings in it; empty: the actuator's own
  bool force{false};     ///< whether files of another content are replaced
  bool json{false};
};

/// ACTUATOR.json, --set, --out, --fidelity, --force, --json.
void add_rig_options(CLI::App& rig, RigOptions& options);

/// An option that takes several numbers, parted by commas, each of which keeps the rule.
void add_list(CLI::App& rig, const std::string& name, std::vector<double>& values, const std::string& text,
              const text::Rule& rule);

/// The numbers as memory keeps them, under a name that ends in their unit.
[[nodiscard]] std::vector<double> all_to_memory(const std::vector<double>& values, const char* name);

/// The design of a rig's actuator.
struct RigActuator {
  std::string name;
  actuator::Design design;  ///< can be built
};

/// Throws InputError for a lumped model, which does not say what its parts are, and for a design that cannot be built.
[[nodiscard]] RigActuator read_rig_actuator(const RigOptions& options);

/// What a rig reads: the table or JSON to print, and the data set to write.
struct RigResult {
  std::string text;                            ///< for a person
  text::Json json;                             ///< the same
  std::string rig;                             ///< "torque bench"; ends the name of the data set
  std::vector<measurement::data::Run> runs{};  ///< empty unless a set is asked for
  /// The declared model of the set, where it is not the actuator itself: the joint on a bench.
  std::optional<actuator::Design> declared{};
};

/// Computes with `readings`, prints the result, and writes the data set where one is asked for. A std::invalid_argument
/// of the rig becomes an InputError of the actuator's file, a std::runtime_error names that file.
void run_rig(const RigOptions& options,
             const std::function<RigResult(const actuator::Design& design, magnetics::Fidelity fidelity)>& readings);

}  // namespace coilwright::cli
