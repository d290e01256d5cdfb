#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "cli/search/commands.hpp"
#include "cli/search/list/listings.hpp"

namespace coilwright::cli {
namespace {

struct Choice {
  std::string_view word;
  Listing (*listing)();
  std::string_view note;  // what a person should know of the table; not in the JSON
};

constexpr std::array choices = {
    Choice{"quantities", quantity_listing,
           "evaluate prints those of evaluate; a study may ask for all, for those of gripper and crawler with that "
           "block."},
    Choice{"parameters", parameter_listing,
           "Names for --set and for the variables of a study; in_file is the place in an actuator's file."},
    Choice{"effects", effect_listing, "Names for \"effects\" of an actuator's file and for twin --effect."},
    Choice{"gauges", gauge_listing,
           "Current of one wire in free air (chassis wiring) and by a law through it; a coil runs hotter: evaluate."},
    Choice{"magnets", magnet_listing, "Sintered NdFeB at 20 degC, as makers' tables give it."},
    Choice{"silicones", silicone_listing,
           "Of a name: 12/7 of its maker's stress at 100 %, 1.5 to 3.6 times what tensile tests of castings have.\n"
           "Of Shore A: by Gent's relation, 30 % below to 30 % above those of a name; of Shore 00: by Hertz, within a "
           "factor of 2.2.\n"
           "Measure joint_stiffness_Nmm_rad where it matters."},
    Choice{"spreads", spread_listing,
           "Standard deviations of one build about its design: what \"parts\": \"usual\" (cast in printed moulds) or "
           "\"by_hand\" of a study's spread takes; each_..: of one joint or magnet, drawn where the spread names it."},
    Choice{
        "widths", width_listing,
        "How far a number is known that was not measured on the actuator: at these values evaluate and size look at a "
        "design\nbeside its own, unless it is stated or measured. Without ends: as its source says."},
};

std::vector<std::string> words() {
  std::vector<std::string> all;
  for (const Choice& choice : choices) all.emplace_back(choice.word);
  return all;
}

struct ListOptions {
  std::string what;
  bool json = false;
};

void run_list(const ListOptions& options) {
  for (const Choice& choice : choices) {
    if (choice.word != options.what) continue;
    const Listing listing = choice.listing();
    if (options.json) {
      std::cout << to_json(listing).text();
    } else {
      std::cout << to_text(listing) << choice.note << '\n';
    }
  }
}

}  // namespace

void add_list_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* command = add_command(app, "list");
  command
      ->add_option("WHAT", options->what,
                   "One of quantities, parameters, effects, gauges, magnets, silicones, spreads, widths")
      ->required()
      ->check(word_rule(words()));
  add_json_option(*command, options->json);
  command->footer("Example:\n  coilwright list quantities");
  command->callback([options] { run_list(*options); });
}

}  // namespace coilwright::cli
