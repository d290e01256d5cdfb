#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/film/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/film/film_records_file.hpp"
#include "coilwright/formats/film/lens_file.hpp"
#include "coilwright/formats/simulation/commanded_input_file.hpp"
#include "coilwright/text/output/file_name.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;
using text::Json;

constexpr double degree = std::numbers::pi / 180.0;

struct TrackOptions {
  std::vector<std::string> films;
  std::vector<std::string> logs;
  std::string out;
  std::string actuator;
  std::string lens;
  std::string opens;
  std::vector<double> start{};         // degrees
  std::vector<double> led{};           // px
  std::optional<double> readout{};     // ms
  std::optional<double> exposure{};    // ms
  std::optional<double> frame_rate{};  // Hz
  bool preview{false};
  bool force{false};
  bool json{false};
};

void check_options(const TrackOptions& options) {
  if (!options.logs.empty() && options.logs.size() != options.films.size())
    throw CLI::ValidationError(
        "--current", fmt::format("needs one log for each film, {}; got {}", options.films.size(), options.logs.size()));
  std::vector<std::string> names;
  for (const std::string& film : options.films) names.push_back(fs::path(film).stem().string() + ".csv");
  if (const auto fault = text::fault_of_file_names(names))
    throw CLI::ValidationError("FILM", fmt::format("the records of {} would be {}, which {}",
                                                   options.films[fault->index], names[fault->index], fault->rule));
}

// Those that an input could be.
std::vector<fs::path> outputs_of(const TrackOptions& options) {
  const fs::path out(options.out);
  std::vector<fs::path> all{out / "dataset.json", out / actuator_name};
  for (const std::string& film : options.films) {
    const std::string name = fs::path(film).stem().string() + ".csv";
    all.push_back(out / name);
    all.push_back(out / formats::input_file_name(name));
  }
  return all;
}

video::FilmsRequest request_of(const TrackOptions& options) {
  video::FilmsRequest out{.films = {options.films.begin(), options.films.end()},
                          .camera = {.frame_rate = options.frame_rate},
                          .lens_file = options.lens,
                          .previews = options.preview};
  for (const std::string& log : options.logs) out.logs.push_back(formats::read_commanded_input(log));
  if (!options.lens.empty()) out.camera.lens = formats::read_lens(options.lens);
  if (options.readout) out.camera.readout = *options.readout * 1e-3;
  if (options.exposure) out.camera.exposure = *options.exposure * 1e-3;
  if (!options.led.empty()) out.led = video::Place(options.led[0], options.led[1]);
  if (!options.opens.empty())
    out.opens = options.opens == "clockwise" ? video::OpeningSense::clockwise : video::OpeningSense::counterclockwise;
  for (const double angle : options.start) out.start.push_back(angle * degree);
  return out;
}

void write_previews(text::OutputFolder& folder, const video::FilmRecords& records) {
  for (const video::FilmRecord& film : records.films)
    for (std::size_t k = 0; k < film.previews.size(); ++k)
      folder.write(fmt::format("{}_{:02}.png", film.name, k + 1), film.previews[k]);
}

void write_set(text::OutputFolder& folder, const TrackOptions& options, const video::FilmRecords& records) {
  const std::string name = folder.path().lexically_normal().filename().string();
  folder.write("dataset.json", formats::dataset_json(name.empty() ? "films" : name, actuator_name, records).text());
  if (!options.actuator.empty()) folder.write(actuator_name, bytes_of(options.actuator));
}

void print_films(const TrackOptions& options, const video::FilmRecords& records) {
  if (options.json) {
    Json document = formats::to_json(records);
    document.set("folder", options.out);
    std::cout << document.text();
    return;
  }
  std::cout << summary_of(records);
  if (!options.logs.empty())
    std::cout << fmt::format("Next: coilwright diagnose {} --out results\n", printed(options.out));
}

void track_films(const TrackOptions& options) {
  check_options(options);
  std::vector<fs::path> inputs(options.films.begin(), options.films.end());
  inputs.insert(inputs.end(), options.logs.begin(), options.logs.end());
  inputs.insert(inputs.end(), {options.lens, options.actuator});
  keep_inputs(inputs, outputs_of(options));
  text::OutputFolder folder(options.out);
  const video::FilmsRequest request = request_of(options);
  video::FilmRecords records = read_film_records(video::load_vision(), request);
  if (!options.logs.empty() && options.actuator.empty() && !fs::exists(fs::path(options.out) / actuator_name))
    records.to_be_said.emplace_back("the declared model: --actuator, or put actuator.json beside dataset.json");
  formats::write_film_records(records, [&](const std::string& name) -> std::ostream& { return folder.open(name); });
  write_previews(folder, records);
  if (!options.logs.empty()) write_set(folder, options, records);
  keep_others(folder, options.force);
  // A person may have put the declared actuator there, or the set to which these films are to come.
  const auto own = [&](std::string_view name) {
    return folder.has(name) || name == actuator_name || name == "dataset.json";
  };
  keep_other_run(folder.path(), own, false);
  folder.commit(options.logs.empty() ? "" : "dataset.json");
  print_films(options, records);
}

}  // namespace

void add_track_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<TrackOptions>();
  CLI::App* command = add_command(app, "track");
  command->add_option("FILM", options->films, "Films, one for each motion, with the tags of `tag`")
      ->required()
      ->check(file_rule());
  command->add_option("--out", options->out, "Folder for the records; it is created if it does not exist")
      ->required()
      ->check(not_empty());
  command
      ->add_option("--current", options->logs,
                   "Logs of the input, one for each film: CSV with time_s and current_A (or current1_A.., voltage_V)")
      ->check(file_rule());
  command->add_option("--actuator", options->actuator, "File of the declared model, copied beside the records")
      ->check(file_rule());
  command->add_option("--lens", options->lens, "Lens of the camera, from `lens`. Default: one that does not distort")
      ->check(file_rule());
  add_number(*command, "--rate-Hz", options->frame_rate, up_to(1e6),
             "Frames a second at which it was filmed, where the file plays slower. Default: as the file says");
  add_number(*command, "--exposure-ms", options->exposure, text::Rule::between(0, 1e3),
             "Exposure of a picture, ms. Default: by the blur");
  add_number(*command, "--readout-ms", options->readout, text::Rule::between(-1e3, 1e3),
             "Time from the first row's exposure to the last row's, ms. Default: by the skew of moving tags");
  command->add_option("--led", options->led, "X,Y: place in the picture, px, of an LED that is lit with the first step")
      ->delimiter(',')
      ->expected(2)
      ->check(number_rule(text::Rule::between(0, 1e5)));
  add_word(*command, "--opens", options->opens, {"clockwise", "counterclockwise"},
           "How the finger opens as seen in the picture. Default: as the tip goes farthest");
  command
      ->add_option("--start-deg", options->start,
                   "A1,A2..: angles at the beginning of the first film, one for each tag but the base's")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(number_rule(text::Rule::between(-360, 360)));
  add_flag(*command, "--preview", options->preview, "Write a dozen pictures of each film with what was read drawn in");
  add_force_option(*command, options->force);
  add_json_option(*command, options->json, "text");
  command->footer(
      "One tag beside the base's gives bending_angle_deg, more give theta1_deg, ... Column sigma_deg is the standard\n"
      "deviation of each sample (of the first angle). Pictures that repeat the one before, and those in which a tag\n"
      "cannot be read, are left out.\n\n"
      "Example:\n"
      "  coilwright track step.mp4 sine.mp4 --current step.csv sine.csv --actuator actuator.json --out data");
  command->callback([options] { track_films(*options); });
}

}  // namespace coilwright::cli
