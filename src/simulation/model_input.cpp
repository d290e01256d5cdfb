#include "coilwright/simulation/model_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>

namespace coilwright::simulation {
namespace {

using actuator::CoilCurrents;
using actuator::Model;

// `rule` has a place for what is needed and one for what is there.
void require_width(std::size_t width, int needed, const char* rule) {
  if (width != static_cast<std::size_t>(needed))
    throw std::invalid_argument(fmt::format(fmt::runtime(rule), needed, width));
}

}  // namespace

void ModelInput::require_fits(const Model& model) const {
  if (times.empty()) throw std::invalid_argument("input: at least one sample is needed; got 0");
  if (currents.size() != times.size())
    throw std::invalid_argument(
        fmt::format("input: one row of currents per time, {} here; got {}", times.size(), currents.size()));
  if (!joint_torques.empty() && joint_torques.size() != times.size())
    throw std::invalid_argument(
        fmt::format("input: one row of torques per time, {} here; got {}", times.size(), joint_torques.size()));
  if (!straight.empty() && straight.size() != times.size())
    throw std::invalid_argument(
        fmt::format("input: one flag per time, {} here, or none; got {}", times.size(), straight.size()));
  if (!passed.empty() && passed.size() != times.size())
    throw std::invalid_argument(
        fmt::format("input: one flag per time, {} here, or none; got {}", times.size(), passed.size()));
  for (std::size_t i = 0; i < times.size(); ++i)
    if (passes(i) && (i == 0 || !goes_straight(i - 1) || !goes_straight(i)))
      throw std::invalid_argument(fmt::format(
          "input: sample {} is passed without a corner, and the input does not go straight on both sides of it", i));
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || (i > 0 && times[i] <= times[i - 1]))
      throw std::invalid_argument(fmt::format("input: time must increase; sample {} is at {} s", i, times[i]));
    if (currents[i].size() != model.coils() || !currents[i].allFinite())
      throw std::invalid_argument(
          fmt::format("input: sample {} must have {} finite currents; got {}", i, model.coils(), currents[i].size()));
    if (!joint_torques.empty() && (joint_torques[i].size() != model.joints() || !joint_torques[i].allFinite()))
      throw std::invalid_argument(fmt::format("input: sample {} must have {} finite torques; got {}", i, model.joints(),
                                              joint_torques[i].size()));
  }
}

ModelInput ModelInput::part(std::size_t first, std::size_t last) const {
  const auto samples = [&](const auto& rows) {
    return std::decay_t<decltype(rows)>(rows.begin() + static_cast<std::ptrdiff_t>(first),
                                        rows.begin() + static_cast<std::ptrdiff_t>(last));
  };
  ModelInput out{.times = samples(times), .currents = samples(currents)};
  if (!joint_torques.empty()) out.joint_torques = samples(joint_torques);
  if (!straight.empty()) out.straight = samples(straight);
  if (!passed.empty()) {
    out.passed = samples(passed);
    if (!out.passed.empty()) out.passed.front() = out.passed.back() = 0;
  }
  return out;
}

void require_can_drive(const Model& model, const CommandedInput& command) {
  if (command.rows.empty()) return;
  const std::size_t width = command.rows.front().size();
  const bool current = command.drive == Drive::current;
  if (command.drive == Drive::torque)
    return require_width(width, model.joints(), "needs a torque for each of the {} joints; got {}");
  if (model.coils() == 0) throw std::invalid_argument("drives coils, and the model has none");
  if (command.addressing == Addressing::common)
    require_width(width, 1, "needs {} value for all coils; got {}");
  else
    require_width(width, model.coils(),
                  current ? "needs a current for each of the {} coils; got {}"
                          : "needs a voltage for each of the {} coils; got {}");
  if (!current && !model.coil_resistance())
    throw std::invalid_argument("has a voltage, and a lumped model has no coil resistance");
}

ModelInput model_input(const Model& model, const CommandedInput& command) {
  require_can_drive(model, command);
  ModelInput out{.times = command.times};
  out.currents.reserve(command.rows.size());
  for (const std::vector<double>& row : command.rows) {
    const Eigen::Map<const Eigen::VectorXd> values(row.data(), static_cast<Eigen::Index>(row.size()));
    if (command.drive == Drive::torque) {
      out.currents.push_back(model.all_coils(0.0));
      out.joint_torques.emplace_back(values);
      continue;
    }
    const bool common = command.addressing == Addressing::common;
    if (command.drive == Drive::voltage)
      out.currents.push_back(
          model.currents_under(common ? CoilCurrents::Constant(model.coils(), row[0]) : CoilCurrents(values)));
    else
      out.currents.push_back(common ? model.all_coils(row[0]) : CoilCurrents(values));
  }
  return out;
}

ModelInput step_input(const Model& model, const StepInput& step) {
  return model_input(model, step_command(step));
}

ModelInput sine_input(const Model& model, const SineInput& sine) {
  return model_input(model, sine_command(sine));
}

}  // namespace coilwright::simulation
