#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/video/lens.hpp"
#include "coilwright/video/picture.hpp"

namespace coilwright::video {

/// The pictures of a file, one after the other.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// Decodes the next picture into `picture`; returns false after the last, and if the file is damaged. The time of a
  /// picture without a stamp is NaN.
  [[nodiscard]] virtual bool next(Picture& picture) = 0;
  /// Clockwise turn of the sensor's pictures that the container asks of a player, in quarters, 0 to 3. The decoded
  /// pictures are turned already.
  [[nodiscard]] virtual int quarter_turns() const = 0;
};

/// A calibrated lens, and its error on the boards of its calibration.
struct CalibratedLens {
  Lens lens{};
  double rms{};  ///< px, distance of the corners from their places by the lens
};

/// The functions that OpenCV provides. Their one implementation is a module that is loaded when a command needs it,
/// because OpenCV brings some 250 libraries, which take 0.15 s to load. They throw std::runtime_error whose text is the
/// rule.
class Vision {
 public:
  virtual ~Vision() = default;
  /// Opens a film. Throws if the file has no pictures that can be decoded.
  [[nodiscard]] virtual std::unique_ptr<PictureSource> open(const std::filesystem::path& file) const = 0;
  /// Finds tags with their outlines, to about a pixel.
  [[nodiscard]] virtual std::vector<TagCorners> find_tags(const Picture& picture, const Area& area) const = 0;
  /// Finds the inner corners of the board, row after row; absent if not all are visible.
  [[nodiscard]] virtual std::optional<std::vector<Place>> find_board(const Picture& picture) const = 0;
  /// Fits the lens to the corners of these boards, in pixels, in pictures of that size.
  [[nodiscard]] virtual CalibratedLens calibrate(std::span<const std::vector<Place>> boards, int width,
                                                 int height) const = 0;
  /// The picture as PNG with the outlines drawn in.
  [[nodiscard]] virtual std::string png(const Picture& picture, std::span<const TagCorners> tags) const = 0;
};

/// Loads the module. Throws std::runtime_error with the packages to install if the program was built without it.
[[nodiscard]] const Vision& load_vision();

}  // namespace coilwright::video
