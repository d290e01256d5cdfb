#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/model/commands.hpp"
#include "cli/model/task_options.hpp"
#include "coilwright/formats/systems/crawl_json.hpp"
#include "coilwright/systems/crawl.hpp"
#include "coilwright/systems/crawl_heat.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

struct CrawlOptions {
  ActuatorOptions actuator;
  systems::CrawlTask task;
  bool json{false};
};

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
      return systems::Crawler(built.design, built.assembly, options.task.parts);
    } catch (const std::invalid_argument& rule) {
      throw text::InputError({.file = options.actuator.file, .rule = rule.what()});
    }
  }();
  const systems::Crawl crawl = systems::crawl(crawler, options.task.timing);
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

}  // namespace

void add_crawl_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<CrawlOptions>();
  CLI::App* command = add_command(app, "crawl");
  add_actuator_options(*command, options->actuator);
  add_rows(*command, formats::crawl_rows(), options->task);
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
