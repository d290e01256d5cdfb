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
  temperature,      ///< temperature of a coil over time
  still             ///< nothing moves: the noise of the instruments alone
};

/// What the input columns command.
using simulation::Drive;

/// Where a motion starts.
enum class Start {
  at_rest,   ///< in equilibrium under the first input sample
  measured,  ///< in the first measured state
  free       ///< anywhere: the initial state is a nuisance parameter of the fit
};

/// How an input goes between its samples.
enum class InputHold {
  zero_order,            ///< held until the next sample
  linear,                ///< straight from one sample to the next
  unknown_within_sample  ///< straight, but an edge lies anywhere between the two samples that show it
};

/// What the coils of a run are connected to.
enum class CoilWiring {
  driven,  ///< the driver of the input
  open,    ///< nothing: no current flows
  shorted  ///< themselves: motion induces a current
};

/// What was changed on the rig for one run.
struct RigChange {
  double base_turn{};  ///< rad, turns the base as the model's base tilt does
  double tip_mass{};   ///< kg, hung at the tip; >= 0
  CoilWiring coil = CoilWiring::driven;
  friend bool operator==(const RigChange&, const RigChange&) = default;
};

/// The clocks of measurement and input, and the camera's shutter.
struct RecordingClock {
  double offset_sigma{};  ///< s, standard deviation of the unknown shift: a sample stamped t was taken at t + shift on
                          ///< the clock of the input; >= 0
  double rate_sigma{};    ///< standard deviation of the unknown relative difference of the rates; >= 0
  double exposure{};      ///< s; a sample is the mean over this time, centred on its stamp; >= 0
};

/// How far a recorded input is from what acted: independent errors of its columns, normally distributed about 0.
struct InputUncertainty {
  std::vector<double> sigma{};  ///< standard deviation of each column, in its SI unit; empty: the input is exact
  double correlation{};         ///< time over which the errors fall to 1/e of their correlation, s; below half the
                                ///< interval between samples of the input: each sample has one of its own
  friend bool operator==(const InputUncertainty&, const InputUncertainty&) = default;
};

/// The word that a data set uses: "static_torque", "at_rest", "unknown_within_sample", "shorted".
[[nodiscard]] std::string_view name_of(RunKind kind);
[[nodiscard]] std::string_view name_of(Start start);
[[nodiscard]] std::string_view name_of(InputHold hold);
[[nodiscard]] std::string_view name_of(CoilWiring wiring);

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
  RecordingClock clock{};
  InputHold hold{};
  RigChange rig{};
  std::vector<double> times{};        ///< s, increasing, of the measurement (transient, temperature, still)
  std::vector<double> input_times{};  ///< s, increasing, of `inputs` where they have a clock of their own; empty: the
                                      ///< inputs are at `times`
  std::vector<double> angles{};       ///< rad (static_torque, joint_stiffness)
  std::vector<double> openings{};     ///< rad, bending angle as actuator::GraspPoint has it (blocked_force); >= 0;
                                      ///< empty: closed
  std::vector<double> heights{};      ///< m, of the contact along the last link, from its joint (blocked_force); >= 0;
                                      ///< empty: at the tip
  std::vector<std::vector<double>> inputs{};  ///< A, V or N m: one row per sample of the input, with one value for all
                                              ///< coils or one value for each; empty in a still run
  std::vector<Channel> channels{};            ///< at least one
  InputUncertainty input_uncertainty{};       // last: GCC 12 warns of one that is initialised before others

  /// Number of samples of each channel.
  [[nodiscard]] std::size_t samples() const { return channels.empty() ? 0 : channels.front().values.size(); }
  /// Whether the input has a clock of its own.
  [[nodiscard]] bool has_input_clock() const { return !input_times.empty(); }
  /// The times of `inputs`, s.
  [[nodiscard]] const std::vector<double>& times_of_inputs() const { return has_input_clock() ? input_times : times; }
  /// What was commanded: `drive`, the times of the input and `inputs`. A current with one value per row is common to
  /// all coils.
  [[nodiscard]] simulation::CommandedInput command() const;
};

}  // namespace coilwright::measurement::data
