#include "coilwright/report/simulation/motion_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "coilwright/report/simulation/correction_text.hpp"
#include "coilwright/simulation/correction_reach.hpp"
#include "coilwright/simulation/pressed_joints.hpp"
#include "coilwright/simulation/supply.hpp"

namespace coilwright::report {
namespace {

// What a table of few samples does not show is not seen in its extremes either.
std::string remark_on_samples(const SimulatedMotion& motion) {
  constexpr double far_apart = 0.05;  // s: a third of the period of a finger of 7 Hz
  if (motion.table.empty()) return {};
  const std::vector<double>& times = motion.input.times;
  double widest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) widest = std::max(widest, times[i] - times[i - 1]);
  if (widest <= far_apart) return {};
  return fmt::format(
      "The samples of {} are up to {:.3g} s apart, and the motion between them is not shown: {} shows it.",
      motion.table, widest, motion.cure);
}

// Of the coil that carries most, as the operating point counts currents.
std::string remark_on_supply(const SimulatedMotion& motion) {
  double largest = 0.0;
  for (const actuator::CoilCurrents& currents : motion.input.currents)
    if (currents.size() > 0) largest = std::max(largest, currents.cwiseAbs().maxCoeff());
  if (largest == 0.0) return {};
  const double share = motion.model.current_shares().cwiseAbs().maxCoeff();
  const std::string text = simulation::supply_text(motion.supply_drives, largest / share);
  return text.empty() ? text : "MIND: " + text + ".";
}

// Joints that magnets, weight or a current hold shut for the whole record or a part of it.
std::vector<std::string> remarks_on_joints(const SimulatedMotion& motion) {
  const std::vector<simulation::State>& states = motion.motion.states;
  std::vector<std::size_t> samples(static_cast<std::size_t>(motion.model.joints()));
  for (const simulation::State& state : states)
    for (const int joint : simulation::pressed_joints(motion.model, state.angles))
      ++samples[static_cast<std::size_t>(joint)];
  std::vector<int> always;
  std::vector<int> sometimes;
  for (int joint = 0; joint < motion.model.joints(); ++joint) {
    const std::size_t count = samples[static_cast<std::size_t>(joint)];
    if (count > 0) (count == states.size() ? always : sometimes).push_back(joint);
  }
  std::vector<std::string> out;
  if (!always.empty())
    out.push_back(fmt::format("The faces of {} are pressed together throughout.", simulation::joints_text(always)));
  if (!sometimes.empty())
    out.push_back(fmt::format("The faces of {} are pressed together for a part of the time.",
                              simulation::joints_text(sometimes)));
  return out;
}

}  // namespace

std::vector<std::string> motion_remarks(const SimulatedMotion& motion) {
  std::vector<std::string> out{remark_on_samples(motion), remark_on_supply(motion)};
  std::ranges::move(remarks_on_joints(motion), std::back_inserter(out));
  std::string correction =
      to_text(simulation::correction_reach(motion.model, motion.motion.states, motion.input.currents));
  if (correction.ends_with('\n')) correction.pop_back();
  out.push_back(std::move(correction));
  std::erase(out, std::string());
  return out;
}

}  // namespace coilwright::report
