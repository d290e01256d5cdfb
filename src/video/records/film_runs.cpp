#include "video/records/film_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "coilwright/text/input_error.hpp"
#include "coilwright/video/film_clock.hpp"

namespace coilwright::video {
namespace {

using namespace measurement::data;

double sign_of(OpeningSense opens) {
  return opens == OpeningSense::clockwise ? 1.0 : -1.0;
}

// The samples at which all tags were read, joint by joint; the tip's time and, in quadrature, its noise.
struct Table {
  std::vector<double> times;
  std::vector<double> sigmas;
  std::vector<std::vector<double>> angles;
};

std::optional<AngleSample> near(const std::vector<AngleSample>& samples, double time, double interval) {
  const auto after = std::ranges::lower_bound(samples, time - 0.5 * interval, {}, &AngleSample::time);
  if (after == samples.end() || after->time > time + 0.5 * interval) return std::nullopt;
  return *after;
}

Table table_of(const FingerMotion& motion, OpeningSense opens) {
  Table out;
  out.angles.resize(motion.tags.size());
  for (const AngleSample& tip : motion.tags.back().samples) {
    std::vector<double> angles;
    double variance = tip.sigma * tip.sigma;
    for (std::size_t k = 0; k + 1 < motion.tags.size(); ++k)
      if (const auto sample = near(motion.tags[k].samples, tip.time, motion.interval)) {
        angles.push_back(sign_of(opens) * sample->angle);
        if (k == 0) variance = sample->sigma * sample->sigma;  // what the set calls sigma is the first angle's
      }
    if (angles.size() + 1 != motion.tags.size()) continue;
    angles.push_back(sign_of(opens) * tip.angle);
    out.times.push_back(tip.time);
    out.sigmas.push_back(std::sqrt(variance));
    for (std::size_t k = 0; k < angles.size(); ++k) out.angles[k].push_back(angles[k] - (k == 0 ? 0.0 : angles[k - 1]));
  }
  return out;
}

std::vector<Channel> channels_of(Table& table) {
  if (table.angles.size() == 1)
    return {{.name = "bending_angle_deg", .kind = ChannelKind::bending_angle, .values = std::move(table.angles[0])}};
  std::vector<Channel> out;
  for (std::size_t k = 0; k < table.angles.size(); ++k)
    out.push_back({.name = fmt::format("theta{}_deg", k + 1),
                   .kind = ChannelKind::joint_angle,
                   .joint = static_cast<int>(k),
                   .values = std::move(table.angles[k])});
  return out;
}

double rms(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, values.size())));
}

// Whether each reading is nearly the one before: neighbours are correlated by more than 3/4.
bool repeat_each_other(const std::vector<double>& values) {
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  double squares = 0.0, differences = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    squares += (values[i] - mean) * (values[i] - mean);
    differences += (values[i] - values[i - 1]) * (values[i] - values[i - 1]);
  }
  return 0.5 * differences < 0.25 * squares;
}

// Standard deviation about the mean.
double scatter_of(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

// Keeps the samples from `first` to before `last`.
void keep(Run& run, std::vector<double>& sigmas, std::size_t first, std::size_t last) {
  const auto cut = [&](std::vector<double>& values) {
    values = std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(first),
                                 values.begin() + static_cast<std::ptrdiff_t>(last));
  };
  cut(run.times);
  cut(sigmas);
  for (Channel& channel : run.channels) cut(channel.values);
}

void add_still(FilmRecord& out, std::vector<std::string>& guessed) {
  std::size_t count = out.run.times.size();
  for (const TagMotion& tag : out.motion.tags) {
    const std::size_t still = still_samples(tag.samples);
    if (still < tag.samples.size())
      count = std::min<std::size_t>(
          count, std::ranges::lower_bound(out.run.times, tag.samples[still].time) - out.run.times.begin());
  }
  constexpr std::size_t fewest = 30;
  constexpr std::size_t begun = 3;  // the last pictures may have seen it begin
  count -= std::min(count, begun);
  if (count < fewest) {
    guessed.push_back(fmt::format("{}: {} pictures before it moves are too few for a still run; {} are enough",
                                  out.name, count, fewest));
    return;
  }
  Run still = out.run;
  std::vector<double> sigmas = out.sigmas;
  still.name = out.name + "_still.csv";
  still.kind = RunKind::still;
  keep(still, sigmas, 0, count);
  // Compression holds a picture in which nothing moves, with its errors, from one to the next: that is not the noise of
  // a motion, by which a rest scatters as the motion does beside its course.
  const auto moving = std::span(out.sigmas).subspan(out.sigmas.size() - count < fewest ? 0 : count);
  constexpr double shows_noise = 0.4;  // of the stated deviation, which is 1.2 times the scatter
  if (const std::vector<double>& resting = still.channels.front().values;
      repeat_each_other(resting) || scatter_of(resting) < shows_noise * rms(moving)) {
    guessed.push_back(
        fmt::format("{}: compression has smoothed the pictures before it moves: they do not show the noise, and are no "
                    "still run",
                    out.name));
    return;
  }
  out.still = std::move(still);
}

