#include "measurement/correction/rest_after_release.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "coilwright/simulation/transient.hpp"
#include "measurement/replay/if_possible.hpp"

namespace coilwright::measurement::correction {
namespace {

using actuator::CoilCurrents;
using actuator::Model;
using mechanics::JointVector;

constexpr double duration = 3.0;     // s: a finger comes to rest within one
constexpr double interval = 0.01;    // s
constexpr double still_from = 0.75;  // share of the duration after which it must be at rest
constexpr double slack = 1.1;        // over what the model without it still moves
constexpr double at_rest = 0.01;     // share of the largest rate that was visited
constexpr double most_steps = 1e5;

// The largest rate of a joint in the last part of a release, rad/s; nothing if it cannot be simulated.
std::optional<double> last_rate(const Model& model, const VisitedStates::Extreme& from, const CoilCurrents& currents) {
  simulation::ModelInput input;
  const auto samples = static_cast<int>(duration / interval);
  for (int i = 0; i <= samples; ++i) {
    input.times.push_back(interval * i);
    input.currents.push_back(currents);
  }
  const simulation::State start{.angles = from.state.angles,
                                .rates = JointVector::Zero(model.joints()),
                                .internal = model.settled(from.state.angles, currents)};
  return replay::if_possible<double>([&]() -> std::optional<double> {
    const auto states = simulation::simulate(model, input, start, {.relative = 1e-5, .most_steps = most_steps});
    double largest = 0.0;
    for (std::size_t i = static_cast<std::size_t>(still_from * samples); i < states.size(); ++i)
      largest = std::max(largest, states[i].rates.cwiseAbs().maxCoeff());
    return std::isfinite(largest) ? std::optional(largest) : std::nullopt;
  });
}

}  // namespace

bool comes_to_rest(const Model& corrected, const Model& without, const VisitedStates& visited) {
  double largest_rate = 0.0;
  for (const JointSample& each : visited.samples)
    largest_rate = std::max(largest_rate, std::abs(each.of(actuator::CorrectionVariable::rate)));
  const auto bending = [](const VisitedStates::Extreme& each) { return each.state.angles.sum(); };
  const auto [smallest, largest] = std::ranges::minmax_element(visited.extremes, {}, bending);
  if (smallest == visited.extremes.end()) return true;
  for (const auto& extreme : {*smallest, *largest}) {
    for (const CoilCurrents& currents : {extreme.currents, corrected.all_coils(0.0)}) {
      const std::optional<double> reference = last_rate(without, extreme, currents);
      const std::optional<double> rate = last_rate(corrected, extreme, currents);
      if (!rate) return false;
      if (*rate > std::max(slack * reference.value_or(0.0), at_rest * largest_rate)) return false;
    }
  }
  return true;
}

}  // namespace coilwright::measurement::correction
