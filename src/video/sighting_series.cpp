#include "video/sighting_series.hpp"

#include <algorithm>

namespace coilwright::video {
namespace {

// Slope at `at` of the parabola through three sightings.
Place slope(const SeriesEntry& a, const SeriesEntry& b, const SeriesEntry& c, double at) {
  const Place first = (b.sighting->centre - a.sighting->centre) / (b.time - a.time);
  const Place second = (c.sighting->centre - b.sighting->centre) / (c.time - b.time);
  const Place bend = (second - first) / (c.time - a.time);
  return first + bend * (2.0 * at - a.time - b.time);
}

}  // namespace

std::vector<SeriesEntry> series_of(const TrackedFilm& film, int id, double time_scale) {
  std::vector<SeriesEntry> out;
  for (const Frame& frame : film.frames) {
    const auto found = std::ranges::find(frame.sightings, id, &Sighting::id);
    if (found != frame.sightings.end()) out.push_back({.time = frame.time * time_scale, .sighting = &*found});
  }
  for (std::size_t i = 0; i < out.size() && out.size() >= 3; ++i) {
    const std::size_t middle = std::clamp<std::size_t>(i, 1, out.size() - 2);
    out[i].velocity = slope(out[middle - 1], out[middle], out[middle + 1], out[i].time);
  }
  return out;
}

}  // namespace coilwright::video
