#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/error_comparison.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement {

/// The runs of a data set, prepared once, to show what any finished model makes of them: as the errors of a diagnosis
/// do, without a fit of the model. What only a run tells (its start where that is free, its clocks, its hum) is fitted
/// to it for each model. Immutable; many threads may ask at once.
class ReplayedRuns {
 public:
  /// What a diagnosis says of the runs.
  struct Known {
    double model_error = 1.0;          ///< Diagnosis::model_error, >= 1
    std::vector<Outliers> outliers{};  ///< Diagnosis::outliers, which count in no error
  };

  /// Prepares the fit runs without channels that are stuck, then the validate runs, for the model that a diagnosis
  /// found and for others. Throws std::invalid_argument naming the run if one does not fit the model.
  ReplayedRuns(data::Dataset data, const replay::DeclaredModel& found, const Known& known);
  ~ReplayedRuns();
  ReplayedRuns(ReplayedRuns&&) noexcept;
  ReplayedRuns& operator=(ReplayedRuns&&) = delete;

  /// Number of runs.
  [[nodiscard]] std::size_t size() const noexcept;
  /// The channels of a run as they were measured, without predictions. `run` < size().
  [[nodiscard]] const std::vector<Replay>& channels(std::size_t run) const;
  /// What these channels show of a model with its numbers as declared, one series each, SI, as long as
  /// Replay::measured. Nothing if it cannot be simulated. It may have other coils and joints, and the current under
  /// a voltage is that of its own resistance. Throws std::invalid_argument if its numbers make no model, or if the run
  /// does not fit it.
  [[nodiscard]] std::optional<std::vector<std::vector<double>>> shown_of(std::size_t run,
                                                                         const replay::DeclaredModel& model) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
  std::vector<std::vector<Replay>> channels_;
};

}  // namespace coilwright::measurement
