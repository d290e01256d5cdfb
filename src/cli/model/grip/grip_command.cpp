#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "cli/actuator_input.hpp"
#include "cli/model/commands.hpp"
#include "cli/model/grip/grip_options.hpp"
#include "coilwright/formats/systems/grip_json.hpp"
#include "coilwright/report/systems/grip_text.hpp"
#include "coilwright/systems/gripper/grip_task.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

using systems::gripper::GripAnswer;
using systems::gripper::Gripper;

// Runs `call`; a rule that it finds broken is reported at `place`.
template <class Call>
auto at_place(const std::string& place, const Call& call) {
  try {
    return call();
  } catch (const systems::gripper::NoRoom& none) {
    throw text::InputError(
        {.file = place,
         .rule = fmt::format("{}; --spacing-mm, --mounting-angle-deg and --open-current-A make room", none.what())});
  } catch (const std::invalid_argument& rule) {
    // How the fingers hang is said on the command line, all else of them in their file.
    const std::string text = rule.what();
    const bool of_mounting = text.starts_with("mounting.");
    throw text::InputError(
        {.file = of_mounting ? "--mounting-angle-deg, --spacing-mm, --fingers, --polarity" : place, .rule = text});
  }
}

// Closes the gripper on the object, lifts and loads it. Throws InputError naming the file or the options whose rule is
// broken.
GripAnswer answer_of(const GripOptions& options) {
  const systems::gripper::GripperTask& task = options.task;
  check(task);
  formats::ActuatorFile file = read_actuator(options.actuator);
  const actuator::Design design = built_design(file, options.actuator, "a gripper needs a design (actuator/1)").design;
  (void)at_place(options.actuator.file, [&] { return Gripper(design, task.mounting); });
  return at_place("--shape, --width-mm, --centre-x-mm, --centre-below-palm-mm", [&] {
    return systems::gripper::grip(design, task, options.current, file.operating_point, options.most_friction);
  });
}

}  // namespace

void add_grip_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<GripOptions>();
  CLI::App* command = add_command(app, "grip");
  add_grip_options(*command, *options);
  command->footer(
      "Two like fingers hang from a palm, mirrored, and close in one plane; more stand evenly round the\n"
      "gripper's axis and all do the same. The object stands on a smooth support until they hold it; the support\n"
      "is then taken away, the load put on within 0.3 s and held for 0.2 s. It slips where it sinks at 20 mm/s under "
      "a\n"
      "load that grows on; a ball that turns between the fingers on its way there is carried by up to 2 % more than\n"
      "what they hold at rest. Fingers hang at the mounting angle: the base tilt of their file is not used.\n\n"
      "Example:\n"
      "  coilwright grip configs/actuators/paper_finger.json --width-mm 60 --mass-g 40 --friction 0.8");
  command->callback([options] {
    const GripAnswer answer = answer_of(*options);
    std::cout << (options->json ? formats::to_json(answer).text() : report::to_text(answer));
  });
}

}  // namespace coilwright::cli
