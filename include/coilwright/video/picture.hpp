#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace coilwright::video {

/// A place in a picture, px: x to the right, y down, whole numbers at the centres of pixels.
using Place = Eigen::Vector2d;

/// A picture of a film, in grey.
struct Picture {
  double time{};  ///< s, as its container stamps it
  int width{};
  int height{};
  std::vector<std::uint8_t> grey{};  ///< row after row

  /// The grey of a pixel, 0 to 255; x from the left and y from the top, inside the picture.
  [[nodiscard]] double at(int x, int y) const {
    return grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

/// A rectangle of whole pixels.
struct Area {
  int left{};
  int top{};
  int width{};
  int height{};
};

/// The black square of a tag that was found.
struct TagCorners {
  int id{};
  std::array<Place, 4> corners{};  ///< of the upright tag: left top, right top, right bottom, left bottom
};

}  // namespace coilwright::video
