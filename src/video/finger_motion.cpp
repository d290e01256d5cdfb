#include "coilwright/video/finger_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "coilwright/text/input_error.hpp"
#include "video/course_scatter.hpp"
#include "video/plane_view.hpp"
#include "video/shutter.hpp"

namespace coilwright::video {
namespace {

using text::InputError;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

double median_interval_of(const TrackedFilm& film) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < film.frames.size(); ++i)
    intervals.push_back(film.frames[i].time - film.frames[i - 1].time);
  return median_of(intervals);
}

// What a film shows beyond doubt; 0 with the sigma where it does not.
CameraEstimate significant(double value, double sigma) {
  const CameraEstimate found{.value = value, .sigma = std::isfinite(sigma) ? sigma : HUGE_VAL};
  return {.value = std::abs(value) > found.least_seen() ? value : 0.0, .sigma = found.sigma};
}

CameraEstimate readout_of(const TrackedFilm& film, const CameraKnowledge& camera,
                          std::span<const std::vector<SeriesEntry>> series) {
  if (camera.readout) return {.value = *camera.readout};
  const LastCoefficient row = row_time_of(series, direction_of_rows(film));
  return significant(row.value * rows_of(film), row.sigma * rows_of(film));
}

CameraEstimate exposure_of(const CameraKnowledge& camera, std::span<const std::vector<SeriesEntry>> series) {
  if (camera.exposure) return {.value = *camera.exposure};
  const LastCoefficient square = squared_exposure_of(series);
  const CameraEstimate of_square = significant(square.value, square.sigma);
  if (of_square.value <= 0.0) return {.sigma = std::sqrt(std::max(0.0, square.sigma))};
  const double exposure = std::sqrt(of_square.value);
  return {.value = exposure, .sigma = 0.5 * square.sigma / exposure};
}

std::vector<int> ids_of(const TrackedFilm& film) {
  std::set<int> ids;
  for (const Frame& frame : film.frames)
    for (const Sighting& each : frame.sightings) ids.insert(each.id);
  return {ids.begin(), ids.end()};
}

void require_tags(const TrackedFilm& film, const std::vector<int>& ids) {
  const auto refuse = [&](std::string rule) {
    return InputError({.file = film.file, .place = "", .rule = std::move(rule), .value = ""});
  };
  if (ids.empty() || ids.front() != 0)
    throw refuse("must show the base's tag, number 0, against which angles are taken; it was never read");
  if (ids.size() < 2) throw refuse("must show a tag on the finger beside the base's; none was read");
}

// Angle of each entry on the container's clock, not yet against the base.
std::vector<AngleSample> angles_of(const TrackedFilm& film, const std::vector<SeriesEntry>& series,
                                   std::span<const TagView> views, const PlaneView& plane, double readout) {
  std::vector<AngleSample> out;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double angle = std::arg(ComplexMap(plane.shape(views[i])).alike);
    out.push_back(
        {.time = series[i].time + readout * share_of_readout(film, series[i].sighting->centre),
         .angle = out.empty() ? angle : out.back().angle + std::remainder(angle - out.back().angle, 2.0 * M_PI),
         .sigma = series[i].sighting->sigma});
  }
  return out;
}

// The base at a time: its mean where it scatters as its own noise does, otherwise what it was nearest to then.
class Base {
 public:
  explicit Base(std::vector<AngleSample> samples) : samples_(std::move(samples)) {
    double weights = 0.0;
    for (const AngleSample& each : samples_) {
      weights += 1.0 / (each.sigma * each.sigma);
      mean_.angle += each.angle / (each.sigma * each.sigma);
    }
    mean_.angle /= weights;
    mean_.sigma = 0.0;  // an error of the mean is one of the zero, and the same in all samples
    double chi_square = 0.0;
    for (const AngleSample& each : samples_) chi_square += std::pow((each.angle - mean_.angle) / each.sigma, 2);
    constexpr double noise_alone = 4.0;
    steady_ = chi_square < noise_alone * static_cast<double>(samples_.size());
  }
  [[nodiscard]] AngleSample at(double time) const {
    if (steady_) return mean_;
    const auto after = std::ranges::lower_bound(samples_, time, {}, &AngleSample::time);
    if (after == samples_.end()) return samples_.back();
    if (after == samples_.begin() || after->time - time < time - std::prev(after)->time) return *after;
    return *std::prev(after);
  }

