#pragma once

#include <cstddef>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "measurement/replay/input_noise.hpp"

namespace coilwright::measurement::replay {

/// Between rows at most this far apart, s, a cubic gives the motion of a finger at 10 Hz within 1e-5 of its amplitude.
inline constexpr double densest_needed = 0.004;

/// Under a constant input a finger comes to rest, or creeps; it does not hum. After so long, s, what rang has died
/// away.
inline constexpr double ringing_time = 3.0;

/// One value per input column, in the units of the command.
using InputRow = std::vector<double>;

/// What the samples of an input say of the time between them: rows, and the time from which each is in force.
struct InputRows {
  std::vector<double> times{};         ///< s, ascending
  std::vector<InputRow> rows{};        ///< one per time
  std::vector<std::size_t> samples{};  ///< of the input from which each is
  std::vector<double> shares{};        ///< of the way to the next sample at which it is, 0 to 1
  std::vector<double> half_widths{};   ///< of the edge with which a row begins, s; 0 where it begins at a known time
  std::vector<InputRow> bends{};       ///< what a smooth curve has more than the row
  std::vector<char> straight{};        ///< whether the input goes straight to the next row instead of being held
  std::vector<char> smooth{};          ///< whether that is part of a smooth curve; straight as well

  /// At a time from that of row `row` to that of the next one, s.
  [[nodiscard]] InputRow at(std::size_t row, double time) const;
};

/// The rows of a run's input as its `hold` says: steps, straight lines, or lines with edges somewhere between two
/// samples. Where samples are close enough, a smooth curve that moves a finger as the steps (through their middles) or
/// the lines do, so that no integration has to stop at each sample.
[[nodiscard]] InputRows input_rows(const data::Run& run, const CleanInput& clean);

/// The largest change of a column from one row to another.
[[nodiscard]] double size_of_step(const InputRow& from, const InputRow& to);

}  // namespace coilwright::measurement::replay
