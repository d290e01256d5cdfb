#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cli/actuator_input.hpp"
#include "cli/film/commands.hpp"
#include "cli/film/film_run.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/film/lens_file.hpp"
#include "coilwright/formats/simulation/commanded_input_file.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/file_name.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "coilwright/text/require_readable.hpp"

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

struct ReadFilm {
  std::string name;
  video::TrackedFilm film;
  video::FingerMotion motion;
  std::vector<std::string> previews;  // PNG
};

// A dozen pictures, evenly over a film whose length is known at its end only.
class Preview {
 public:
  explicit Preview(const video::Vision& vision) : vision_(vision) {}
  void show(const video::Picture& picture, const video::Frame& frame) {
    if (seen_++ % stride_ != 0) return;
    std::vector<video::TagCorners> tags;
    for (const video::Sighting& each : frame.sightings) tags.push_back(each.outline);
    pictures_.push_back(vision_.png(picture, tags));
    constexpr std::size_t most = 12;
    if (pictures_.size() <= most) return;
    for (std::size_t i = 0; 2 * i < pictures_.size(); ++i) std::swap(pictures_[i], pictures_[2 * i]);
    pictures_.resize((pictures_.size() + 1) / 2);
    stride_ *= 2;
  }
  [[nodiscard]] std::vector<std::string> pictures() && { return std::move(pictures_); }

 private:
  const video::Vision& vision_;
  std::vector<std::string> pictures_;
  std::size_t seen_ = 0;
  std::size_t stride_ = 1;
};

video::CameraKnowledge knowledge_of(const TrackOptions& options) {
  video::CameraKnowledge out{.frame_rate = options.frame_rate};
  if (!options.lens.empty()) out.lens = formats::read_lens(options.lens);
  if (options.readout) out.readout = *options.readout * 1e-3;
  if (options.exposure) out.exposure = *options.exposure * 1e-3;
  return out;
}

void require_same_size(const TrackOptions& options, const video::TrackedFilm& film, const video::Lens& lens) {
  if (lens.width == film.width && lens.height == film.height) return;
  throw text::InputError(
      {.file = options.lens,
       .place = "",
       .rule = fmt::format("must be of pictures of {} by {} px, as {} has", film.width, film.height, film.file),
       .value = fmt::format("{} by {}", lens.width, lens.height)});
}

ReadFilm read_film(const TrackOptions& options, const video::Vision& vision, const std::string& file,
                   const video::CameraKnowledge& knowledge) {
  text::require_readable(file);
  video::TrackRequest request;
  if (!options.led.empty()) request.led = video::Place(options.led[0], options.led[1]);
  Preview preview(vision);
  if (options.preview)
    request.preview = [&](const video::Picture& picture, const video::Frame& frame) { preview.show(picture, frame); };
  ReadFilm out{.name = fs::path(file).stem().string(),
               .film = video::track_film(vision, file, request),
               .motion = {},
               .previews = {}};
  if (knowledge.lens) require_same_size(options, out.film, *knowledge.lens);
  out.motion = video::finger_motion(out.film, knowledge);
  out.previews = std::move(preview).pictures();
  return out;
}

std::vector<double> offsets_of(const TrackOptions& options, const ReadFilm& film, OpeningSense opens) {
  std::vector<double> first = first_angles(film.motion, opens);
  if (options.start.empty()) return std::vector<double>(first.size(), 0.0);
  if (options.start.size() != first.size())
    throw text::InputError({.file = "--start-deg",
                            .place = "",
                            .rule = fmt::format("must have one angle for each tag but the base's, {}", first.size()),
                            .value = std::to_string(options.start.size())});
  for (std::size_t k = 0; k < first.size(); ++k) first[k] = options.start[k] * degree - first[k];
  return first;
}

void write_motion(std::ostream& out, const measurement::data::Run& run, const std::vector<double>& sigmas) {
  std::vector<std::string> names{"time_s"};
  for (const auto& channel : run.channels) names.push_back(channel.name);
  if (!sigmas.empty()) names.emplace_back("sigma_deg");
  text::CsvWriter csv(out, names);
  const auto digits = [](double value, double ten_to_places) {
    return std::round(value * ten_to_places) / ten_to_places;
  };
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    std::vector<double> row{digits(run.times[i], 1e7)};
    for (const auto& channel : run.channels) row.push_back(digits(channel.values[i] / degree, 1e5));
    if (!sigmas.empty()) row.push_back(digits(sigmas[i] / degree, 1e5));
    csv.row(row);
  }
}

struct Advice {
  std::vector<std::string> guessed;
  std::vector<std::string> asked;
};

