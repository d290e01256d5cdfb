#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "measurement/fit/counted.hpp"
#include "measurement/fit/fit_request.hpp"

namespace coilwright::measurement::fit {

/// The residuals of one run, or of one of its windows if initial states are fitted.
struct ResidualBlock {
  std::size_t run{};
  std::size_t window{};  ///< index of the window in the run
  bool whole_run{};      ///< whether the block has all windows of a run, whose initial states are not fitted
  Eigen::Index rows{};   ///< number of residuals, those of the prior of the initial state included
  Eigen::Index first{};  ///< index of its first residual among those of the run
  std::span<double> initial_state{};                ///< angles and rates that are fitted along with the parameters
  std::vector<double> prior_mean{}, prior_sigma{};  ///< of the initial state
};
[[nodiscard]] simulation::State initial_state_of(const ResidualBlock& block);

/// Residuals over their noise at one point, and the derivatives that were asked for.
struct ResidualValues {
  struct Block {
    Eigen::VectorXd residuals{};               ///< (rows)
    Eigen::MatrixXd jacobian{};                ///< with respect to the parameters: (rows, p)
    Eigen::MatrixXd initial_state_jacobian{};  ///< with respect to the initial state: (rows, 2n), or (rows, 0)
  };
  std::vector<Block> blocks{};
  std::vector<Eigen::VectorXd> predictions{};  ///< of each run, SI
};
enum class Derivatives {
  none,
  by_initial_states,  ///< those with respect to the parameters are zero
  all                 ///< except those with respect to a held parameter, which are zero
};

/// The residuals of all runs as a function of parameters and initial states. Refers to what the request refers to.
class ResidualBlocks {
 public:
  explicit ResidualBlocks(const FitRequest& request);
  ResidualBlocks(const ResidualBlocks&) = delete;
  ResidualBlocks& operator=(const ResidualBlocks&) = delete;

  [[nodiscard]] std::span<const ResidualBlock> blocks() const noexcept { return blocks_; }
  /// The initial states of all blocks, one after the other; `evaluate` uses the values that are written here.
  [[nodiscard]] std::span<double> initial_states() noexcept { return initial_states_; }
  /// Evaluates all blocks in parallel, with derivatives by forward differences. Nothing if a model cannot be simulated.
  [[nodiscard]] Counted<std::optional<ResidualValues>> evaluate(const Eigen::VectorXd& parameters,
                                                                Derivatives derivatives) const;

 private:
  struct RunValues;
  struct Displaced;
  void add_blocks(std::size_t run);
  [[nodiscard]] std::optional<RunValues> evaluate_run(const actuator::Model& model, std::size_t run) const;
  [[nodiscard]] std::optional<RunValues> evaluate_bench(const actuator::Model& model,
                                                        const replay::PreparedRun& prepared) const;
  [[nodiscard]] std::optional<RunValues> evaluate_run_from_rest(const actuator::Model& model,
                                                                const replay::PreparedRun& prepared) const;
  [[nodiscard]] std::optional<RunValues> evaluate_windows(const actuator::Model& model, std::size_t run) const;
  [[nodiscard]] std::optional<std::vector<Displaced>> displaced_models(const Eigen::VectorXd& parameters) const;
  [[nodiscard]] bool add_jacobian(const std::vector<Displaced>& displaced, ResidualValues& values) const;
  [[nodiscard]] bool add_initial_state_jacobian(const actuator::Model& model,
                                                const std::vector<actuator::InternalStates>& internal,
                                                ResidualValues& values) const;
  [[nodiscard]] std::optional<actuator::Model> model_at(const Eigen::VectorXd& parameters) const;
  [[nodiscard]] double difference_step(const Eigen::VectorXd& parameters, Eigen::Index parameter) const;

  const FitRequest& request_;
  std::vector<ResidualBlock> blocks_;
  std::vector<double> initial_states_;                 // of all blocks; never moves
  std::vector<std::size_t> first_block_, last_block_;  // of each run
};

}  // namespace coilwright::measurement::fit
