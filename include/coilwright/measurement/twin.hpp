#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/actuator/effect.hpp"
#include "coilwright/measurement/dataset.hpp"
#include "coilwright/measurement/declared_model.hpp"

namespace coilwright::measurement {

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

/// What an instrument does to what it measures, SI.
struct Instrument {
  double noise{};       ///< standard deviation of white Gaussian noise; >= 0
  double resolution{};  ///< readings are multiples of it; 0: exact
};

/// Instruments of a rig; angles of joints and of the whole finger are seen by the same camera.
struct Instruments {
  Instrument angle{}, rate{}, torque{}, force{}, temperature{};
  [[nodiscard]] const Instrument& of(Quantity quantity) const;
};

/// A run that somebody plans.
struct PlannedRun {
  /// Name, kind, drive, start and channels; times, angles, inputs and values are still empty, except those of a bench
  /// (angles, inputs), which are complete.
  Run plan;
  bool validate{};
  InputShape input{};                  ///< of a kind with time
  std::optional<int> only{};           ///< the one coil (joint, under a torque) that is driven, from 0; nothing: all
  std::vector<double> start_angles{};  ///< rad, a joint; where it is let go. Empty: in equilibrium
  double duration{};                   ///< s
  double rate{};                       ///< samples a second
};

/// What is to be done on a rig.
struct Experiment {
  std::string name{};
  Instruments instruments{};
  std::vector<PlannedRun> runs{};  ///< at least one
};

/// The records that a rig would give which has the effects `hidden` beside what `rig` declares: one run a planned one,
/// in their order, with simulated, noisy and rounded values. The noise of a channel follows from `seed` and the places
/// of run and channel alone, so a run added at the end changes no other. The same input gives the same bits. Throws
/// std::invalid_argument naming the run where it does not fit the rig (number of coils or joints, a voltage without a
/// resistance, an effect that cannot be there), std::runtime_error naming it where its motion cannot be followed.
[[nodiscard]] std::vector<Run> act_out(const Experiment& experiment, const DeclaredModel& rig,
                                       std::span<const actuator::Effect> hidden, std::uint64_t seed);

}  // namespace coilwright::measurement
