#include "stepper.hpp"

#include <algorithm>
#include <utility>

namespace coilwright::simulation {
namespace {

namespace odeint = boost::numeric::odeint;
using mechanics::JointVector;

// Below what a camera or an encoder resolves by four orders; keeps a finger at rest from asking for endless accuracy.
constexpr double absolute_accuracy = 1e-9;

struct Motion {
  const actuator::Model& model;
  const Stepper::Input& input;

  void operator()(const std::vector<double>& values, std::vector<double>& slopes, double /*time*/) const {
    const int n = model.joints();
    const JointVector angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
    const JointVector rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n);
    const JointVector accelerations = model.accelerations(angles, rates, input.currents, input.applied);
    std::copy_n(values.data() + n, n, slopes.data());
    std::copy_n(accelerations.data(), n, slopes.data() + n);
  }
};

}  // namespace

Stepper::Stepper(const actuator::Model& model, double relative_accuracy)
    : model_(model),
      stepper_(odeint::make_dense_output(absolute_accuracy, relative_accuracy, odeint::runge_kutta_dopri5<Values>())),
      scratch_(2 * model.joints()) {}

void Stepper::start(double time, const State& state, Input input) {
  input_ = std::move(input);
  std::copy_n(state.angles.data(), model_.joints(), scratch_.data());
  std::copy_n(state.rates.data(), model_.joints(), scratch_.data() + model_.joints());
  stepper_.initialize(scratch_, time, first_step_);
}

void Stepper::step() {
  stepper_.do_step(Motion{model_, input_});
  first_step_ = stepper_.current_time_step();
}

State Stepper::at(double time) {
  stepper_.calc_state(time, scratch_);
  return unpack(scratch_);
}

State Stepper::now() const {
  return unpack(stepper_.current_state());
}

State Stepper::unpack(const Values& values) const {
  const int n = model_.joints();
  return {.angles = Eigen::Map<const Eigen::VectorXd>(values.data(), n),
          .rates = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n)};
}

}  // namespace coilwright::simulation
