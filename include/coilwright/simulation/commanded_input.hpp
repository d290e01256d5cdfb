#pragma once

#include <string_view>
#include <vector>

namespace coilwright::simulation {

/// Largest number of samples of one motion after its first. A motion is held as a whole, in half a kilobyte per sample.
/// Commands, experiments and records beyond it are refused before anything is simulated.
inline constexpr double most_samples = 1e6;

/// The commanded quantity: the current in the coils, the voltage across them, or torques at the joints (a rig that is
/// pushed by hand or by a motor, without magnetics).
enum class Drive { current, voltage, torque };

/// The word in files: "current", "voltage", "torque".
[[nodiscard]] std::string_view name_of(Drive drive);

/// Whether one value holds for all coils, or each coil has its own.
enum class Addressing { common, each };

/// A command over time: one row for each sample, held until the next (zero order). It is independent of a model;
/// model_input() applies it to one.
struct CommandedInput {
  Drive drive{};
  Addressing addressing{};                  ///< of a current or a voltage; torques are always one a joint
  std::vector<double> times{};              ///< s, strictly increasing
  std::vector<std::vector<double>> rows{};  ///< A, V or N m; a row a time
};

/// A step to `current` in every coil from time 0, sampled at `interval` for `duration`.
struct StepInput {
  double current{};   ///< A
  double duration{};  ///< s; > 0
  double interval{};  ///< s; > 0
};
/// The command of a step. Throws std::invalid_argument naming the field, the rule and the value; also above
/// `most_samples`.
[[nodiscard]] CommandedInput step_command(const StepInput& step);

/// A sine, offset + amplitude sin(2 pi f t), in every coil, held between samples: (23) of the paper at 0.7 A and 0.7 A.
struct SineInput {
  double amplitude{};  ///< A
  double offset{};     ///< A
  double frequency{};  ///< Hz, >= 0 and below 1 / (2 interval)
  double duration{};   ///< s; > 0
  double interval{};   ///< s; > 0
};
/// The command of a sine. Throws as step_command() does.
[[nodiscard]] CommandedInput sine_command(const SineInput& sine);

/// Adds samples to a command, which repeat its values, so that none is further than `interval`, s, from the next; its
/// own samples stay. Throws as step_command() does, also if all samples together are too many.
[[nodiscard]] CommandedInput sampled_at_least_every(const CommandedInput& command, double interval);

}  // namespace coilwright::simulation
