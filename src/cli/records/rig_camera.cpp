#include <CLI/CLI.hpp>
#include <memory>

#include "cli/options.hpp"
#include "cli/records/commands.hpp"
#include "cli/records/rig_options.hpp"
#include "coilwright/formats/data/rig_results.hpp"
#include "coilwright/report/systems/rig_text.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using namespace systems::rig;

struct RigCameraOptions {
  RigOptions rig;
  std::vector<double> steps{};        // A
  std::vector<double> frequencies{};  // Hz
  std::string only;                   // "steps", "sines"
  double amplitude = 0.7;             // A
  double offset = 0.7;                // A
  double frame_rate = 2000.0;         // Hz
  double duration = 2.0;              // s
  double sigma = 0.3;                 // degrees
};

Camera camera_of(const RigCameraOptions& options) {
  Camera camera;
  if (!options.steps.empty()) camera.steps = options.steps;
  if (!options.frequencies.empty()) camera.frequencies = options.frequencies;
  if (options.only == "steps") camera.frequencies.clear();
  if (options.only == "sines") camera.steps.clear();
  camera.amplitude = options.amplitude;
  camera.offset = options.offset;
  camera.frame_rate = options.frame_rate;
  camera.step_duration = options.duration;
  return camera;
}

}  // namespace

void add_camera(CLI::App& command) {
  auto options = std::make_shared<RigCameraOptions>();
  const text::Rule up_to_a_million = text::positive.and_also(text::Rule::at_most(1e6));
  const text::Rule current = text::Rule::between(-1e6, 1e6);
  CLI::App* rig =
      command.add_subcommand("camera", "Bending angle under steps and sines of the current (Figs 12 to 14)");
  add_rig_options(*rig, options->rig);
  add_list(*rig, "--steps-A,--steps", options->steps,
           "I1,I2,..: currents in every coil after the step, A. Default: 0.35,0.7,1.05,1.4", current);
  add_list(*rig, "--frequencies-Hz", options->frequencies,
           "F1,F2,..: frequencies of the sines, at most a tenth of the frame rate. Default: 0.5,1,2,10",
           up_to_a_million);
  add_word(*rig, "--only", options->only, {"steps", "sines"}, "Film the steps or the sines alone: steps or sines");
  add_number(*rig, "--amplitude-A,--amplitude", options->amplitude, current,
             "Amplitude of the sines, A (default 0.7, as the paper's (23))");
  add_number(*rig, "--offset-A,--offset", options->offset, current, "Mean current of the sines, A (default 0.7)");
  add_number(*rig, "--frame-rate-Hz", options->frame_rate, up_to_a_million, "Frames a second (default 2000)");
  add_number(*rig, "--duration-s", options->duration, text::Rule::above(0.1).and_also(text::Rule::at_most(1e6)),
             "Duration of a record of a step, which comes after 0.1 s (default 2); a sine's has two periods and at\n"
             "least 1 s");
  add_number(*rig, "--sigma-deg", options->sigma, text::Rule::between(1e-6, 1e6),
             "Standard deviation of the camera's noise that the data set states; the readings have none (default "
             "0.3)");
  rig->footer(
      "A step starts at rest without current, a sine at rest under its first current. With measured readings in the\n"
      "data set, remove its \"sigma\": the noise is then estimated from the records.\n\n"
      "Example:\n"
      "  coilwright rig camera configs/actuators/paper_finger.json --only sines --frequencies-Hz 3,5,7");
  rig->callback([options] {
    run_rig(options->rig, [&](const actuator::Design& design, magnetics::Fidelity fidelity) {
      const Camera camera = camera_of(*options);
      const std::vector<CameraRecord> records = readings(design, camera);
      RigResult result{
          .text = report::to_text(records, camera), .json = formats::to_json(records, camera), .rig = "camera"};
      for (const CameraRecord& record : records)
        result.runs.push_back(formats::run_of(record, fidelity, units::to_memory(options->sigma, "sigma_deg")));
      return result;
    });
  });
}

}  // namespace coilwright::cli
