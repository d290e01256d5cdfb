#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/model/commands.hpp"
#include "cli/options.hpp"
#include "coilwright/formats/systems/crawl_json.hpp"
#include "coilwright/systems/crawl.hpp"
#include "coilwright/systems/crawl_heat.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

// As on the command line, each in the unit of its name.
struct CrawlOptions {
  ActuatorOptions actuator;
  double friction_forwards{};
  double friction_backwards{};
  double frequency = 10.0;
  double duty = 0.5;
  double cell_voltage = 4.2;
  double cell_capacity = 150.0;
  double cell_limit = 3.0;
  double lead_resistance = 0.12;
  double payload_mass = 23.0;
  double payload_length = 30.0;
  double step = 0.1;
  int settling_periods = 10;
  int periods = 20;
  bool json{false};
};

systems::CrawlerParts parts_of(const CrawlOptions& options) {
  return {.payload = {.mass = options.payload_mass * 1e-3, .length = options.payload_length * 1e-3},
          .cell = {.voltage = options.cell_voltage,
                   .capacity = options.cell_capacity * 3.6,
                   .current_limit = options.cell_limit},
          .friction = {.forwards = options.friction_forwards, .backwards = options.friction_backwards},
          .drive = {.frequency = options.frequency, .duty = options.duty, .lead_resistance = options.lead_resistance}};
}

struct Answer {
  formats::CrawlRows rows;
  systems::Crawl crawl;
  systems::CrawlHeat heat;
};

Answer answer_of(const CrawlOptions& options) {
  const BuiltDesign built =
      built_design(read_actuator(options.actuator), options.actuator, "a crawler needs a design (actuator/1)");
  const systems::Crawler crawler = [&] {
    try {
      return systems::Crawler(built.design, built.assembly, parts_of(options));
    } catch (const std::invalid_argument& rule) {
      throw text::InputError({.file = options.actuator.file, .rule = rule.what()});
    }
  }();
  const systems::Crawl crawl = systems::crawl(
      crawler, {.settling_periods = options.settling_periods, .periods = options.periods, .step = options.step * 1e-3});
  const systems::CrawlHeat heat = systems::heat_of_crawl(built.design, built.assembly, crawler, crawl);
  return {.rows = formats::rows_of(crawler, crawl, heat), .crawl = crawl, .heat = heat};
}

std::string as_table(const formats::CrawlRows& rows) {
  std::string text;
  for (const auto& [key, value] : rows)
    text += fmt::format("{:<30} {:>12}\n", key, value ? fmt::format("{:.5g}", *value) : "never");
  return text;
}

// A part that is at its limit only after the cell is empty is none to speak of.
std::string remarks(const Answer& answer) {
  const double run_time = answer.crawl.run_time;
  const auto sentence = [&](const systems::Bearing& bearing, const char* where) {
    return fmt::format(
        "MIND: {}coils of {:.3g} A rms bring a coil or a magnet to its limit {:.3g} s after a cold start, before the "
        "cell is empty ({:.3g} s); for good they bear {:.3g} A.\n",
        where, answer.heat.rms_current, *bearing.until, run_time, bearing.for_good);
  };
  if (answer.heat.taken.until && *answer.heat.taken.until < run_time) return sentence(answer.heat.taken, "");
  if (answer.heat.still_air.until && *answer.heat.still_air.until < run_time)
    return sentence(answer.heat.still_air, "in air that stands still, ");
  return {};
}

void run_crawl(const CrawlOptions& options) {
  const Answer answer = answer_of(options);
  std::cout << (options.json ? formats::to_json(answer.rows).text() : as_table(answer.rows));
  std::cerr << remarks(answer);
}

void add_numbers(CLI::App& command, CrawlOptions& options) {
  const auto positive_number = [&](double most, const char* name, double& value, const char* text) {
    return add_number(command, name, value, up_to(most), text);
  };
  positive_number(10.0, "--friction-forwards", options.friction_forwards,
                  "Coefficient of friction of a foot that slides towards the fingertip")
      ->required();
  positive_number(10.0, "--friction-backwards", options.friction_backwards, "Of one that slides towards the rear")
      ->required();
  add_number(command, "--frequency-Hz", options.frequency, text::Rule::between(0.1, 1000.0),
             "Frequency of the pulses, Hz (default 10)");
  add_number(command, "--duty", options.duty, text::Rule::above(0.0).and_also(text::Rule::below(1.0)),
             "Fraction of a period with the switch closed (default 0.5)");
  positive_number(100.0, "--cell-voltage-V", options.cell_voltage, "Voltage of the cell, V (default 4.2)");
  positive_number(1e6, "--cell-capacity-mAh", options.cell_capacity, "Capacity of the cell, mAh (default 150)");
  positive_number(1e3, "--cell-limit-A", options.cell_limit, "The most that the cell delivers, A (default 3)");
  add_number(command, "--lead-resistance-Ohm", options.lead_resistance, text::Rule::between(0.0, 1e3),
             "Of switch and leads, which carry the current of all coils, Ohm (default 0.12)");
  positive_number(1e4, "--payload-mass-g", options.payload_mass,
                  "Of battery, board and longer rear part, g (default 23)");
  positive_number(1e3, "--payload-length-mm", options.payload_length,
                  "By which the rear part is longer, mm (default 30)");
  add_number(command, "--step-ms", options.step, text::Rule::between(1e-3, 1.0), "Longest time step, ms (default 0.1)");
  add_whole_number(command, "--settling-periods", options.settling_periods, text::Rule::between(0, 10000),
                   "Periods before it is measured (default 10)");
  add_whole_number(command, "--periods", options.periods, text::Rule::between(1, 10000),
                   "Periods over which it is measured (default 20)");
}

}  // namespace

void add_crawl_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<CrawlOptions>();
  CLI::App* command = add_command(app, "crawl");
  add_actuator_options(*command, options->actuator);
  add_numbers(*command, *options);
  add_json_option(*command, options->json);
  command->footer(
      "The actuator lies on its bottom layer with the payload behind its rear part. All coils are in parallel on the\n"
      "cell through one switch. Speed is positive towards the fingertip and the mean over the measured periods;\n"
      "speed_scatter_mm_s is the standard deviation of single periods. What the coils take beyond heat, "
      "mechanical_mW,\n"
      "is lost in hinges, friction and landing feet; unbalanced_mW is what the time steps make or lose.\n"
      "Heat is that of the rms current of cold coils in a robot that lies straight: continuous_current_A can be held\n"
      "for good, and a coil or magnet is at its limit time_to_limit_s after a cold start, with the film of the\n"
      "actuator's file and in still air.\n\n"
      "Example:\n"
      "  coilwright crawl configs/actuators/paper_finger.json --friction-forwards 0.3 --friction-backwards 0.6");
  command->callback([options] { run_crawl(*options); });
}

}  // namespace coilwright::cli
