#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "truth/camera.hpp"

namespace truth::laboratory {

/// How far the built finger is from the numbers that are declared: not at all, within their tolerances, or far outside.
enum class Deviation { none, within, far };

/// What the set says of the tolerances: that there are none, all of them, or nothing.
enum class Tolerances { exact, listed, absent };

/// Where the input is written: beside each picture, in a file with every change, or in a file with samples of its own.
enum class InputLog { beside_pictures, every_change, own_samples };

enum class Colour { white, low_passed, pink, hum };

/// Faces that are declared: none, faces that the finger does not have, or faces that meet at another angle.
enum class DeclaredFaces { none, absent, elsewhere };

enum class Programme { paper, few, one, sines, rig_changes, hold };

struct CameraFaults {
  double frame_rate = 500.0;    ///< 1/s
  double exposure_share = 0.0;  ///< exposure over the time between pictures, 0 to 0.9
  double jitter = 0.0;  ///< s, standard deviation of a picture's time about its stamp; at most a tenth of that time
};

struct ClockFaults {
  InputLog log = InputLog::beside_pictures;
  double smallest_offset = 0.0;  ///< s, between the clocks of camera and input, of either sign and another in each run
  double largest_offset = 0.0;   ///< s
  double rate = 0.0;             ///< relative difference of both clocks, of either sign and the same in all runs
  double latest_start = 0.0;     ///< s, by which the first picture comes after the input has begun, at most
  double own_rate = 200.0;       ///< samples of the input per second, in a file with samples of its own
};

struct NoiseFaults {
  Colour colour = Colour::white;
  double level = 0.0052;  ///< standard deviation of an angle, rad
  bool still_run = false;
  bool sigma_given = false;
  double outliers = 0.0;     ///< share of the pictures that show an angle wrong by 3 to 10 degrees
  double input_noise = 0.0;  ///< A, standard deviation of the recorded current: the true one is clean
};

/// A set as a laboratory would make it.
struct Request {
  std::vector<std::string> hidden{};  ///< names of hidden kinds
  std::uint64_t seed = 1;
  Camera channels = Camera::bending_angle;
  Programme programme = Programme::paper;

  Deviation deviation = Deviation::none;
  Tolerances tolerances = Tolerances::exact;
  DeclaredFaces faces = DeclaredFaces::none;
  CameraFaults camera{};
  ClockFaults clocks{};
  NoiseFaults noise{};

  double weakest = 3.0;  ///< smallest strength of a hidden effect, in standard deviations of the noise
  double strongest = 15.0;
  bool at_bound = false;         ///< effects at their physical bounds, or as strong as `strongest` before that
  std::vector<double> values{};  ///< of the first number of each hidden effect, in place of a strength; or empty
  bool find_confounders = false;
};

}  // namespace truth::laboratory
