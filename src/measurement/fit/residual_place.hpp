#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "measurement/fit/residual_blocks.hpp"
#include "measurement/replay/rig_change.hpp"

// What ResidualBlocks keeps of one set of parameters and local numbers.

namespace coilwright::measurement::fit {

/// The models of one set of parameters, one for each way in which the rig was changed.
class ResidualBlocks::Models {
 public:
  Models(const actuator::ModelSpec& spec, const std::vector<data::RigChange>& rigs) {
    for (const data::RigChange& rig : rigs) models_.emplace_back(replay::on_changed_rig(spec, rig));
  }
  [[nodiscard]] const actuator::Model& on(std::size_t rig) const { return models_[rig]; }

 private:
  std::vector<actuator::Model> models_;
};

/// What one run gives at one set of parameters.
struct ResidualBlocks::RunValues {
  std::vector<Eigen::VectorXd> residuals{};  // of its blocks
  Eigen::VectorXd predictions{};
  std::vector<actuator::InternalStates> internal{};  // at the start of each block
  std::vector<replay::Trajectory> trajectories{};    // of each block; none on a bench
};

/// The models with one parameter displaced, for a forward difference.
struct ResidualBlocks::Displaced {
  Eigen::Index parameter{};
  double step{};
  Models models;
};

/// Parameters and local numbers with the models and motions that they give.
struct ResidualBlocks::Place {
  Eigen::VectorXd parameters{};
  std::vector<double> local_numbers{};
  Models models;
  std::vector<RunValues> runs{};
};

/// The residuals of a window, followed by those of the prior of its local numbers.
[[nodiscard]] Eigen::VectorXd residuals_with_prior(const ResidualBlock& block, const replay::PreparedRun& prepared,
                                                   replay::SampleRange range, const Eigen::VectorXd& predicted,
                                                   std::span<const double> local);

}  // namespace coilwright::measurement::fit
