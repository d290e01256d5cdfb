#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/video/picture.hpp"
#include "coilwright/video/vision.hpp"

namespace coilwright::video {

/// A tag in a picture.
struct Sighting {
  int id{};
  Place centre{};
  Eigen::Matrix2d shape{};  ///< derivative of the place in the picture by that on the tag at its centre, px a module
  double sigma{};           ///< rad, standard deviation of its angle in the picture
  Eigen::Matrix2d blur{};   ///< px^2, second moments of the blur
  TagCorners outline{};
};

/// A picture in which a tag was read.
struct Frame {
  double time{};                      ///< s, as the container stamps it
  double led{};                       ///< mean grey where the LED is, 0 to 255; 0 where none was asked for
  std::vector<Sighting> sightings{};  ///< tags by id, each once
};

/// The tags in the pictures of a film.
struct TrackedFilm {
  std::string file{};
  int width{};
  int height{};
  std::size_t pictures{};   ///< decoded
  std::size_t doubled{};    ///< pictures that repeat the one before, and are left out
  std::size_t unstamped{};  ///< pictures without a time stamp, which are left out: the last ones of some films
  /// Clockwise turn of the pictures relative to the camera's sensor, in quarters, 0 to 3.
  int quarter_turns{};
  std::vector<Frame> frames{};
};

/// The direction in a picture, a unit vector, in which the sensor's rows follow each other from first to last.
[[nodiscard]] Place direction_of_rows(const TrackedFilm& film);
/// Number of rows of the sensor that took a film.
[[nodiscard]] int rows_of(const TrackedFilm& film);
/// Delay of the exposure of a place after the middle row, as a share of the time in which all rows are read out, -0.5
/// to 0.5.
[[nodiscard]] double share_of_readout(const TrackedFilm& film, const Place& place);

/// The tags to find in a film.
struct TrackRequest {
  std::optional<Place> led{};
  std::function<void(const Picture&, const Frame&)> preview{};  ///< called with every frame, if given
};

/// Follows the tags through a film. Throws text::InputError in one line: no picture, no tag, mirrored, two like tags,
/// identical pictures, times that do not increase.
[[nodiscard]] TrackedFilm track_film(const Vision& vision, const std::filesystem::path& file,
                                     const TrackRequest& request = {});

}  // namespace coilwright::video
