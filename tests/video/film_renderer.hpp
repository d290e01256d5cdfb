#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// Draws films of a finger with printed tags. It shares no line with what reads them.
namespace film {

/// A motion: joint angles over time, s and rad, straight between samples.
struct Motion {
  std::vector<double> times;
  std::vector<std::array<double, 2>> angles;  ///< of the two joints, positive towards the right of the picture
  [[nodiscard]] std::array<double, 2> at(double time) const;
};

/// The camera, the light and the finger in front of it. Lengths in mm; the picture's x to the right, y down.
struct Scene {
  int width = 640;
  int height = 480;
  double focal = 600.0;                        ///< px
  std::array<double, 2> distortion{};          ///< k1, k2 of Brown
  std::array<double, 2> tilt{};                ///< rad, of the camera about its x and y axes, round the scene's middle
  double px_per_mm = 5.0;                      ///< in the middle of the picture
  double tag = 8.0;                            ///< side of the black square
  std::array<double, 2> middle{10.0, 20.0};    ///< place of the finger's plane in the middle of the picture
  double rate = 240.0;                         ///< frames a second
  double duration = 1.0;                       ///< s
  double exposure = 1e-3;                      ///< s
  double readout = 0.0;                        ///< s, from the sensor's first row to its last
  int quarter_turns = 0;                       ///< clockwise, of the picture against the sensor
  double optics = 0.6;                         ///< px, standard deviation of the blur of the lens
  double white = 200.0;                        ///< grey of paper
  double noise = 2.0;                          ///< grey, standard deviation at white; falls with the root of the light
  std::array<double, 3> led{-1.0, -1.0, 0.0};  ///< x, y (px), time at which it is lit; none where x < 0
  bool segment_tag = true;                     ///< a tag on the first segment too
  bool board = false;                          ///< the chessboard instead of the finger, hand-held
  std::uint64_t seed = 1;
};

/// Draws one picture after the other.
class Renderer {
 public:
  Renderer(const Scene& scene, Motion motion);
  /// The picture whose middle row's exposure is centred on `time`; grey, row after row.
  [[nodiscard]] std::vector<std::uint8_t> render(double time, int number);

 private:
  void see(int number);

  Scene scene_;
  Motion motion_;
  std::vector<std::array<double, 2>> rays_;  // of each corner between pixels: its ray, at the depth of 1
  std::vector<std::array<float, 6>> seen_;   // of each pixel: its place in the scene, and the derivatives of that
  std::vector<float> still_;                 // light of each pixel without the finger's segments
};

}  // namespace film
