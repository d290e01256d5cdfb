#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "video/records/film_runs.hpp"

namespace coilwright::video {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// Which way they follow each other in a picture that a player turns.
std::string way_of_rows(const TrackedFilm& film) {
  if (film.quarter_turns == 0) return {};
  constexpr std::array ways{"downwards", "leftwards", "upwards", "rightwards"};
  return fmt::format(", {} in the picture, which the file turns by {} deg",
                     ways.at(static_cast<std::size_t>(film.quarter_turns)), 90 * film.quarter_turns);
}

void advise_on_rows(const FilmsRequest& request, const FilmRecord& record, FilmRecords& records) {
  const auto& [interval, readout] = std::pair(record.motion.interval, record.motion.readout);
  if (readout.value != 0.0)
    records.guessed.push_back(fmt::format("{}: rows are read out in {:.3g} ms{}, by the skew of moving tags",
                                          record.name, 1e3 * readout.value, way_of_rows(record.film)));
  else if (readout.least_seen() < interval)
    records.guessed.push_back(fmt::format("{}: all rows at once; no skew of moving tags is seen", record.name));
  else  // no camera takes longer than from one picture to the next
    records.to_be_said.push_back(fmt::format(
        "{}: the time in which its rows are read out, which a motion to one side at one speed does not tell "
        "from an oblique view: {} (taken as 0)",
        record.name, called(request, "readout_ms")));
}

void advise_on_exposure(const FilmsRequest& request, const FilmRecord& record, FilmRecords& records) {
  if (const double exposure = record.motion.exposure.value; exposure > 0.0)
    records.guessed.push_back(fmt::format("{}: exposure {:.3g} ms, by the blur", record.name, 1e3 * exposure));
  else if (exposure == 0.0)
    records.to_be_said.push_back(fmt::format("{}: the exposure, which its blur does not show: {} (taken as 0)",
                                             record.name, called(request, "exposure_ms")));
}

// What an oblique view may do to the angles, beyond what their scatter shows.
void advise_on_view(const FilmsRequest& request, const FilmRecord& record, FilmRecords& records) {
  constexpr double worth_a_line = 0.2 * degree;
  if (record.motion.view_bias < worth_a_line) return;
  const bool has_lens = request.camera.lens.has_value();
  records.guessed.push_back(fmt::format(
      "{}: the camera is about {:.0f} deg off the normal of the plane of motion: all angles of a tag may be off by up "
      "to {:.1f} deg, by what the film does not tell of {}, which sigma_deg does not have; {}film along the normal",
      record.name, record.motion.tilt / degree, record.motion.view_bias / degree,
      has_lens ? "the side" : "the lens and the side", has_lens ? "" : called(request, "lens") + ", or "));
}

std::string line_of(const FilmRecord& record) {
  const auto& tip = record.motion.tags.back();
  double sum = 0.0;
  for (const auto& each : tip.samples) sum += each.sigma * each.sigma;
  return fmt::format(
      "{}: {} pictures, {} doubled{}; tip read in {}, to {:.3f} deg rms; camera {:.1f} deg off the "
      "normal\n",
      record.name, record.film.pictures, record.film.doubled,
      record.film.unstamped == 0
          ? std::string()
          : fmt::format(", {} more at the end without a time stamp left out", record.film.unstamped),
      tip.samples.size(), std::sqrt(sum / static_cast<double>(tip.samples.size())) / degree,
      record.motion.tilt / degree);
}

std::string listed(std::string_view title, const std::vector<std::string>& sentences) {
  std::string out = sentences.empty() ? std::string() : fmt::format("{}:\n", title);
  for (const std::string& each : sentences) out += fmt::format("  {}\n", each);
  return out;
}

}  // namespace

void advise_on_camera(const FilmsRequest& request, const FilmRecord& record, FilmRecords& records) {
  if (!request.camera.exposure) advise_on_exposure(request, record, records);
  if (!request.camera.readout) advise_on_rows(request, record, records);
  advise_on_view(request, record, records);
}

std::string summary_of(const FilmRecords& records) {
  std::string out;
  for (const FilmRecord& record : records.films) out += line_of(record);
  return out + listed("Guessed, to be checked", records.guessed) + listed("To be said by you", records.to_be_said);
}

}  // namespace coilwright::video
