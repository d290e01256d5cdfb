#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "cli/actuator_input.hpp"
#include "cli/model/commands.hpp"
#include "cli/model/task_options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/control/reach.hpp"
#include "coilwright/exports/controller_header.hpp"
#include "coilwright/formats/simulation/reach_json.hpp"
#include "coilwright/report/simulation/reach_text.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/supply.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::cli {
namespace {

using text::InputError;
using text::Rule;

struct ReachOptions {
  ActuatorOptions actuator;
  double angle{};  // deg
  double from{};   // A
  double lowest{};
  std::optional<double> highest;
  double stiffness_error = 10.0;  // %
  double damping_error = 10.0;
  int pieces = 3;
  std::string out, header;
  bool force{false};
  bool json{false};
};

// Of a design the current that its wire bears, and what its heat is worked out from; nothing where only lumps are
// known.
struct Bearable {
  double ampacity{};  // A
  actuator::Design design;
  actuator::Assembly assembly;

  // In the pose that the current holds: coils and magnets of a finger that is bent further are further apart. A.
  [[nodiscard]] double continuous_while_held(double current) const {
    const actuator::Model& model = assembly.model;
    const mechanics::JointVector straight = mechanics::JointVector::Zero(model.joints());
    const auto pose = simulation::find_equilibrium(model, model.all_coils(current), straight);
    return thermal::current_limits(actuator::heat_network(design, assembly, pose.value_or(straight))).for_good();
  }
};

struct Asked {
  actuator::Model model;
  std::optional<Bearable> bearable;
  std::optional<double> supply_drives{};  // of the file's operating point, coils at 20 degC, A
};

Asked read(const ReachOptions& options) {
  formats::ActuatorFile file = read_actuator(options.actuator);
  if (auto* model = std::get_if<actuator::Model>(&file.content)) return {.model = std::move(*model), .bearable = {}};
  auto [design, assembly] = built_design(file, options.actuator, "it has no design");
  const std::optional<double> drives =
      file.operating_point ? simulation::driven_cold(assembly, file.operating_point->supply) : std::nullopt;
  actuator::Model model = assembly.model;
  const double ampacity = actuator::operating_current_limit(design);
  return {.model = std::move(model),
          .bearable = Bearable{.ampacity = ampacity, .design = std::move(design), .assembly = std::move(assembly)},
          .supply_drives = drives};
}

control::ReachTask task_of(const ReachOptions& options, const Asked& asked) {
  if (!options.highest && !asked.bearable)
    throw InputError(
        {.file = "--highest-current-A", .rule = "is needed: a lumped model does not say what current its coils bear"});
  return {.angle = options.angle * std::numbers::pi / 180.0,
          .start_current = options.from,
          .lowest_current = options.lowest,
          .highest_current = options.highest ? *options.highest : asked.bearable->ampacity,
          .stiffness_error = options.stiffness_error / 100.0,
          .damping_error = options.damping_error / 100.0,
          .pieces = options.pieces};
}

// As simulate --input takes it: at rest under the current before, which the first row has.
void write_profile(std::ostream& stream, const control::CurrentProfile& profile, double end) {
  constexpr double before = -0.01;  // s
  text::CsvWriter csv(stream, {"time_s", "current_A"});
  csv.row(std::array{before, profile.before});
  for (std::size_t i = 0; i < profile.times.size(); ++i) csv.row(std::array{profile.times[i], profile.levels[i]});
  csv.row(std::array{end, profile.last()});
}

// Both files, or none; without `commits` none, and what is in their places is refused as with it.
void write(const ReachOptions& options, const Asked& asked, const control::ProfileQuality& best, double end,
           bool commits) {
  std::optional<text::OutputFile> profile;
  std::optional<text::OutputFile> header;
  if (!options.out.empty()) write_profile(profile.emplace(options.out).stream(), best.profile, end);
  if (!options.header.empty()) header.emplace(options.header).stream() << exports::controller_header(asked.model, best);
  // How each of them begins; the rest of a first line names the profile.
  if (header) keep_other_kind(*header, "coilwright", options.force);
  if (profile) keep_other_kind(*profile, table_mark, options.force);
  if (!commits) return;
  if (profile) profile->withdraw();
  if (header) header->commit();
  if (profile) profile->commit();
}

control::Reach answer(const ReachOptions& options, const Asked& asked, const control::ReachTask& task) {
  try {
    // What is in the places of the files is refused before the search.
    control::ProfileQuality none;
    none.profile = {.times = {0.0}, .levels = {0.0}};
    write(options, asked, none, 0.0, false);
    return control::reach(asked.model, task);
  } catch (const text::OutputError&) {
    throw;
  } catch (const std::invalid_argument& rule) {
    throw InputError({.file = options.actuator.file, .rule = rule.what()});
  } catch (const std::runtime_error& reason) {
    throw InputError({.file = options.actuator.file, .rule = reason.what()});
  }
}

std::string remarks(const control::Reach& reach, const control::ReachTask& task, const Asked& asked) {
  std::string out;
  const auto magnitude = [](double one, double other) { return std::abs(one) < std::abs(other); };
  const double largest = *std::ranges::max_element(control::best_profile(reach).profile.levels, magnitude);
  if (const std::string text = simulation::supply_text(asked.supply_drives, largest); !text.empty())
    out += "MIND: " + text + ".\n";
  const double held = asked.bearable ? asked.bearable->continuous_while_held(reach.current) : 0.0;
  if (asked.bearable && std::abs(reach.current) > held)
    out += fmt::format(
        "{:.3g} A are more than coils and magnets bear for good in that pose ({:.3g} A): hold the angle for a short "
        "time "
        "only.\n",
        reach.current, held);
  if (asked.bearable && task.highest_current > asked.bearable->ampacity)
    out += fmt::format("The wire is rated for {:.3g} A; --highest-current-A allows {:.3g} A.\n",
                       asked.bearable->ampacity, task.highest_current);
  return out;
}

void run_reach(const ReachOptions& options) {
  keep_inputs({options.actuator.file}, {options.out, options.header});
  if (!options.out.empty() &&
      std::filesystem::path(options.out).lexically_normal() == std::filesystem::path(options.header).lexically_normal())
    throw InputError({.file = "--c-header", .rule = "must be another file than that of --out"});
  const Asked asked = read(options);
  const control::ReachTask task = task_of(options, asked);
  const control::Reach reach = answer(options, asked, task);
  const control::ProfileQuality& best = control::best_profile(reach);
  write(options, asked, best, reach.duration, true);
  report_stream(options.out, options.header)
      << (options.json ? formats::to_json(reach).text() : report::to_text(reach, task) + std::string(cold_note));
  std::cerr << remarks(reach, task, asked);
}

}  // namespace

