#pragma once

#include <cstddef>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/noise/noise_level.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::measurement::replay {

/// A stretch of a motion that is simulated in one go.
struct Window {
  std::size_t first{};              ///< sample
  std::size_t last{};               ///< one beyond
  simulation::ModelInput input{};   ///< of these samples
  simulation::State guess{};        ///< from the measurement; not for runs that start at rest
  simulation::State guess_sigma{};  ///< how well the measurement tells it

  [[nodiscard]] std::size_t samples() const { return last - first; }
};

/// Samples that follow each other without a new start.
struct SampleRange {
  std::size_t first{};
  std::size_t last{};  ///< one beyond
  [[nodiscard]] std::size_t samples() const { return last - first; }
};

/// A run as fits use it: inputs as the model takes them, noise, windows. Refers to the run.
struct Record {
  const data::Run* run{};
  std::vector<noise::NoiseLevel> noise{};  ///< one a channel
  std::vector<Window> windows{};           ///< of a transient; empty on a bench

  /// Of its predictions and residuals, which stand stretch after stretch, in each channel after channel: its windows,
  /// or all samples of a bench.
  [[nodiscard]] std::vector<SampleRange> stretches() const;
  [[nodiscard]] bool is_motion() const { return run->kind == data::RunKind::transient; }
  /// Whether where its windows start is fitted with the rest.
  [[nodiscard]] bool has_nuisances() const { return is_motion() && run->start != data::Start::at_rest; }
};

/// Throws std::invalid_argument naming the run where it does not fit the model: number of coils or joints, a voltage
/// without a resistance, a temperature without heat paths.
void check(const data::Run& run, const DeclaredModel& declared, const actuator::Model& nominal);
/// Throws as `check` does, and for a window of fewer than five samples.
[[nodiscard]] Record prepare(const data::Run& run, const DeclaredModel& declared, const actuator::Model& nominal);

}  // namespace coilwright::measurement::replay
