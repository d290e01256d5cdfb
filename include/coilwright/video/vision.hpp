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
  /// Decodes the next one into `picture`; false after the last, and where the file is damaged. The time of one that has
  /// no stamp is no number.
  [[nodiscard]] virtual bool next(Picture& picture) = 0;
  /// How far the container says that a player has to turn what the camera's sensor read, clockwise; the pictures are
  /// turned so already. Quarter turns, 0 to 3.
  [[nodiscard]] virtual int quarter_turns() const = 0;
};

/// A calibrated lens and how well it explains what it was calibrated with.
struct CalibratedLens {
  Lens lens{};
  double rms{};  ///< px, distance of the corners from where the lens draws them
};

/// What is left to OpenCV. Its one implementation is a module that is loaded when a command needs it, because OpenCV
/// brings some 250 libraries, which take 0.15 s to load. What it throws is a std::runtime_error whose text is the rule.
class Vision {
 public:
  virtual ~Vision() = default;
  /// Throws where the file has no pictures that can be decoded.
  [[nodiscard]] virtual std::unique_ptr<PictureSource> open(const std::filesystem::path& file) const = 0;
  /// Tags with their outlines, to about a pixel.
  [[nodiscard]] virtual std::vector<TagCorners> find_tags(const Picture& picture, const Area& area) const = 0;
  /// Inner corners of the board, row after row; nothing where not all are seen.
  [[nodiscard]] virtual std::optional<std::vector<Place>> find_board(const Picture& picture) const = 0;
  /// The lens by which the corners of these boards, in pixels, lie where they were seen in pictures of that size.
  [[nodiscard]] virtual CalibratedLens calibrate(std::span<const std::vector<Place>> boards, int width,
                                                 int height) const = 0;
  /// The picture as PNG with the outlines drawn in.
  [[nodiscard]] virtual std::string png(const Picture& picture, std::span<const TagCorners> tags) const = 0;
};

/// Loads the module. Throws std::runtime_error that says what to install where the program was built without.
[[nodiscard]] const Vision& load_vision();

}  // namespace coilwright::video
