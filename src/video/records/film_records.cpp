#include "coilwright/video/records/film_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/require_readable.hpp"
#include "video/records/film_runs.hpp"

namespace coilwright::video {
namespace {

// A dozen pictures, evenly over a film whose length is known at its end only.
class Preview {
 public:
  explicit Preview(const Vision& vision) : vision_(vision) {}
  void show(const Picture& picture, const Frame& frame) {
    if (seen_++ % stride_ != 0) return;
    std::vector<TagCorners> tags;
    for (const Sighting& each : frame.sightings) tags.push_back(each.outline);
    pictures_.push_back(vision_.png(picture, tags));
    constexpr std::size_t most = 12;
    if (pictures_.size() <= most) return;
    for (std::size_t i = 0; 2 * i < pictures_.size(); ++i) std::swap(pictures_[i], pictures_[2 * i]);
    pictures_.resize((pictures_.size() + 1) / 2);
    stride_ *= 2;
  }
  [[nodiscard]] std::vector<std::string> pictures() && { return std::move(pictures_); }

 private:
  const Vision& vision_;
  std::vector<std::string> pictures_;
  std::size_t seen_ = 0;
  std::size_t stride_ = 1;
};

void require_same_size(const FilmsRequest& request, const TrackedFilm& film, const Lens& lens) {
  if (lens.width == film.width && lens.height == film.height) return;
  throw text::InputError(
      {.file = request.lens_file,
       .place = "",
       .rule = fmt::format("must be of pictures of {} by {} px, as {} has", film.width, film.height, film.file),
       .value = fmt::format("{} by {}", lens.width, lens.height)});
}

FilmRecord read_film(const Vision& vision, const FilmsRequest& request, const std::filesystem::path& file) {
  text::require_readable(file);
  Preview preview(vision);
  TrackRequest asked{.led = request.led};
  if (request.previews || request.at_picture)
    asked.preview = [&](const Picture& picture, const Frame& frame) {
      if (request.at_picture) request.at_picture();
      if (request.previews) preview.show(picture, frame);
    };
  FilmRecord out{.name = file.stem().string(), .film = track_film(vision, file, asked)};
  if (request.camera.lens) require_same_size(request, out.film, *request.camera.lens);
  out.motion = finger_motion(out.film, request.camera);
  out.previews = std::move(preview).pictures();
  return out;
}

std::vector<double> offsets_of(const FilmsRequest& request, const FilmRecord& first_film, OpeningSense opens) {
  std::vector<double> first = first_angles(first_film.motion, opens);
  if (request.start.empty()) return std::vector<double>(first.size(), 0.0);
  if (request.start.size() != first.size())
    throw text::InputError({.file = called(request, "start_deg"),
                            .place = "",
                            .rule = fmt::format("must have one angle for each tag but the base's, {}", first.size()),
                            .value = std::to_string(request.start.size())});
  for (std::size_t k = 0; k < first.size(); ++k) first[k] = request.start[k] - first[k];
  return first;
}

OpeningSense opening_of(const FilmsRequest& request, FilmRecords& records) {
  if (request.opens) return *request.opens;
  const OpeningSense opens = sense_of(records.films.front().motion);
  records.guessed.push_back(fmt::format("the finger opens {} as seen, as the tip of {} goes farthest so: {}",
                                        opens == OpeningSense::clockwise ? "clockwise" : "counterclockwise",
                                        records.films.front().name, called(request, "opens")));
  return opens;
}

}  // namespace

std::string called(const FilmsRequest& request, std::string name) {
  if (request.as_keywords) return name;
  std::ranges::replace(name, '_', '-');
  return "--" + std::move(name);
}

FilmRecords read_film_records(const Vision& vision, const FilmsRequest& request) {
  FilmRecords out;
  for (const std::filesystem::path& film : request.films) out.films.push_back(read_film(vision, request, film));
  const OpeningSense opens = opening_of(request, out);
  const std::vector<double> offsets = offsets_of(request, out.films.front(), opens);
  for (std::size_t i = 0; i < out.films.size(); ++i) {
    std::vector<std::string> of_its_clock;
    fill_runs(out.films[i], request, opens, offsets, request.logs.empty() ? nullptr : &request.logs[i], of_its_clock);
    advise_on_camera(request, out.films[i], out);
    out.guessed.insert(out.guessed.end(), of_its_clock.begin(), of_its_clock.end());
  }
  if (request.start.empty())
    out.to_be_said.push_back(fmt::format(
        "the zero: tags are taken to be glued straight; otherwise {}, the angles at the first film's beginning",
        called(request, "start_deg")));
  if (request.logs.empty())
    out.to_be_said.push_back(
        fmt::format("what drove the finger, without which they are no data set: {} with a log for each film (time_s, "
                    "current_A)",
                    called(request, "current")));
  return out;
}

}  // namespace coilwright::video
