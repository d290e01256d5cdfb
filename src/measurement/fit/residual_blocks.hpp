#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "measurement/fit/fit_request.hpp"
#include "measurement/replay/local_numbers.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::fit {

/// The residuals of one window of a motion, or of a bench.
struct ResidualBlock {
  std::size_t run{};
  std::size_t window{};          ///< index of the window in the run
  Eigen::Index rows{};           ///< number of residuals, those of the prior of the local numbers included
  Eigen::Index first{};          ///< index of its first residual among those of the run
  replay::LocalNumbers numbers;  ///< what this window alone tells; none on a bench
  std::span<double> local{};     ///< their values, which are fitted along with the parameters

  [[nodiscard]] Eigen::Index samples() const { return rows - static_cast<Eigen::Index>(local.size()); }
  [[nodiscard]] replay::LocalValues local_values() const { return {.numbers = &numbers, .values = local}; }
};

/// Residuals over their noise at one point, and the derivatives that were asked for.
struct ResidualValues {
  struct Block {
    Eigen::VectorXd residuals{};       ///< (rows)
    Eigen::MatrixXd jacobian{};        ///< with respect to the parameters: (rows, p)
    Eigen::MatrixXd local_jacobian{};  ///< with respect to the local numbers: (rows, their number)
  };
  std::vector<Block> blocks{};
  std::vector<Eigen::VectorXd> predictions{};  ///< of each run, SI
};
/// Residuals, and what they were evaluated at.
struct ResidualPoint {
  Eigen::VectorXd parameters{};
  std::vector<double> local_numbers{};  ///< of all blocks, one after the other
  std::optional<ResidualValues> values{};
};
enum class Derivatives {
  none,
  by_local_numbers,  ///< those with respect to the parameters are zero
  all                ///< except those with respect to a held parameter, which are zero
};

/// The residuals of all runs as a function of parameters and local numbers. Refers to what the request refers to.
class ResidualBlocks {
 public:
  explicit ResidualBlocks(const FitRequest& request);
  ~ResidualBlocks();
  ResidualBlocks(const ResidualBlocks&) = delete;
  ResidualBlocks& operator=(const ResidualBlocks&) = delete;

  [[nodiscard]] std::span<const ResidualBlock> blocks() const noexcept { return blocks_; }
  /// The local numbers of all blocks, one after the other; `evaluate` uses the values that are written here.
  [[nodiscard]] std::span<double> local_numbers() noexcept { return local_numbers_; }
  /// Writes rates of clocks with which the motions of `parameters` lie nearest to the records, robustly, where clocks
  /// may be so far apart at the end of a window that a fit could begin on another swing.
  void start_clock_rates(const Eigen::VectorXd& parameters);
  /// Evaluates all blocks in parallel, with derivatives by forward differences. Nothing if a model cannot be simulated.
  /// Derivatives where the last call was take its motions over.
  [[nodiscard]] std::optional<ResidualValues> evaluate(const Eigen::VectorXd& parameters, Derivatives derivatives);
  /// The derivatives at `to` from those at `from`, without a simulated run: see update_derivatives().
  void carry_derivatives(const ResidualPoint& from, ResidualPoint& to) const;

 private:
  struct RunValues;
  struct Displaced;
  struct Place;
  class Models;
  void add_blocks(std::size_t run);
  [[nodiscard]] bool is_here(const Eigen::VectorXd& parameters) const;
  void move_to(const Eigen::VectorXd& parameters);
  [[nodiscard]] std::optional<RunValues> evaluate_run(const Models& models, std::size_t run,
                                                      const RunValues* nearby = nullptr) const;
  [[nodiscard]] std::optional<RunValues> evaluate_bench(const actuator::Model& model, std::size_t run) const;
  [[nodiscard]] std::optional<RunValues> evaluate_windows(const actuator::Model& model, std::size_t run,
                                                          const RunValues* nearby) const;
  [[nodiscard]] bool takes_known_column(Eigen::Index parameter) const;
  [[nodiscard]] std::vector<Displaced> displaced_models(const Eigen::VectorXd& parameters) const;
  void add_jacobian(const Eigen::VectorXd& parameters, const std::vector<Displaced>& displaced,
                    ResidualValues& values) const;
  void add_known_columns(ResidualValues& values) const;
  void add_local_jacobian(const Models& models, const std::vector<RunValues>& runs, ResidualValues& values) const;
  [[nodiscard]] std::optional<Models> models_at(const Eigen::VectorXd& parameters) const;
  [[nodiscard]] double difference_step(const Eigen::VectorXd& parameters, Eigen::Index parameter) const;

  const FitRequest& request_;
  std::vector<ResidualBlock> blocks_;
  std::vector<double> local_numbers_;                  // of all blocks; never moves
  std::vector<std::size_t> first_block_, last_block_;  // of each run
  std::vector<data::RigChange> rigs_;                  // the different ones
  std::vector<std::size_t> rig_of_run_;
  std::unique_ptr<Place> here_;  // where the last call was; null before the first and where there is no motion
};

}  // namespace coilwright::measurement::fit
