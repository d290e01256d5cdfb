#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "coilwright/video/tracked_film.hpp"

namespace coilwright::video {

/// A tag in one picture, with how fast it went.
struct SeriesEntry {
  double time{};  ///< s, of the picture
  const Sighting* sighting{};
  Place velocity = Place::Zero();  ///< px/s
};

/// All sightings of one tag. `film` must outlive them.
[[nodiscard]] std::vector<SeriesEntry> series_of(const TrackedFilm& film, int id, double time_scale);

/// A linear map of the plane as z -> alike z + mirrored conj(z), with z = x + iy.
struct ComplexMap {
  std::complex<double> alike;
  std::complex<double> mirrored;
  explicit ComplexMap(const Eigen::Matrix2d& map)
      : alike(0.5 * (map(0, 0) + map(1, 1)), 0.5 * (map(1, 0) - map(0, 1))),
        mirrored(0.5 * (map(0, 0) - map(1, 1)), 0.5 * (map(1, 0) + map(0, 1))) {}
  /// What keeps a square from being drawn as one, in the picture's frame whatever the turn of the square.
  [[nodiscard]] std::complex<double> skew() const { return mirrored / std::conj(alike); }
};

}  // namespace coilwright::video
