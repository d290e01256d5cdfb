#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/planning/experiment.hpp"
#include "measurement/fit/residual_blocks.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::planning {

/// Records of the rig as it is declared, prepared as a diagnosis does, and the declared model's residuals in them with
/// their derivatives. Nothing is fitted but local numbers: the declared numbers are the true ones.
class LinearisedRecords {
 public:
  /// Simulates the fit runs of `experiment`, and its still runs to learn the noise from. Throws as
  /// simulate_experiment() does, and std::invalid_argument if no run can be fitted. `simulations` counts what is
  /// simulated in them.
  LinearisedRecords(const Experiment& experiment, const replay::DeclaredModel& rig, std::uint64_t seed,
                    replay::SimulationCount simulations = {});
  LinearisedRecords(const LinearisedRecords&) = delete;
  LinearisedRecords& operator=(const LinearisedRecords&) = delete;

  [[nodiscard]] std::span<const replay::PreparedRun> runs() const noexcept { return prepared_; }
  [[nodiscard]] const identification::FittedHypothesis& base() const noexcept { return *base_; }

  /// What an effect changes in the residuals, projected on what the local numbers cannot absorb; rows as
  /// fit::Fit::stacked_residuals. Nothing if the motion cannot be simulated with it.
  [[nodiscard]] std::optional<Eigen::VectorXd> change_by(const actuator::Effect& effect) const;
  /// A change, projected on what the numbers of the declared model cannot absorb either.
  [[nodiscard]] Eigen::VectorXd beyond_declared(const Eigen::VectorXd& change) const;
  /// The length of what is left of a change after the numbers of the declared model have been fitted to it, tolerances
  /// included: less than that of beyond_declared() where numbers imitate the change beyond their tangents (an added
  /// mass that shifts a long ringing). Gauss-Newton steps from the derivatives at the declared numbers, each one
  /// simulation.
  [[nodiscard]] double length_after_refit(const Eigen::VectorXd& change) const;
  /// How many numbers a fit of this effect would have.
  [[nodiscard]] Eigen::Index numbers_of(const actuator::Effect& effect) const;

 private:
  // From the base to those residuals: projected on what local numbers cannot absorb, the rows of the priors left zero.
  [[nodiscard]] Eigen::VectorXd projected_change(const fit::ResidualValues& there) const;

  std::vector<data::Run> recorded_;
  std::vector<replay::PreparedRun> prepared_;
  std::optional<identification::FittedHypothesis> base_;
};

}  // namespace coilwright::measurement::planning
