#pragma once

#include <optional>
#include <vector>

#include "coilwright/video/lens.hpp"
#include "coilwright/video/tracked_film.hpp"

namespace coilwright::video {

/// What is known of the camera beside what the film shows.
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
  double sigma{};  ///< rad
};

/// The angles of a tag over time.
struct TagMotion {
  int id{};
  std::vector<AngleSample> samples{};
};

/// A number that the film gives, or not.
struct CameraEstimate {
  double value{};  ///< s
  double sigma{};  ///< s; 0 where it was given
};

/// What a finger did.
struct FingerMotion {
  std::vector<TagMotion> tags{};  ///< but the base, by id
  double interval{};              ///< s, median, between pictures
  double time_scale{1.0};         ///< of the container's time stamps, to seconds
  CameraEstimate readout{};
  CameraEstimate exposure{};
  double tilt{};  ///< rad, of the optical axis from the normal of the plane of motion
  /// By how much the mean angle of a tag may be off, rad: as a lens that was not given may see 35 to 85 degrees over
  /// the longer side of the picture, and as the film may not tell to which side the plane leans.
  double view_bias{};
};

/// Throws text::InputError where the film has no base or no other tag, or too few pictures.
[[nodiscard]] FingerMotion finger_motion(const TrackedFilm& film, const CameraKnowledge& camera = {});

}  // namespace coilwright::video
