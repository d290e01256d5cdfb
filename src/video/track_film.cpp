#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "coilwright/text/input_error.hpp"
#include "coilwright/video/tracked_film.hpp"
#include "video/motion_start.hpp"
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

// The angles of a tag, as it stands in the pictures that show it.
std::vector<AngleSample> angles_of(std::span<const Frame> frames, int id) {
  std::vector<AngleSample> out;
  for (const Frame& frame : frames)
    if (const auto tag = std::ranges::find(frame.sightings, id, &Sighting::id); tag != frame.sightings.end()) {
      const double last = out.empty() ? 0.0 : out.back().angle;
      const double turn = std::remainder(picture_angle(tag->shape) - last, 2.0 * M_PI);
      out.push_back({.time = frame.time, .angle = last + turn, .sigma = tag->sigma});
    }
  return out;
}

// Standard deviations by which a tag turned, positive where its angle grew.
double turn_between(const AngleSample& from, const AngleSample& to) {
  return (to.angle - from.angle) / std::hypot(from.sigma, to.sigma);
}

// Whether the tag would have begun to move in sample `i`, which stands as those before it do, had that been a new one.
// In sample `next` it has moved.
bool hides_a_start(std::span<const AngleSample> samples, std::size_t i, std::size_t next, double interval) {
  std::vector<double> sigmas;
  for (const AngleSample& each : samples.subspan(next, std::min<std::size_t>(6, samples.size() - next)))
    sigmas.push_back(each.sigma);
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::ranges::nth_element(sigmas, middle);
  constexpr double stands = 3.0;  // standard deviations
  constexpr std::size_t resting = 12;
  constexpr std::size_t fewest = 5;  // of which fewer stand so at a turning point from which it moves as fast
  constexpr std::size_t moving = 8;
  const double still = samples[i < 2 ? 0 : i - 2].angle;  // the sample before may have seen it begin
  std::size_t begin = i - 1;
  while (begin > 0 && i - begin < resting && std::abs(samples[begin - 1].angle - still) < stands * *middle) --begin;
  if (i - begin < fewest) return false;
  double rest = 0.0;
  for (std::size_t k = begin; k + 1 < i; ++k) rest += samples[k].angle / static_cast<double>(i - 1 - begin);
  const auto window = samples.subspan(begin, std::min(samples.size() - begin, next - begin + moving));
  constexpr double all_but_sure = 0.9;
  return motion_start(window, next - begin, rest, *middle, interval).repeated[i - begin] > all_but_sure;
}

// Whether a sample shows the picture before once more. A double that was compressed is not the same to the bit: the tag
// stands within its deviation, between samples over which it turns the same way beyond doubt, or begins to.
bool is_repeat(std::span<const AngleSample> samples, std::size_t i, double interval) {
  constexpr double beyond_doubt = 5.0;
  constexpr std::size_t in_a_row = 2;
  if (std::abs(turn_between(samples[i - 1], samples[i])) > 1.0) return false;
  for (std::size_t next = i + 1; next < samples.size() && next - i <= in_a_row; ++next) {
    const double after = turn_between(samples[i - 1], samples[next]);
    if (std::abs(after) <= beyond_doubt) continue;
    const double before = i >= 2 ? turn_between(samples[i - 2], samples[i - 1]) : 0.0;
    return std::abs(before) > beyond_doubt ? before * after > 0.0 : hides_a_start(samples, i, next, interval);
  }
  return false;
}

// Whether all tags of a frame stand as in the frame before.
bool stands_as(const Frame& before, const Frame& frame) {
  return std::ranges::all_of(frame.sightings, [&](const Sighting& tag) {
    const auto angles = angles_of(std::array{before, frame}, tag.id);
    return angles.size() == 2 && std::abs(turn_between(angles[0], angles[1])) <= 1.0;
  });
}

class FilmTracker {
 public:
  FilmTracker(const Vision& vision, const std::filesystem::path& file, const TrackRequest& request)
      : vision_(vision), request_(request), tracker_(vision), film_{.file = file.string()} {}

  TrackedFilm track() {
    const auto source = vision_.open(film_.file);
    Picture picture;
    film_.quarter_turns = source->quarter_turns();
    while (source->next(picture)) {
      if (std::isnan(picture.time)) {
        ++film_.unstamped;
        continue;
      }
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
    const double interval = (last_time_ - film_.frames.front().time) / static_cast<double>(film_.pictures - 1);
    for (const int id : ids_) {
      std::vector<AngleSample> samples = angles_of(film_.frames, id);
      for (std::size_t i = 1; i + 1 < samples.size();)
        if (is_repeat(samples, i, interval) && leave_out_double(samples[i].time))
          samples.erase(samples.begin() + static_cast<std::ptrdiff_t>(i));
        else
          ++i;
    }
  }

  bool leave_out_double(double time) {
    const auto frame = std::ranges::lower_bound(film_.frames, time, {}, &Frame::time);
    if (!stands_as(*std::prev(frame), *frame)) return false;
    film_.frames.erase(frame);
    ++film_.doubled;
    return true;
  }

  [[nodiscard]] InputError refused(std::string rule) const {
    return InputError({.file = film_.file, .place = "", .rule = std::move(rule), .value = ""});
  }

  void take(const Picture& picture) {
    if (film_.pictures++ == 0) begin(picture);
    const bool same = picture.grey == last_;
    // Where compression changes few pixels from one still picture to the next, it changes none now and then: that is no
    // double, unless the motion says so.
    constexpr double noise_shows = 0.5;
    if (same && changed_ > noise_shows) {
      ++film_.doubled;
      return;
    }
    if (!same && picture.grey.size() == last_.size())
      changed_ = std::inner_product(last_.begin(), last_.end(), picture.grey.begin(), 0.0, std::plus<>(),
                                    std::not_equal_to<>()) /
                 static_cast<double>(last_.size());
    if (film_.pictures > 1 && picture.time <= last_time_)
      throw refused(fmt::format("must have time stamps that increase; picture {} is stamped {:.6g} s after {:.6g} s",
                                film_.pictures, picture.time, last_time_));
    Frame frame{.time = picture.time, .sightings = same ? film_.frames.back().sightings : tracker_.tags_of(picture)};
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
  double changed_{1.0};  // share of the pixels that the last picture that was no repeat changed
  std::set<int> ids_;
};

}  // namespace

// Of the sensor downwards; a picture that was turned clockwise has it to the left.
Place direction_of_rows(const TrackedFilm& film) {
  const std::array<Place, 4> turned{Place(0.0, 1.0), Place(-1.0, 0.0), Place(0.0, -1.0), Place(1.0, 0.0)};
  return turned.at(static_cast<std::size_t>(film.quarter_turns));
}

int rows_of(const TrackedFilm& film) {
  return film.quarter_turns % 2 == 0 ? film.height : film.width;
}

double share_of_readout(const TrackedFilm& film, const Place& place) {
  const Place middle = 0.5 * Place(film.width - 1, film.height - 1);
  return direction_of_rows(film).dot(place - middle) / rows_of(film);
}

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
