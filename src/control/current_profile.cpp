#include "coilwright/control/current_profile.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace coilwright::control {

simulation::ModelInput input_of(const actuator::Model& model, const CurrentProfile& profile, double duration) {
  if (profile.times.empty() || profile.times.size() != profile.levels.size() || profile.times.front() != 0.0)
    throw std::invalid_argument("profile must have one level a time, the first at time 0");
  for (const double level : profile.levels)
    if (!std::isfinite(level))
      throw std::invalid_argument(fmt::format("profile: levels must be finite; got {}", level));
  if (!(duration > profile.times.back()))
    throw std::invalid_argument(
        fmt::format("duration must be beyond the profile's last time, {} s; got {}", profile.times.back(), duration));
  simulation::ModelInput input;
  input.times = profile.times;
  input.times.push_back(duration);
  for (const double level : profile.levels) input.currents.push_back(model.all_coils(level));
  input.currents.push_back(model.all_coils(profile.last()));
  return input;
}

}  // namespace coilwright::control