void add_reach_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<ReachOptions>();
  CLI::App* command = add_command(app, "reach");
  add_actuator_options(*command, options->actuator);
  const auto number = [&](const char* name, auto& value, const std::string& text, const Rule& rule) {
    return add_number(*command, name, value, rule, text);
  };
  const Rule current = Rule::between(-1e6, 1e6);
  number("--angle-deg", options->angle, "Bending angle to reach, deg", Rule::between(-360, 360))->required();
  number("--from-A", options->from, with_default("Current in every coil before, A", options->from), current);
  number("--lowest-current-A", options->lowest,
         with_default("Lowest current that the driver gives, A", options->lowest), current);
  number("--highest-current-A", options->highest, "Highest, A; otherwise what the wire bears", current);
  number("--stiffness-error-percent", options->stiffness_error,
         with_default("How far k of the hinges may be off", options->stiffness_error), Rule::between(0, 50));
  number("--damping-error-percent", options->damping_error,
         with_default("How far b may be off", options->damping_error), Rule::between(0, 50));
  add_whole_number(*command, "--pieces", options->pieces, Rule::between(1, 6),
                   with_default("Levels of the searched profile before the last one", options->pieces));
  command->add_option("--out", options->out,
                      "CSV file to write the best profile to, for simulate --input FILE --interval-s 0.002");
  command->add_option("--c-header", options->header,
                      "C99 file to write: that profile and the model, for a microcontroller");
  add_force_option(*command, options->force);
  add_flag(*command, "--json", options->json, "Print JSON (reach/1) instead of a table");
  command->footer(
      "A step makes a finger ring for a second. A profile of a few levels arrives in a seventh of that, without a\n"
      "sensor. Compared are the plain step, the step shaped for the slowest motion (zero vibration, and with zero\n"
      "derivative), and a search over levels and lengths within the driver's currents whose worst finger, of the one\n"
      "as it is and four with k and b off, is the first to stay within 2 %, at an overshoot of 10 % at most. Angles\n"
      "are true ones, without what the actuator declares of a camera.\n\n"
      "Example:\n"
      "  coilwright reach configs/actuators/paper_finger.json --angle-deg 50 --out profile.csv");
  command->callback([options] { run_reach(*options); });
}

}  // namespace coilwright::cli
