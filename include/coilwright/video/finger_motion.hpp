#pragma once

#include <optional>
#include <vector>

#include "coilwright/video/lens.hpp"
#include "coilwright/video/tracked_film.hpp"

namespace coilwright::video {

/// Knowledge about the camera beside the film.
struct CameraKnowledge {
  std::optional<Lens> lens{};          ///< otherwise usual_lens()
  std::optional<double> readout{};     ///< s from the first row's exposure to the last row's; otherwise estimated
  std::optional<double> exposure{};    ///< s; otherwise estimated from the blur
  std::optional<double> frame_rate{};  ///< Hz, at which it was filmed; otherwise as the container says
};

/// The angle of a tag against the base.
struct AngleSample {
  double time{};   ///< s, when the middle of the tag was exposed, on the container's clock
  double angle{};  ///< rad, clockwise as seen, 0 where the tag stands as the base's
  double sigma{};  ///< rad, standard deviation: of what changes from one sample to another, not of a bias of the view
};

/// The angles of a tag over time.
struct TagMotion {
  int id{};
  std::vector<AngleSample> samples{};
};

/// A number that the film may show.
struct CameraEstimate {
  double value{};  ///< s; 0 where the film does not show beyond doubt that it is not
  double sigma{};  ///< s; 0 where it was given, infinite where nothing tells
  /// The least value that the film would show, s.
  [[nodiscard]] double least_seen() const noexcept { return 5.0 * sigma; }
};

/// The motion of a finger in a film.
struct FingerMotion {
  std::vector<TagMotion> tags{};  ///< motions of all tags but the base, by id
  double interval{};              ///< s, median, between pictures
  double time_scale{1.0};         ///< of the container's time stamps, to seconds
  CameraEstimate readout{};
  CameraEstimate exposure{};
  double tilt{};  ///< rad, of the optical axis from the normal of the plane of motion
  /// Bias of the mean angle of a tag, rad: by a lens that was not given and may see 35 to 85 degrees over the longer
  /// side of the picture, and by a plane whose lean the film may not show.
  double view_bias{};
};

/// Computes the motion. Throws text::InputError if the film has no base or no other tag, or too few pictures.
[[nodiscard]] FingerMotion finger_motion(const TrackedFilm& film, const CameraKnowledge& camera = {});

}  // namespace coilwright::video
