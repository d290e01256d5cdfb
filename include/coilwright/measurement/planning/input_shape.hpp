#pragma once

#include <variant>
#include <vector>

namespace coilwright::measurement::planning {

/// Shapes of a commanded level over time: levels in SI (A, V or N m), times in s from the start of the run.
struct StepShape {
  double before{};  ///< level before `at`
  double after{};   ///< level from `at` on
  double at{};      ///< s
};
/// offset + amplitude sin(2 pi frequency t).
struct SineShape {
  double amplitude{};
  double offset{};
  double frequency{};  ///< Hz
};
/// A sine whose frequency changes linearly over the run.
struct ChirpShape {
  double amplitude{};
  double offset{};
  double from{};  ///< frequency at the start, Hz
  double to{};    ///< frequency at the end, Hz
};
/// `level` from `from` until `until`, and 0 before and after.
struct HoldShape {
  double level{};
  double from{};   ///< s
  double until{};  ///< s
};
/// `high` for the first fraction `duty` of each period, then `low`.
struct PulseShape {
  double low{};
  double high{};
  double period{};  ///< s
  double duty{};    ///< 0 to 1
};
/// The rows of a file, each held until the time of the next: one value for all coils, or one value per coil or joint.
struct TableShape {
  std::vector<double> times{};  ///< s, increasing
  std::vector<std::vector<double>> rows{};
};
using InputShape = std::variant<StepShape, SineShape, ChirpShape, HoldShape, PulseShape, TableShape>;

/// The level that a shape commands at `time` in a run of `duration`, both in s; a chirp reaches its last frequency at
/// the end of the run. Throws std::invalid_argument for a table, which has rows in place of a level.
[[nodiscard]] double level_at(const InputShape& shape, double time, double duration);

}  // namespace coilwright::measurement::planning