// Which way they follow each other in a picture that a player turns.
std::string way_of_rows(const video::TrackedFilm& film) {
  if (film.quarter_turns == 0) return {};
  constexpr std::array ways{"downwards", "leftwards", "upwards", "rightwards"};
  return fmt::format(", {} in the picture, which the file turns by {} deg",
                     ways.at(static_cast<std::size_t>(film.quarter_turns)), 90 * film.quarter_turns);
}

void advise_on_rows(const ReadFilm& film, Advice& advice) {
  const auto& [interval, readout] = std::pair(film.motion.interval, film.motion.readout);
  if (readout.value != 0.0)
    advice.guessed.push_back(fmt::format("{}: rows are read out in {:.3g} ms{}, by the skew of moving tags", film.name,
                                         1e3 * readout.value, way_of_rows(film.film)));
  else if (readout.least_seen() < interval)
    advice.guessed.push_back(fmt::format("{}: all rows at once; no skew of moving tags is seen", film.name));
  else  // no camera takes longer than from one picture to the next
    advice.asked.push_back(fmt::format(
        "{}: the time in which its rows are read out, which a motion to one side at one speed does not tell from an "
        "oblique view: --readout-ms (taken as 0)",
        film.name));
}

void advise_on_camera(const TrackOptions& options, const ReadFilm& film, Advice& advice) {
  const auto& motion = film.motion;
  if (!options.exposure && motion.exposure.value > 0.0)
    advice.guessed.push_back(
        fmt::format("{}: exposure {:.3g} ms, by the blur", film.name, 1e3 * motion.exposure.value));
  if (!options.exposure && motion.exposure.value == 0.0)
    advice.asked.push_back(
        fmt::format("{}: the exposure, which its blur does not show: --exposure-ms (taken as 0)", film.name));
  if (!options.readout) advise_on_rows(film, advice);
}

// What an oblique view may do to the angles, beyond what their scatter shows.
void advise_on_view(const TrackOptions& options, const ReadFilm& film, Advice& advice) {
  constexpr double worth_a_line = 0.2 * degree;
  if (film.motion.view_bias < worth_a_line) return;
  advice.guessed.push_back(fmt::format(
      "{}: the camera is about {:.0f} deg off the normal of the plane of motion: all angles of a tag may be off by up "
      "to "
      "{:.1f} deg, by what the film does not tell of {}, which sigma_deg does not have; {}film along the normal",
      film.name, film.motion.tilt / degree, film.motion.view_bias / degree,
      options.lens.empty() ? "the lens and the side" : "the side", options.lens.empty() ? "--lens, or " : ""));
}

void print_all(std::string_view title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  std::cout << title << ":\n";
  for (const std::string& each : sentences) std::cout << "  " << each << '\n';
}

std::string summary_of(const ReadFilm& film) {
  const auto& tip = film.motion.tags.back();
  double sum = 0.0;
  for (const auto& each : tip.samples) sum += each.sigma * each.sigma;
  return fmt::format(
      "{}: {} pictures, {} doubled{}; tip read in {}, to {:.3f} deg rms; camera {:.1f} deg off the normal\n", film.name,
      film.film.pictures, film.film.doubled,
      film.film.unstamped == 0 ? std::string()
                               : fmt::format(", {} more at the end without a time stamp left out", film.film.unstamped),
      tip.samples.size(), std::sqrt(sum / static_cast<double>(tip.samples.size())) / degree, film.motion.tilt / degree);
}

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

std::vector<ReadFilm> read_films(const TrackOptions& options) {
  const video::CameraKnowledge knowledge = knowledge_of(options);
  const video::Vision& vision = video::load_vision();
  std::vector<ReadFilm> out;
  for (const std::string& file : options.films) out.push_back(read_film(options, vision, file, knowledge));
  return out;
}

OpeningSense opening_of(const TrackOptions& options, const ReadFilm& first, Advice& advice) {
  if (!options.opens.empty())
    return options.opens == "clockwise" ? OpeningSense::clockwise : OpeningSense::counterclockwise;
  const OpeningSense opens = sense_of(first.motion);
  advice.guessed.push_back(fmt::format("the finger opens {} as seen, as the tip of {} goes farthest so: --opens",
                                       opens == OpeningSense::clockwise ? "clockwise" : "counterclockwise",
                                       first.name));
  return opens;
}

