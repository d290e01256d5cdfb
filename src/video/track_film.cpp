#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "coilwright/text/input_error.hpp"
#include "coilwright/video/tracked_film.hpp"
#include "video/tag_tracker.hpp"

namespace coilwright::video {
namespace {

using text::InputError;

Picture mirrored(Picture picture) {
  for (int y = 0; y < picture.height; ++y) {
    const auto row = picture.grey.begin() + static_cast<std::ptrdiff_t>(y) * picture.width;
    std::reverse(row, row + picture.width);
  }
  return picture;
}

double light_at(const Picture& picture, const Place& place) {
  constexpr int reach = 4;  // px, about the place that was given
  double sum = 0.0;
  int count = 0;
  for (int y = std::max(0, static_cast<int>(place.y()) - reach); y <= place.y() + reach && y < picture.height; ++y)
    for (int x = std::max(0, static_cast<int>(place.x()) - reach); x <= place.x() + reach && x < picture.width; ++x) {
      sum += picture.at(x, y);
      ++count;
    }
  return count > 0 ? sum / count : 0.0;
}

struct Turn {
  double angle;
  double sigma;
};

// How far a tag turned from one frame to the next; nothing where it was not read in both.
std::optional<Turn> turn_between(const Frame& from, const Frame& to, int id) {
  const auto before = std::ranges::find(from.sightings, id, &Sighting::id);
  const auto after = std::ranges::find(to.sightings, id, &Sighting::id);
  if (before == from.sightings.end() || after == to.sightings.end()) return std::nullopt;
  return Turn{.angle = std::remainder(picture_angle(after->shape) - picture_angle(before->shape), 2.0 * M_PI),
              .sigma = std::hypot(before->sigma, after->sigma)};
}

// A double that was compressed is not the same to the bit: all tags stand within their deviation, between two frames
// over which one of them turns the same way beyond doubt.
bool is_double(std::span<const Frame> frames, std::size_t i) {
  constexpr double beyond_doubt = 5.0;
  bool turns = false;
  for (const Sighting& tag : frames[i].sightings) {
    const auto now = turn_between(frames[i - 1], frames[i], tag.id);
    if (!now || std::abs(now->angle) > now->sigma) return false;
    const auto before = turn_between(frames[i - 2], frames[i - 1], tag.id);
    const auto after = turn_between(frames[i], frames[i + 1], tag.id);
    turns |= before && after && before->angle * after->angle > 0.0 &&
             std::abs(before->angle) > beyond_doubt * before->sigma &&
             std::abs(after->angle) > beyond_doubt * after->sigma;
  }
  return turns;
}

class FilmTracker {
 public:
  FilmTracker(const Vision& vision, const std::filesystem::path& file, const TrackRequest& request)
      : vision_(vision), request_(request), tracker_(vision), film_{.file = file.string()} {}

  TrackedFilm track() {
    const auto source = vision_.open(film_.file);
    Picture picture;
    while (source->next(picture)) {
      take(picture);
      std::swap(picture.grey, last_);
      last_time_ = picture.time;
      picture.grey.resize(last_.size());
    }
    require_content();
    leave_out_doubles();
    return std::move(film_);
  }

 private:
  void leave_out_doubles() {
    for (std::size_t i = 2; i + 1 < film_.frames.size(); ++i)
      if (is_double(film_.frames, i)) {
        film_.frames.erase(film_.frames.begin() + static_cast<std::ptrdiff_t>(i));
        ++film_.doubled;
      }
  }

  [[nodiscard]] InputError refused(std::string rule) const {
    return InputError({.file = film_.file, .place = "", .rule = std::move(rule), .value = ""});
  }

  void take(const Picture& picture) {
    if (film_.pictures++ == 0) begin(picture);
    if (picture.grey == last_) {
      ++film_.doubled;
      return;
    }
    if (film_.pictures > 1 && picture.time <= last_time_)
      throw refused(fmt::format("must have time stamps that increase; picture {} is stamped {:.6g} s after {:.6g} s",
                                film_.pictures, picture.time, last_time_));
    Frame frame{.time = picture.time, .sightings = tracker_.tags_of(picture)};
    if (request_.led) frame.led = light_at(picture, *request_.led);
    if (frame.sightings.empty() && ids_.empty()) look_into_the_mirror(picture);
    for (const Sighting& each : frame.sightings) ids_.insert(each.id);
    if (request_.preview) request_.preview(picture, frame);
    film_.frames.push_back(std::move(frame));
  }

  void begin(const Picture& picture) {
    film_.width = picture.width;
    film_.height = picture.height;
    const bool inside = !request_.led || (request_.led->minCoeff() >= 0.0 && request_.led->x() < film_.width &&
                                          request_.led->y() < film_.height);
    if (!inside)
      throw refused(fmt::format("must show the LED: its place {:g},{:g} is outside of the picture of {} by {} px",
                                request_.led->x(), request_.led->y(), film_.width, film_.height));
  }

  void look_into_the_mirror(const Picture& picture) {
    constexpr std::size_t tries = 3;
    if (film_.pictures > tries) return;
    if (!vision_.find_tags(mirrored(picture), {.width = picture.width, .height = picture.height}).empty())
      throw refused("must not be mirrored, as by a phone's front camera; its tags can be read in a mirror only");
  }

  void require_content() const {
    if (film_.pictures == 0) throw refused("must have pictures that can be decoded; the first one cannot");
    if (film_.frames.size() < 2)
      throw refused(film_.pictures == 1
                        ? "must be a film; it has one picture"
                        : fmt::format("must be a film; its {} pictures are one and the same", film_.pictures));
    if (ids_.empty())
      throw refused(
          "must show a tag of `coilwright tag`; none was found: light it, hold it in focus, at least 15 px wide");
  }

  const Vision& vision_;
  const TrackRequest& request_;
  TagTracker tracker_;
  TrackedFilm film_;
  std::vector<std::uint8_t> last_;
  double last_time_{};
  std::set<int> ids_;
};

}  // namespace

TrackedFilm track_film(const Vision& vision, const std::filesystem::path& file, const TrackRequest& request) {
  try {
    return FilmTracker(vision, file, request).track();
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& rule) {
    throw InputError({.file = file.string(), .place = "", .rule = rule.what(), .value = ""});
  }
}

}  // namespace coilwright::video
