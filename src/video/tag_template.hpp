#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

namespace coilwright::video {

/// A blurred tag and its derivatives: value, u, v, uu, uv, vv. Coordinates in modules from its centre, u to the right
/// of the upright tag, v down; black is 0, white 1.
using TagSlopes = Eigen::Matrix<float, 6, 1>;

/// One tag under one Gaussian blur, on a grid fine enough that a second-order step from its nodes is exact to 0.1 %.
class TagTemplate {
 public:
  /// `blur`: standard deviation, modules; > 0.
  TagTemplate(int tag, double blur);
  /// Value and slopes at a place, up to tag_reach() from the centre in both directions.
  [[nodiscard]] TagSlopes at(double u, double v) const;
  [[nodiscard]] double blur() const noexcept { return blur_; }

 private:
  double blur_;
  std::vector<TagSlopes> grid_;
};

/// Half the side of the square that is compared, modules: the tag and a part of its white margin.
[[nodiscard]] constexpr double tag_reach() {
  return 3.6;
}

/// Templates of all tags under blurs in steps of a quarter, made when first asked for.
class TagTemplates {
 public:
  /// The one whose blur is nearest.
  [[nodiscard]] const TagTemplate& of(int tag, double blur);

 private:
  std::map<std::pair<int, int>, TagTemplate> made_;
};

}  // namespace coilwright::video
