#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "actuator_input.hpp"
#include "coilwright/systems/crawl.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/units/unit.hpp"
#include "commands.hpp"
#include "number_rule.hpp"

namespace coilwright::cli {
namespace {

using text::Json;

// As on the command line, each in the unit of its name.
struct Options {
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

systems::CrawlerParts parts_of(const Options& options) {
  return {.payload = {.mass = options.payload_mass * 1e-3, .length = options.payload_length * 1e-3},
          .cell = {.voltage = options.cell_voltage,
                   .capacity = options.cell_capacity * 3.6,
                   .current_limit = options.cell_limit},
          .friction = {.forwards = options.friction_forwards, .backwards = options.friction_backwards},
          .drive = {.frequency = options.frequency, .duty = options.duty, .lead_resistance = options.lead_resistance}};
}

systems::Crawler crawler_of(const Options& options) {
  formats::ActuatorFile file = read_actuator(options.actuator);
  const actuator::Design design = design_in(file, options.actuator, "a crawler needs a design (actuator/1)");
  const actuator::Assembly assembly = assemble(design, options.actuator);
  try {
    return systems::Crawler(design, assembly, parts_of(options));
  } catch (const std::invalid_argument& rule) {
    throw text::InputError({.file = options.actuator.file, .rule = rule.what()});
  }
}

std::string point_name(std::size_t i, std::size_t count) {
  if (i == 0) return "rear_end";
  return i + 1 == count ? "front_end" : fmt::format("joint{}", i);
}

// Every number by its key; the table prints the same rows.
std::vector<std::pair<std::string, double>> rows_of(const systems::Crawler& crawler, const systems::Crawl& crawl) {
  constexpr double degrees = 57.29577951308232;
  const systems::CrawlPowers& powers = crawl.powers;
  std::vector<std::pair<std::string, double>> rows{{"mass_g", crawler.mass() * 1e3},
                                                   {"speed_mm_s", crawl.speed * 1e3},
                                                   {"speed_scatter_mm_s", crawl.speed_scatter * 1e3},
                                                   {"coil_current_A", crawl.pulse_current},
                                                   {"mean_cell_current_A", crawl.mean_current},
                                                   {"power_W", powers.electrical},
                                                   {"run_time_s", crawl.run_time},
                                                   {"distance_per_charge_m", crawl.distance_per_charge},
                                                   {"largest_bending_deg", crawl.largest_bending * degrees},
                                                   {"smallest_bending_deg", crawl.smallest_bending * degrees}};
  for (std::size_t i = 0; i < crawl.lifts.size(); ++i)
    rows.emplace_back(fmt::format("lift_{}_mm", point_name(i, crawl.lifts.size())), crawl.lifts[i] * 1e3);
  for (const auto& [key, watts] : {std::pair{"copper_heat_mW", powers.copper},
                                   {"lead_heat_mW", powers.leads},
                                   {"mechanical_mW", powers.mechanical},
                                   {"hinge_loss_mW", powers.hinges},
                                   {"friction_loss_mW", powers.friction},
                                   {"impact_loss_mW", powers.impacts},
                                   {"stored_mW", powers.stored},
                                   {"unbalanced_mW", powers.unbalanced}})
    rows.emplace_back(key, watts * 1e3);
  return rows;
}

std::string as_table(const std::vector<std::pair<std::string, double>>& rows) {
  std::string text;
  for (const auto& [key, value] : rows) text += fmt::format("{:<26} {:>12.5g}\n", key, value);
  return text;
}

std::string as_json(const std::vector<std::pair<std::string, double>>& rows) {
  Json out = Json::object({});
  for (const auto& [key, value] : rows) out.set(key, value);
  return out.text();
}

void run_crawl(const Options& options) {
  const systems::Crawler crawler = crawler_of(options);
  const systems::Crawl crawl = systems::crawl(
      crawler, {.settling_periods = options.settling_periods, .periods = options.periods, .step = options.step * 1e-3});
  const auto rows = rows_of(crawler, crawl);
  std::cout << (options.json ? as_json(rows) : as_table(rows));
}

void add_numbers(CLI::App& command, Options& options) {
  const auto up_to = [&](double most, const char* name, double& value, const char* text) {
    return command.add_option(name, value, text)
        ->check(number_rule(text::Rule::above(0.0).and_also(text::Rule::at_most(most))));
  };
  up_to(10.0, "--friction-forwards", options.friction_forwards,
        "Coefficient of friction of a foot that slides towards the fingertip")
      ->required();
  up_to(10.0, "--friction-backwards", options.friction_backwards, "Of one that slides towards the rear")->required();
  command.add_option("--frequency-Hz", options.frequency, "Frequency of the pulses, Hz (default 10)")
      ->check(number_rule(text::Rule::between(0.1, 1000.0)));
  command.add_option("--duty", options.duty, "Fraction of a period with the switch closed (default 0.5)")
      ->check(number_rule(text::Rule::above(0.0).and_also(text::Rule::below(1.0))));
  up_to(100.0, "--cell-voltage-V", options.cell_voltage, "Voltage of the cell, V (default 4.2)");
  up_to(1e6, "--cell-capacity-mAh", options.cell_capacity, "Capacity of the cell, mAh (default 150)");
  up_to(1e3, "--cell-limit-A", options.cell_limit, "The most that the cell delivers, A (default 3)");
  command
      .add_option("--lead-resistance-Ohm", options.lead_resistance,
                  "Of switch and leads, which carry the current of all coils, Ohm (default 0.12)")
      ->check(number_rule(text::Rule::between(0.0, 1e3)));
  up_to(1e4, "--payload-mass-g", options.payload_mass, "Of battery, board and longer rear part, g (default 23)");
  up_to(1e3, "--payload-length-mm", options.payload_length, "By which the rear part is longer, mm (default 30)");
  command.add_option("--step-ms", options.step, "Longest time step, ms (default 0.1)")
      ->check(number_rule(text::Rule::between(1e-3, 1.0)));
  command.add_option("--settling-periods", options.settling_periods, "Periods before it is measured (default 10)")
      ->transform(whole_number_rule(text::Rule::between(0, 10000)));
  command.add_option("--periods", options.periods, "Periods over which it is measured (default 20)")
      ->transform(whole_number_rule(text::Rule::between(1, 10000)));
}

}  // namespace

void add_crawl_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("crawl", "Let an actuator crawl on the ground by pulses from a battery cell");
  add_actuator_options(*command, options->actuator);
  add_numbers(*command, *options);
  command->add_flag("--json", options->json, "Print JSON instead of a table")->disable_flag_override();
  command->footer(
      "The actuator lies on its bottom layer with the payload behind its rear part. All coils are in parallel on the\n"
      "cell through one switch. Speed is positive towards the fingertip and the mean over the measured periods;\n"
      "speed_scatter_mm_s is the standard deviation of single periods. What the coils take beyond heat, "
      "mechanical_mW,\n"
      "is lost in hinges, friction and landing feet; unbalanced_mW is what the time steps make or lose.\n\n"
      "Example:\n"
      "  coilwright crawl configs/actuators/paper_finger.json --friction-forwards 0.3 --friction-backwards 0.6");
  command->callback([options] { run_crawl(*options); });
}

}  // namespace coilwright::cli
