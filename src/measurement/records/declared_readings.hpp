#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "measurement/fit/hypothesis.hpp"

namespace coilwright::measurement::records {

/// Whether a channel is of a bending or a joint angle.
[[nodiscard]] bool is_angle(const data::Channel& channel);

/// Whether a run is a motion from rest that has an angle.
[[nodiscard]] bool is_motion_of_angles(const data::Run& run);

/// A channel of a bench, or of the first window of a motion from rest, as it was read and as the declared model shows
/// it, in the units of memory.
struct DeclaredReadings {
  const data::Channel* channel{};
  std::vector<double> measured{};
  std::vector<double> declared{};  ///< one value for each reading
};

/// Every channel of `run`, which is a bench or a motion from rest; nothing where the model cannot follow the input.
/// `as_declared` has no effect beside those that the model declares. Throws std::invalid_argument where the run does
/// not fit the model.
[[nodiscard]] std::optional<std::vector<DeclaredReadings>> declared_readings(const data::Run& run,
                                                                             const replay::DeclaredModel& declared,
                                                                             const fit::Hypothesis& as_declared);

/// How far readings are from the declared model, by their squares.
struct MissedSquares {
  double missed = 0.0;  ///< of what the model misses
  double varied = 0.0;  ///< of what the readings vary about their mean
  std::size_t count = 0;
  [[nodiscard]] double rms() const;
};

void add(MissedSquares& sums, const DeclaredReadings& readings);

/// How far readings that have a natural zero (torques, forces, rates) are from what the model declares, whatever their
/// unit: of the readings themselves and, where either vary, of their deviations from the mean, so that a bias of the
/// sensor does not pass for a factor.
struct RelativeDistance {
  double size{};   ///< logarithms of the ratios of both norms, by Pythagoras
  double shape{};  ///< rad, angles between both vectors, likewise
  [[nodiscard]] double whole() const;
};

/// Infinite where one of them is nothing but zeros.
[[nodiscard]] RelativeDistance relative_distance(const DeclaredReadings& readings);

}  // namespace coilwright::measurement::records