double first_step_of(const simulation::CommandedInput& log, const std::string& film) {
  double largest = 0.0;
  for (const auto& row : log.rows)
    for (std::size_t k = 0; k < row.size(); ++k) largest = std::max(largest, std::abs(row[k] - log.rows.front()[k]));
  for (std::size_t i = 0; i < log.rows.size() && largest > 0.0; ++i)
    for (std::size_t k = 0; k < log.rows[i].size(); ++k)
      if (std::abs(log.rows[i][k] - log.rows.front()[k]) > 0.1 * largest) return log.times[i];
  throw text::InputError({.file = film,
                          .place = "",
                          .rule = "needs a log whose input changes: by its first step the two clocks are "
                                  "brought together; this one's never changes",
                          .value = ""});
}

void take_log(FilmRecord& out, const FilmsRequest& request, const simulation::CommandedInput& log,
              std::vector<std::string>& guessed) {
  const TrackedFilm& film = out.film;
  const FingerMotion& motion = out.motion;
  const std::optional<Place>& led = request.led;
  const double step = first_step_of(log, film.file);
  std::optional<Moment> begins;
  if (led) begins = led_lit(film, motion, *led);
  if (led && !begins)
    throw text::InputError({.file = film.file,
                            .place = "",
                            .rule = fmt::format("must show the LED being lit at the place that {} names; its light "
                                                "does not change",
                                                called(request, "led")),
                            .value = ""});
  for (const TagMotion& tag : motion.tags) {
    if (led) break;
    const auto onset = onset_of(tag.samples, motion.interval);
    if (onset && (!begins || onset->sigma < begins->sigma)) begins = onset;
  }
  if (!begins)
    throw text::InputError({.file = film.file,
                            .place = "",
                            .rule = fmt::format("must show the finger at rest and then moving, or an LED ({} X,Y): "
                                                "without, its clock cannot be set by the log",
                                                called(request, "led")),
                            .value = ""});
  if (!is_known_to_two_pictures(*begins, motion.interval))
    throw text::InputError(
        {.file = film.file,
         .place = "",
         .rule = fmt::format(
             "must show to two pictures, {:.2g} s, when {}; pictures there that are noisy, doubled, "
             "missing or not read "
             "leave it open: film it again with more light and a shorter exposure{}",
             2.0 * motion.interval, led ? "the LED is lit" : "the finger begins to move",
             led ? "" : fmt::format(", or with an LED that is lit with the step ({} X,Y)", called(request, "led"))),
         .value = fmt::format("{:.2g} s", begins->sigma)});
  Run& run = out.run;
  run.drive = log.drive;
  run.input_times = log.times;
  run.inputs = log.rows;
  run.clock.offset_sigma = begins->sigma;
  for (double& time : run.times) time += step - begins->time;
  double longest = 0.0;
  for (std::size_t i = 1; i < log.times.size(); ++i) longest = std::max(longest, log.times[i] - log.times[i - 1]);
  const auto first = std::ranges::lower_bound(run.times, log.times.front()) - run.times.begin();
  const auto last = std::ranges::upper_bound(run.times, log.times.back() + 0.99 * longest) - run.times.begin();
  constexpr std::ptrdiff_t fewest = 10;
  if (last - first < fewest)
    throw text::InputError({.file = film.file,
                            .place = "",
                            .rule = "must share ten pictures or more with its log, once the first step of the log is "
                                    "where the finger begins to move",
                            .value = std::to_string(std::max<std::ptrdiff_t>(0, last - first))});
  keep(run, out.sigmas, static_cast<std::size_t>(first), static_cast<std::size_t>(last));
  guessed.push_back(fmt::format("{}: the log's first step, at {:.4g} s, is where {}, to {:.2g} s", out.name, step,
                                led ? "the LED is lit" : "the finger begins to move", begins->sigma));
}

}  // namespace

OpeningSense sense_of(const FingerMotion& motion) {
  const auto& tip = motion.tags.back().samples;
  double farthest = 0.0;
  for (const AngleSample& each : tip)
    if (std::abs(each.angle - tip.front().angle) > std::abs(farthest)) farthest = each.angle - tip.front().angle;
  return farthest >= 0.0 ? OpeningSense::clockwise : OpeningSense::counterclockwise;
}

std::vector<double> first_angles(const FingerMotion& motion, OpeningSense opens) {
  const Table table = table_of(motion, opens);
  std::vector<double> out;
  for (const auto& angles : table.angles) out.push_back(angles.empty() ? 0.0 : angles.front());
  return out;
}

void fill_runs(FilmRecord& record, const FilmsRequest& request, OpeningSense opens, const std::vector<double>& offsets,
               const simulation::CommandedInput* log, std::vector<std::string>& guessed) {
  Table table = table_of(record.motion, opens);
  constexpr std::size_t fewest = 10;
  if (table.times.size() < fewest)
    throw text::InputError(
        {.file = record.film.file,
         .place = "",
         .rule = fmt::format("must have {} pictures or more in which all of its tags can be read", fewest),
         .value = std::to_string(table.times.size())});
  for (std::size_t k = 0; k < table.angles.size() && k < offsets.size(); ++k)
    for (double& angle : table.angles[k]) angle += offsets[k];
  record.sigmas = std::move(table.sigmas);
  record.run.name = record.name + ".csv";
  record.run.kind = RunKind::transient;
  record.run.times = std::move(table.times);
  record.run.channels = channels_of(table);
  record.run.clock.exposure = record.motion.exposure.value;
  std::vector<std::string> of_its_rest;
  add_still(record, of_its_rest);
  if (log != nullptr) take_log(record, request, *log, guessed);
  guessed.insert(guessed.end(), of_its_rest.begin(), of_its_rest.end());
  record.run.sigma = rms(record.sigmas);
}

}  // namespace coilwright::video
