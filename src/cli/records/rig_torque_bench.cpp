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

struct RigTorqueBenchOptions {
  RigOptions rig;
  std::optional<double> axis_offset{};  // mm
  double gauge_distance = 30.0;         // mm
  double current = 1.4;
  std::vector<double> angles{};  // degrees
};

TorqueBench bench_of(const RigTorqueBenchOptions& options, const actuator::Design& design) {
  TorqueBench bench = paper_torque_bench(design);
  if (options.axis_offset) bench.axis_offset = units::to_memory(*options.axis_offset, "axis_offset_mm");
  bench.gauge_distance = units::to_memory(options.gauge_distance, "gauge_distance_mm");
  bench.current = options.current;
  if (!options.angles.empty()) bench.angles = all_to_memory(options.angles, "angles_deg");
  return bench;
}

}  // namespace

void add_torque_bench(CLI::App& command) {
  auto options = std::make_shared<RigTorqueBenchOptions>();
  CLI::App* rig =
      command.add_subcommand("torque-bench", "Torque of one joint's rigid counterpart over its angle (Fig. 17)");
  add_rig_options(*rig, options->rig);
  add_number(*rig, "--axis-offset-mm", options->axis_offset, up_to(1000.0),
             "Distance of the bench's hinge from the coil axis. Default: 2 mm more than the actuator's own, as the\n"
             "paper's 13.5 mm");
  add_number(*rig, "--gauge-distance-mm", options->gauge_distance, up_to(1000.0),
             "Distance from the hinge at which the force gauge holds the joint (default 30)");
  add_number(*rig, "--current-A,--current", options->current, text::Rule::between(-1e6, 1e6),
             "Current in the coil, A; not 0 (default 1.4)");
  add_list(*rig, "--angles-deg", options->angles,
           "A1,A2,..: angles of the joint, 0 to 120. Default: 0 to 82.5 in steps of 7.5",
           text::Rule::between(0.0, 120.0));
  rig->footer(
      "The data set declares the joint on the bench, not the finger: one coil, one magnet, the bench's hinge.\n\n"
      "Example:\n"
      "  coilwright rig torque-bench configs/actuators/paper_finger.json --current-A 0.7 --angles-deg 0,30,60");
  rig->callback([options] {
    run_rig(options->rig, [&](const actuator::Design& design, magnetics::Fidelity fidelity) {
      const TorqueBench bench = bench_of(*options, design);
      const std::vector<TorqueBenchPoint> points = readings(design, bench);
      return RigResult{.text = report::to_text(points, bench),
                       .json = formats::to_json(points, bench),
                       .rig = "torque bench",
                       .runs = {formats::run_of(points, bench, fidelity)},
                       .declared = rigid_counterpart(design, bench.axis_offset)};
    });
  });
}

}  // namespace coilwright::cli
