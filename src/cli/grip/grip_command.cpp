#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/commands.hpp"
#include "grip_answer.hpp"
#include "grip_options.hpp"
#include "grip_text.hpp"

namespace coilwright::cli {

void add_grip_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<GripOptions>();
  CLI::App* command = app.add_subcommand("grip", "Close fingers on an object, lift it, and load it until it slips");
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
    require_height_of_shape(*options);
    const GripAnswer answer = answer_of(*options);
    std::cout << (options->json ? as_json(*options, answer) : as_text(*options, answer));
  });
}

}  // namespace coilwright::cli
