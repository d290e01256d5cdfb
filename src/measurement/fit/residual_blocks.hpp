#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::fit {

/// One run, or one window of it where starts are fitted, as a least-squares program sees it.
struct ResidualBlock {
  std::size_t record{};
  std::size_t window{};                   ///< of the record
  bool whole_run{};                       ///< all windows in one: nothing of their own to fit
  Eigen::Index rows{};                    ///< residuals, and the pull of the start towards the measurement
  Eigen::Index first{};                   ///< of its residuals in those of the run
  std::span<double> start{};              ///< angles, rates: what is fitted along
  std::vector<double> guess{}, sigmas{};  ///< of the start, from the measurement
};
[[nodiscard]] simulation::State start_of(const ResidualBlock& block);

/// Residuals over their noise at one point, and which of their slopes are asked for.
struct ResidualValues {
  struct Block {
    Eigen::VectorXd residuals{};     ///< (rows)
    Eigen::MatrixXd slopes{};        ///< by the parameters: (rows, p)
    Eigen::MatrixXd start_slopes{};  ///< by the start: (rows, 2n), or (rows, 0)
  };
  std::vector<Block> blocks{};
  std::vector<Eigen::VectorXd> predictions{};  ///< of each record, SI
};
enum class Slopes {
  none,
  of_starts,  ///< those by the parameters are zero
  all         ///< but for a parameter that is held
};

/// The residuals of all records as a function of parameters and window starts. Refers to what the request refers to.
class ResidualBlocks {
 public:
  explicit ResidualBlocks(const FitRequest& request);
  ResidualBlocks(const ResidualBlocks&) = delete;
  ResidualBlocks& operator=(const ResidualBlocks&) = delete;

  [[nodiscard]] std::span<const ResidualBlock> blocks() const noexcept { return blocks_; }
  /// The starts of all blocks, one after the other; what is written here is what `evaluate` takes.
  [[nodiscard]] std::span<double> starts() noexcept { return starts_; }
  /// All blocks, in parallel; slopes by forward differences. Nothing where a model cannot be simulated.
  [[nodiscard]] std::optional<ResidualValues> evaluate(const Eigen::VectorXd& parameters, Slopes slopes) const;

 private:
  struct RunValues;
  void add_blocks(std::size_t record);
  [[nodiscard]] std::optional<RunValues> evaluate_run(const actuator::Model& model, std::size_t record) const;
  [[nodiscard]] std::optional<RunValues> evaluate_bench(const actuator::Model& model,
                                                        const replay::Record& record) const;
  [[nodiscard]] std::optional<RunValues> evaluate_rest_run(const actuator::Model& model,
                                                           const replay::Record& record) const;
  [[nodiscard]] std::optional<RunValues> evaluate_windows(const actuator::Model& model, std::size_t record) const;
  [[nodiscard]] bool add_slopes(const Eigen::VectorXd& parameters, ResidualValues& values) const;
  [[nodiscard]] bool add_start_slopes(const actuator::Model& model,
                                      const std::vector<actuator::InternalStates>& internal,
                                      ResidualValues& values) const;
  [[nodiscard]] std::optional<actuator::Model> model_at(const Eigen::VectorXd& parameters) const;
  [[nodiscard]] double slope_step(const Eigen::VectorXd& parameters, Eigen::Index parameter) const;

  const FitRequest& request_;
  std::vector<ResidualBlock> blocks_;
  std::vector<double> starts_;                         // of all blocks; never moves
  std::vector<std::size_t> first_block_, last_block_;  // of each record
};

/// Runs simulated since the program started: for the profile of where time goes.
[[nodiscard]] long simulated_runs();

}  // namespace coilwright::measurement::fit