std::vector<FilmRuns> runs_of(const TrackOptions& options, const std::vector<ReadFilm>& films,
                              const std::vector<std::optional<simulation::CommandedInput>>& logs, Advice& advice) {
  const OpeningSense opens = opening_of(options, films.front(), advice);
  const std::vector<double> offsets = offsets_of(options, films.front(), opens);
  std::optional<video::Place> led;
  if (!options.led.empty()) led = video::Place(options.led[0], options.led[1]);
  std::vector<FilmRuns> out;
  for (std::size_t i = 0; i < films.size(); ++i) {
    const ReadFilm& film = films[i];
    out.push_back(film_runs(film.name, film.film, film.motion, opens, offsets, logs[i], led));
    advise_on_camera(options, film, advice);
    advise_on_view(options, film, advice);
    for (const std::string& sentence : {out.back().clock, out.back().why_no_still})
      if (!sentence.empty()) advice.guessed.push_back(film.name + ": " + sentence);
  }
  return out;
}

void write_film(text::OutputFolder& folder, const ReadFilm& film, const FilmRuns& runs) {
  write_motion(folder.open(runs.motion.name), runs.motion, runs.sigmas);
  if (const auto input = formats::input_file_name(runs.motion)) formats::write_input(folder.open(*input), runs.motion);
  if (runs.still) write_motion(folder.open(runs.still->name), *runs.still, {});
  for (std::size_t k = 0; k < film.previews.size(); ++k)
    folder.write(fmt::format("{}_{:02}.png", film.name, k + 1), film.previews[k]);
}

void write_set(text::OutputFolder& folder, const TrackOptions& options, const std::vector<FilmRuns>& runs) {
  std::vector<formats::RunWithRole> in_roles;
  for (const FilmRuns& each : runs) {
    in_roles.push_back({.run = each.motion});
    if (each.still) in_roles.push_back({.run = *each.still});
  }
  const std::string name = folder.path().lexically_normal().filename().string();
  Json document = formats::dataset_json(name.empty() ? "films" : name, actuator_name, in_roles);
  document.set("ignore", Json::array({"sigma_deg"}));
  folder.write("dataset.json", document.text());
  if (!options.actuator.empty()) folder.write(actuator_name, bytes_of(options.actuator));
}

void ask(const TrackOptions& options, Advice& advice) {
  if (options.start.empty())
    advice.asked.emplace_back(
        "the zero: tags are taken to be glued straight; otherwise --start-deg, the angles at the first film's "
        "beginning");
  if (options.logs.empty())
    advice.asked.emplace_back(
        "what drove the finger: --current with a log for each film (time_s, current_A); then a data set is written");
  else if (options.actuator.empty() && !fs::exists(fs::path(options.out) / actuator_name))
    advice.asked.emplace_back("the declared model: --actuator, or put actuator.json beside dataset.json");
}

Json films_json(const TrackOptions& options, const std::vector<ReadFilm>& films, const Advice& advice) {
  Json list = Json::list(films, [](const ReadFilm& film) {
    return Json::object({{"name", film.name},
                         {"pictures", film.film.pictures},
                         {"doubled", film.film.doubled},
                         {"unstamped", film.film.unstamped},
                         {"read", film.motion.tags.back().samples.size()},
                         {"interval_s", film.motion.interval},
                         {"exposure_s", film.motion.exposure.value},
                         {"readout_s", film.motion.readout.value},
                         {"tilt_deg", film.motion.tilt / degree},
                         {"view_bias_deg", film.motion.view_bias / degree}});
  });
  return Json::object({{"folder", options.out},
                       {"films", std::move(list)},
                       {"guessed", Json::list(advice.guessed)},
                       {"to_be_said", Json::list(advice.asked)}});
}

void print_films(const TrackOptions& options, const std::vector<ReadFilm>& films, const Advice& advice) {
  for (const ReadFilm& film : films) std::cout << summary_of(film);
  print_all("Guessed, to be checked", advice.guessed);
  print_all("To be said by you", advice.asked);
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
  std::vector<std::optional<simulation::CommandedInput>> logs(options.films.size());
  for (std::size_t i = 0; i < options.logs.size(); ++i) logs[i] = formats::read_commanded_input(options.logs[i]);
  const std::vector<ReadFilm> films = read_films(options);
  Advice advice;
  const std::vector<FilmRuns> runs = runs_of(options, films, logs, advice);
  ask(options, advice);
  for (std::size_t i = 0; i < runs.size(); ++i) write_film(folder, films[i], runs[i]);
  if (!options.logs.empty()) write_set(folder, options, runs);
  keep_others(folder, options.force);
  // A person may have put the declared actuator there, or the set to which these films are to come.
  const auto own = [&](std::string_view name) {
    return folder.has(name) || name == actuator_name || name == "dataset.json";
  };
  keep_other_run(folder.path(), own, false);
  folder.commit(options.logs.empty() ? "" : "dataset.json");
  if (options.json)
    std::cout << films_json(options, films, advice).text();
  else
    print_films(options, films, advice);
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