 private:
  std::vector<AngleSample> samples_;
  AngleSample mean_{};
  bool steady_{};
};

std::vector<AngleSample> against(const Base& base, std::vector<AngleSample> samples) {
  double turns = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const AngleSample zero = base.at(samples[i].time);
    double angle = samples[i].angle - zero.angle;
    if (i == 0) turns = std::remainder(angle, 2.0 * M_PI) - angle;
    samples[i].angle = angle + turns;
    samples[i].sigma = std::hypot(samples[i].sigma, zero.sigma);
  }
  return samples;
}

using Tags = std::vector<TagMotion>;

// The tags but the base, once the camera is turned onto the normal of their plane.
Tags turned_onto(const PlaneView& plane, std::span<const std::vector<TagView>> views, const TrackedFilm& film,
                 std::span<const int> ids, std::span<const std::vector<SeriesEntry>> series, double readout) {
  const Base base(angles_of(film, series.front(), views.front(), plane, readout));
  Tags out;
  for (std::size_t k = 1; k < ids.size(); ++k)
    out.push_back({.id = ids[k], .samples = against(base, angles_of(film, series[k], views[k], plane, readout))});
  return out;
}

// What a lens makes of the film: the tags, and as they are if the plane leans the other way, which it may.
struct SeenTags {
  Tags tags{};
  std::optional<Tags> otherwise{};
  double tilt{};
};

SeenTags seen_through(const Lens& lens, const TrackedFilm& film, std::span<const int> ids,
                      std::span<const std::vector<SeriesEntry>> series, double readout) {
  std::vector<std::vector<TagView>> views;
  for (const auto& each : series) {
    views.emplace_back();
    for (const SeriesEntry& entry : each)
      views.back().push_back(view_of(lens, entry.sighting->centre,
                                     without_rolling(entry, readout / rows_of(film), direction_of_rows(film))));
  }
  const FittedPlane fitted = fit_plane(views);
  SeenTags out{.tags = turned_onto(fitted.plane, views, film, ids, series, readout), .tilt = fitted.plane.tilt()};
  if (fitted.rival) out.otherwise = turned_onto(*fitted.rival, views, film, ids, series, readout);
  return out;
}

// The largest mean difference of a tag's angle, rad.
double mean_difference(const Tags& one, const Tags& other) {
  double most = 0.0;
  for (std::size_t k = 0; k < other.size(); ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < other[k].samples.size(); ++i)
      sum += one[k].samples[i].angle - other[k].samples[i].angle;
    most = std::max(most, std::abs(sum) / static_cast<double>(other[k].samples.size()));
  }
  return most;
}

}  // namespace

FingerMotion finger_motion(const TrackedFilm& film, const CameraKnowledge& camera) {
  const std::vector<int> ids = ids_of(film);
  require_tags(film, ids);
  const double container_interval = median_interval_of(film);
  const double time_scale = camera.frame_rate ? 1.0 / (*camera.frame_rate * container_interval) : 1.0;
  std::vector<std::vector<SeriesEntry>> series;
  for (const int id : ids) series.push_back(series_of(film, id, time_scale));
  FingerMotion out{.interval = container_interval * time_scale, .time_scale = time_scale};
  out.readout = readout_of(film, camera, series);
  out.exposure = exposure_of(camera, series);
  const Lens lens = camera.lens ? *camera.lens : usual_lens(film.width, film.height);
  SeenTags seen = seen_through(lens, film, ids, series, out.readout.value);
  out.tags = std::move(seen.tags);
  out.tilt = seen.tilt;
  if (seen.otherwise) out.view_bias = mean_difference(*seen.otherwise, out.tags);
  // From a lens of twice the usual length to a wide one.
  constexpr double degree = M_PI / 180.0;
  constexpr std::array other_views{35.0 * degree, 85.0 * degree};
  for (const double view : other_views) {
    if (camera.lens) break;
    const Lens other = plain_lens(film.width, film.height, view);
    const SeenTags through = seen_through(other, film, ids, series, out.readout.value);
    out.view_bias = std::max(out.view_bias, mean_difference(through.tags, out.tags));
  }
  for (TagMotion& tag : out.tags) tag.samples = with_shown_scatter(std::move(tag.samples), out.interval);
  return out;
}

}  // namespace coilwright::video
