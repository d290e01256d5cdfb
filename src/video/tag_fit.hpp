#pragma once

#include <Eigen/Core>
#include <optional>

#include "coilwright/video/picture.hpp"
#include "coilwright/video/tracked_film.hpp"
#include "video/tag_template.hpp"

namespace coilwright::video {

/// From the picture (px) to the tag (modules from its centre), as a homography.
using ToTag = Eigen::Matrix3d;

/// The homography of an outline.
[[nodiscard]] ToTag to_tag(const TagCorners& outline);
/// The same tag, moved in the picture: turned by `turn`, rad, about `from`, which comes to `to`.
[[nodiscard]] ToTag moved(const ToTag& before, const Place& from, const Place& to, double turn);
/// Where a homography has a place of the tag in the picture.
[[nodiscard]] Place in_picture(const ToTag& homography, double u, double v);
/// Angle of the tag's rows in the picture, rad, from +x towards +y.
[[nodiscard]] double picture_angle(const Eigen::Matrix2d& shape);

/// A tag as it was fitted.
struct TagFit {
  ToTag homography{};
  Sighting sighting{};
  double blur{};  ///< modules, mean standard deviation
};

/// Least squares of all pixels of a tag: homography, light over the tag, contrast and blur, from a start that is off
/// by less than a module. Nothing where it does not end in a tag. The standard deviation of the angle is the
/// jackknife's over blocks of 16 by 16 pixels, the macroblocks of H.264, within which compression makes errors alike.
[[nodiscard]] std::optional<TagFit> fit_tag(const Picture& picture, int tag, const ToTag& start, double blur,
                                            TagTemplates& templates);

}  // namespace coilwright::video
