#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/simulation/commanded_input.hpp"

namespace coilwright::measurement::data {

/// The rigs of the paper.
enum class RunKind {
  transient,        ///< the camera's record of a motion
  static_torque,    ///< torque bench: torque of the first joint's coil and magnet over angle and current (Fig. 17)
  joint_stiffness,  ///< force gauge: torque that holds the first joint open, no current (Figs 10b, 11)
  blocked_force,    ///< grasp-force bench: tip against a wall (Fig. 9b)
  temperature       ///< of a coil over time
};

/// What the input columns command.
using simulation::Drive;

/// Where a motion starts.
enum class Start {
  at_rest,   ///< in equilibrium under the first input sample
  measured,  ///< in the first measured state
  free       ///< anywhere: a nuisance of the fit
};

/// The word in a data set: "static_torque", "at_rest".
[[nodiscard]] std::string_view name_of(RunKind kind);
[[nodiscard]] std::string_view name_of(Start start);

/// What a column measures.
enum class Quantity { bending_angle, joint_angle, joint_rate, torque, force, temperature };

/// One measured column.
struct Channel {
  std::string name{};  ///< of the column in the file: "bending_angle_deg"
  Quantity quantity{};
  int joint{};                   ///< of a joint's angle or rate, from 0
  std::vector<double> values{};  ///< SI, a value a sample
};

/// One record. Vectors that its kind has no use for are empty; the others have one entry a sample.
struct Run {
  std::string name{};  ///< the file, as the data set calls it
  RunKind kind{};
  Drive drive{};
  Start start{};
  std::optional<double> window{};             ///< s: simulated in pieces of this length, each started anew
  std::optional<double> sigma{};              ///< of the measurement, SI; nothing: estimated
  std::vector<double> times{};                ///< s, increasing (transient, temperature)
  std::vector<double> angles{};               ///< rad (static_torque, joint_stiffness)
  std::vector<std::vector<double>> inputs{};  ///< A, V or N m: a row a sample; one value for all coils, or one each
  std::vector<Channel> channels{};            ///< at least one

  [[nodiscard]] std::size_t samples() const { return channels.empty() ? 0 : channels.front().values.size(); }
  /// What was commanded: `drive`, `times` and `inputs`. A current of one value a row is common to all coils.
  [[nodiscard]] simulation::CommandedInput command() const;
};

}  // namespace coilwright::measurement::data
