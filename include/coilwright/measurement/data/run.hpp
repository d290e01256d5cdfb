#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/simulation/commanded_input.hpp"

namespace coilwright::measurement::data {

/// The kinds of measurements of the paper.
enum class RunKind {
  transient,        ///< the camera's record of a motion
  static_torque,    ///< torque bench: torque of the first joint's coil and magnet over angle and current (Fig. 17)
  joint_stiffness,  ///< force gauge: torque that holds the first joint open, without current (Figs 10b, 11)
  blocked_force,    ///< grasp-force bench: force of the tip against a wall (Fig. 9b)
  temperature       ///< temperature of a coil over time
};

/// What the input columns command.
using simulation::Drive;

/// Where a motion starts.
enum class Start {
  at_rest,   ///< in equilibrium under the first input sample
  measured,  ///< in the first measured state
  free       ///< anywhere: the initial state is a nuisance parameter of the fit
};

/// The word that a data set uses: "static_torque", "at_rest".
[[nodiscard]] std::string_view name_of(RunKind kind);
[[nodiscard]] std::string_view name_of(Start start);

/// What a column measures.
enum class ChannelKind { bending_angle, joint_angle, joint_rate, torque, force, temperature };

/// One measured column.
struct Channel {
  std::string name{};  ///< name of the column in the file: "bending_angle_deg"
  ChannelKind kind{};
  int joint{};                   ///< index of the joint, from 0, if the channel is a joint's angle or rate
  std::vector<double> values{};  ///< one value per sample, SI
};

/// One record. A vector that its kind has no use for is empty; the others have one entry per sample.
struct Run {
  std::string name{};  ///< name of the file, as the data set writes it
  RunKind kind{};
  Drive drive{};
  Start start{};
  std::optional<double> window{};  ///< length of the pieces in which the run is simulated, each with an initial state
                                   ///< of its own, s; nothing: the run is one piece
  std::optional<double> sigma{};   ///< standard deviation of the measurement noise, SI; nothing: it is estimated
  std::vector<double> times{};     ///< s, increasing (transient, temperature)
  std::vector<double> angles{};    ///< rad (static_torque, joint_stiffness)
  std::vector<std::vector<double>> inputs{};  ///< A, V or N m: one row per sample, with one value for all coils or one
                                              ///< value for each
  std::vector<Channel> channels{};            ///< at least one

  /// Number of samples of each channel.
  [[nodiscard]] std::size_t samples() const { return channels.empty() ? 0 : channels.front().values.size(); }
  /// What was commanded: `drive`, `times` and `inputs`. A current with one value per row is common to all coils.
  [[nodiscard]] simulation::CommandedInput command() const;
};

}  // namespace coilwright::measurement::data
