#include "measurement/replay/motions_beside.hpp"

#include <cstddef>
#include <utility>

#include "coilwright/algebra/exponential.hpp"

namespace coilwright::measurement::replay {

using actuator::Model;
using simulation::State;

MotionsBeside::MotionsBeside(const Model& model, const Window& window, const Trajectory& motion)
    : model_(model), motion_(motion) {
  for (std::size_t k = 0; k + 1 < motion.times.size(); ++k) {
    const double middle = 0.5 * (motion.times[k] + motion.times[k + 1]);
    Row row{.middle = motion.at(middle), .input = input_at(model, window.input, middle)};
    row.slopes = slopes_of(model, row.middle, row.input);
    const LinearMotion linear = linear_motion(model, row.middle, row.input, {});
    algebra::HeldResponse held = algebra::held_response(linear.by_state, motion.times[k + 1] - motion.times[k]);
    row.transition = std::move(held.transition);
    row.integral = std::move(held.integral);
    rows_.push_back(std::move(row));
  }
}

std::optional<Trajectory> MotionsBeside::of(const Model& other, const State& start) const {
  const State& from = motion_.states.front();
  if (other.internal_states() != model_.internal_states() || start.internal.size() != from.internal.size())
    return std::nullopt;
  Trajectory out{.times = motion_.times, .states = {start}};
  out.states.reserve(motion_.states.size());
  Eigen::VectorXd change(size_of_changes(model_));
  change << start.angles - from.angles, start.rates - from.rates, start.internal - from.internal;
  Eigen::VectorXd moved(change.size());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    moved.noalias() = row.transition.lazyProduct(change);
    if (&other != &model_) {
      change = slopes_of(other, row.middle, row.input) - row.slopes;
      moved.noalias() += row.integral.lazyProduct(change);
    }
    change.swap(moved);
    out.states.push_back(displaced(motion_.states[k + 1], change));
  }
  return out;
}

}  // namespace coilwright::measurement::replay
