#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "cli/options.hpp"
#include "cli/records/commands.hpp"
#include "cli/records/rig_options.hpp"
#include "coilwright/formats/data/rig_results.hpp"
#include "coilwright/report/systems/rig_text.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using namespace systems::rig;

struct RigStiffnessGaugeOptions {
  RigOptions rig;
  std::vector<double> angles{};          // degrees
  std::optional<int> joint{};            // from 1
  std::optional<double> gauge_height{};  // mm
};

StiffnessGauge gauge_of(const RigStiffnessGaugeOptions& options) {
  StiffnessGauge gauge = paper_stiffness_gauge();
  if (!options.angles.empty()) gauge.angles = all_to_memory(options.angles, "angles_deg");
  if (options.joint) gauge.joint = *options.joint - 1;
  if (options.gauge_height) gauge.height = units::to_memory(*options.gauge_height, "gauge_height_mm");
  return gauge;
}

}  // namespace

void add_stiffness_gauge(CLI::App& command) {
  auto options = std::make_shared<RigStiffnessGaugeOptions>();
  CLI::App* rig = command.add_subcommand(
      "stiffness-gauge", "Force that holds a joint open without current, and its stiffness (Figs 10b, 11)");
  add_rig_options(*rig, options->rig);
  add_list(*rig, "--angles-deg", options->angles,
           "A1,A2,..: angles of the joint, above 0 to 120. Default: 15 to 90 in steps of 15", up_to(120.0));
  add_whole_number(*rig, "--joint", options->joint, text::Rule::between(1, 16),
                   "Joint that is held open, from 1 at the base; all others are straight. Default: the last");
  add_number(*rig, "--gauge-height-mm", options->gauge_height, up_to(1000.0),
             "Where on the last segment the gauge presses, from that segment's joint. Default: its tip");
  rig->footer(
      "The data set has the torque of the hinge alone, as `diagnose` takes a joint_stiffness run: of a measured force, "
      "take\n"
      "the weight off before, or measure with the plane of bending level.\n\n"
      "Example:\n"
      "  coilwright rig stiffness-gauge configs/actuators/paper_finger.json --gauge-height-mm 15");
  rig->callback([options] {
    run_rig(options->rig, [&](const actuator::Design& design, magnetics::Fidelity) {
      const StiffnessReadings all = readings(design, gauge_of(*options));
      RigResult result{.text = report::to_text(all), .json = formats::to_json(all), .rig = "stiffness gauge"};
      // Joints that differ can be read, but not be told of in a set.
      if (!options->rig.out.empty()) result.runs = {formats::run_of(all)};
      return result;
    });
  });
}

}  // namespace coilwright::cli
