#include "measurement/correction/visited_states.hpp"

#include <algorithm>

#include "measurement/replay/prediction.hpp"
#include "measurement/replay/rig_change.hpp"
#include "measurement/replay/window_input.hpp"

namespace coilwright::measurement::correction {
namespace {

using actuator::CoilCurrents;
using actuator::Model;
using simulation::State;

// More tell no more about where the joints were.
constexpr std::size_t most_samples = 6000;

double current_at(const Model& model, const CoilCurrents& strength, int joint) {
  if (model.coils() == 0) return 0.0;
  for (const actuator::HingePair& pair : model.magnetics().hinge_pairs())
    if (pair.joint == joint) return strength[pair.coil];
  return strength.mean();
}

class Visits {
 public:
  void add(const Model& model, const State& state, const CoilCurrents& command) {
    const CoilCurrents strength = model.strength(state.angles, command);
    for (int j = 0; j < model.joints(); ++j)
      out_.samples.push_back({{state.angles[j], state.rates[j], current_at(model, strength, j)}});
    const double bending = Model::bending_angle(state.angles);
    if (largest_ == nullptr || bending > largest_->state.angles.sum()) keep(largest_, state, command);
    if (smallest_ == nullptr || bending < smallest_->state.angles.sum()) keep(smallest_, state, command);
  }
  void end_run() {
    for (auto* each : {&largest_, &smallest_}) {
      if (*each) out_.extremes.push_back(std::move(**each));
      each->reset();
    }
  }
  VisitedStates take() {
    const std::size_t every = out_.samples.size() / most_samples + 1;
    std::vector<JointSample> thinned;
    for (std::size_t i = 0; i < out_.samples.size(); i += every) thinned.push_back(out_.samples[i]);
    out_.samples = std::move(thinned);
    return std::move(out_);
  }

 private:
  using Extreme = VisitedStates::Extreme;
  static void keep(std::unique_ptr<Extreme>& place, const State& state, const CoilCurrents& command) {
    place = std::make_unique<Extreme>(Extreme{.state = state, .currents = command});
  }
  VisitedStates out_;
  std::unique_ptr<Extreme> largest_, smallest_;
};

}  // namespace

VisitedStates visited_states(std::span<const replay::PreparedRun> runs,
                             const identification::FittedHypothesis& fitted) {
  Visits visits;
  const actuator::ModelSpec spec = fitted.hypothesis.spec_at(fitted.fit.values);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const replay::PreparedRun& prepared = runs[r];
    if (!prepared.is_motion()) continue;
    const Model model(replay::on_changed_rig(spec, prepared.run->rig));
    actuator::InternalStates internal;
    for (std::size_t w = 0; w < prepared.windows.size(); ++w) {
      const replay::Window& window = prepared.windows[w];
      const replay::LocalNumbers numbers(prepared, window);
      const replay::LocalValues local{.numbers = &numbers, .values = fitted.fit.runs[r].local_numbers[w]};
      const auto motion = replay::simulate_window(model, window, local, internal);
      if (!motion) break;
      const simulation::ModelInput input = replay::at_samples(window, *prepared.run);
      for (std::size_t i = 0; i < input.times.size(); ++i)
        visits.add(model, motion->at(input.times[i]), input.currents[i]);
      internal = motion->at(input.times.back()).internal;
    }
    visits.end_run();
  }
  return visits.take();
}

}  // namespace coilwright::measurement::correction
