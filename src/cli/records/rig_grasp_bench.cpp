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

struct RigGraspBenchOptions {
  RigOptions rig;
  std::vector<double> currents{};        // A
  double grasp_opening{};                // degrees
  std::optional<double> grasp_height{};  // mm
};

GraspBench bench_of(const RigGraspBenchOptions& options) {
  GraspBench bench;
  if (!options.currents.empty()) bench.currents = options.currents;
  bench.grasp.opening = units::to_memory(options.grasp_opening, "grasp_opening_deg");
  if (options.grasp_height) bench.grasp.height = units::to_memory(*options.grasp_height, "grasp_height_mm");
  return bench;
}

}  // namespace

void add_grasp_bench(CLI::App& command) {
  auto options = std::make_shared<RigGraspBenchOptions>();
  CLI::App* rig = command.add_subcommand("grasp-bench", "Force of the finger on a wall over the current (Fig. 9b)");
  add_rig_options(*rig, options->rig);
  add_list(*rig, "--currents-A,--currents", options->currents,
           "I1,I2,..: currents in every coil, A. Default: 0,0.35,0.7,1.05,1.4", text::Rule::between(-1e6, 1e6));
  add_number(*rig, "--grasp-opening-deg", options->grasp_opening, text::Rule::between(0.0, 360.0),
             "Bending angle at which the free actuator would just touch the wall (default 0: the straight actuator\n"
             "touches it)");
  add_number(*rig, "--grasp-height-mm", options->grasp_height, text::Rule::between(0.0, 1e6),
             "Where on the last segment it touches the wall, from that segment's joint. Default: the tip");
  rig->footer(
      "Example:\n"
      "  coilwright rig grasp-bench configs/actuators/paper_finger.json --currents-A 0.7,1.4 --grasp-opening-deg 30");
  rig->callback([options] {
    run_rig(options->rig, [&](const actuator::Design& design, magnetics::Fidelity fidelity) {
      const GraspBench bench = bench_of(*options);
      const std::vector<GraspBenchPoint> points = readings(design, bench);
      return RigResult{.text = report::to_text(points, bench),
                       .json = formats::to_json(points, bench),
                       .rig = "grasp bench",
                       .runs = {formats::run_of(points, bench, fidelity)}};
    });
  });
}

}  // namespace coilwright::cli
