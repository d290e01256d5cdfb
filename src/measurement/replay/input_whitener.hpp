#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "measurement/replay/prediction.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// Turns what a model that is right leaves of a window, where its recorded input is wrong by as much as
/// Run::input_uncertainty says, into white noise of unit variance: the innovations of a Kalman filter, each the error
/// of the best linear prediction of a reading from those before it, over its standard deviation. A linear map, so that
/// a model and its derivatives pass it as the data do.
///
/// The errors move the state along the motion about which the window was linearised, and add up until the readings show
/// them; sums of squared innovations are the likelihood of such records (F. C. Schweppe, IEEE Trans. Inf. Theory 11,
/// 61, 1965; N. R. Kristensen, H. Madsen and S. B. Jorgensen, Automatica 40, 225, 2004). The noise of the instruments
/// counts as white. Good to first order: where the errors move the state so far that the linear motion is another one
/// (a joint that sticks or slides by chance), innovations are larger or smaller than they pass for.
class InputWhitener {
 public:
  /// About a simulated motion of a window, its local numbers being `local`.
  InputWhitener(const actuator::Model& model, const PreparedRun& prepared, const Window& window,
                const Trajectory& motion, LocalValues local);

  /// Innovations of the differences of measured and predicted values, SI, channel after channel. Samples of `prepared`
  /// that are set aside become 0 and tell nothing of those after them.
  [[nodiscard]] Eigen::VectorXd innovations(const PreparedRun& prepared, const Eigen::VectorXd& differences) const;

  /// Standard deviation of what the errors do to each reading, SI, if the window starts where the model does; channel
  /// after channel.
  [[nodiscard]] const Eigen::VectorXd& deviations() const noexcept { return deviations_; }

 private:
  // Of one channel at one sample: what the state shows there, and how it is corrected by an innovation.
  struct Reading {
    Eigen::VectorXd shown{};
    Eigen::VectorXd gain{};
    double deviation{};  // of the innovation, SI
  };
  SampleRange range_;
  std::size_t channels_{};
  std::vector<Eigen::MatrixXd> transitions_{};  // of state and errors, from the sample before; none of the first one
  std::vector<Reading> readings_{};             // sample after sample
  Eigen::VectorXd deviations_{};
};

/// Gives every window of a motion the whitener of its input, about the motion of `model` with the local numbers
/// `local` of each window, or with those that their priors hold for likeliest where that is empty. Does nothing where
/// the input is exact; from where the model cannot be simulated on, windows keep what they have.
void weigh_input_errors(PreparedRun& prepared, const actuator::Model& model,
                        const std::vector<std::vector<double>>& local);

}  // namespace coilwright::measurement::replay
