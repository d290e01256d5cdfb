#pragma once

#include <vector>

#include "truth/laboratory/programmes.hpp"

namespace truth::laboratory {

/// How the clock of the pictures reads against that of the input in one run: a stamp s is the time
/// (1 + rate) s + offset.
struct RunClock {
  double offset{};  ///< s
  double rate{};
};

/// A picture that shows a wrong angle.
struct Outlier {
  double time{};  ///< s, its stamp
  double by{};    ///< rad
};

/// One run as it is written down.
struct RecordedRun {
  PlannedRun planned;
  RunClock clock;
  std::vector<double> stamps;                   ///< s, of the pictures
  std::vector<std::vector<double>> angles_deg;  ///< a row per picture
  std::vector<double> input_times;              ///< s; of the pictures, or of the input's own file
  std::vector<double> currents;                 ///< A, as recorded
  std::vector<Outlier> outliers;
};

/// Readings are rounded to its multiples, deg.
inline constexpr double resolution_deg = 0.02;

}  // namespace truth::laboratory
