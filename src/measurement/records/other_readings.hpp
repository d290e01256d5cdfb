#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::records {

/// What the numbers of one column of a record may have been meant as: in another unit, counted the other way, or times
/// that are frame numbers. A number of memory is meant as factor * number + offset.
struct OtherReading {
  enum class Of { channels, input, positions, time };
  Of of{};
  std::string column{};  ///< "force_N"
  std::string looks_like{};
  std::string remedy{};
  double factor = 1.0;
  double offset = 0.0;                  ///< of a unit of temperature
  std::vector<std::size_t> channels{};  ///< all angles of a record together, any other by itself
  std::vector<double> data::Run::*position = nullptr;
  bool of_input_clock = true;  ///< whether a time is meant so in a file of the input alone, too
  bool counts = false;         ///< times that count by whole numbers, which are a sign by themselves
};

/// The readings of a record's columns in every other unit of the table (units::all_units) whose number differs by a
/// factor of 4 or more (50, of what is no channel), or by an offset, and with the other sign; of times that are whole
/// numbers one after the other (counts_by_ones) also as frames of the usual cameras. Positions are the angle, opening
/// and height of a bench.
[[nodiscard]] std::vector<OtherReading> other_readings(const data::Run& run);

/// Whether the times of a run are whole numbers, most of them one after the other, as pictures and rows are numbered.
[[nodiscard]] bool counts_by_ones(const data::Run& run);

/// What makes times of such numbers, at `rate` (1/s, > 0).
[[nodiscard]] std::string frame_remedy(double rate);

/// The record as it was meant then.
[[nodiscard]] data::Run read_as(data::Run run, const OtherReading& reading);

}  // namespace coilwright::measurement::records
