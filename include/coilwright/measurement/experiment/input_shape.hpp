#pragma once

#include <variant>
#include <vector>

namespace coilwright::measurement::experiment {

/// How a commanded level goes over time; levels in SI (A, V or N m), times in s from the start of the run.
struct StepShape {
  double before{};  ///< level until `at`
  double after{};   ///< and from there on
  double at{};      ///< s
};
struct SineShape {
  double amplitude{};
  double offset{};
  double frequency{};  ///< Hz
};
/// A sine whose frequency goes linearly from one to the other over the run.
struct ChirpShape {
  double amplitude{};
  double offset{};
  double from{};  ///< Hz
  double to{};    ///< Hz
};
/// `level` from `from` until `until`, nothing before and after.
struct HoldShape {
  double level{};
  double from{};   ///< s
  double until{};  ///< s
};
/// `high` for the first `duty` of each period, then `low`.
struct PulseShape {
  double low{};
  double high{};
  double period{};  ///< s
  double duty{};    ///< 0 to 1
};
/// What a file commands, held between its samples: one value a row for all, or one a coil or joint.
struct TableShape {
  std::vector<double> times{};  ///< s, increasing
  std::vector<std::vector<double>> rows{};
};
using InputShape = std::variant<StepShape, SineShape, ChirpShape, HoldShape, PulseShape, TableShape>;

/// The level that a shape commands at `time`; `duration` is the run's (a chirp reaches its last frequency there). Not
/// for a table.
[[nodiscard]] double level_at(const InputShape& shape, double time, double duration);

}  // namespace coilwright::measurement::experiment
