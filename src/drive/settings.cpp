#include "coilwright/drive/settings.hpp"

#include "drive/require.hpp"

namespace coilwright::drive {
namespace {

constexpr double closeness = 1e-12;
// A mean that is wanted to be the largest possible one is not out of reach by its roundings.
constexpr double enough = 1.0 - 1e-12;

// Halving, which needs no more than that the mean current grows: it may jump.
Setting least_setting(const std::function<SteadyCurrent(double)>& current_at, double most, double mean) {
  require_positive("mean", mean);
  Setting out{.current = current_at(most)};
  if (out.current.mean < enough * mean) return out;
  double below = 0.0;
  out.value = most;
  while (*out.value - below > closeness * most) {
    const double middle = below + 0.5 * (*out.value - below);
    const SteadyCurrent current = current_at(middle);
    if (current.mean < enough * mean) {
      below = middle;
    } else {
      out.value = middle;
      out.current = current;
    }
  }
  return out;
}

}  // namespace

Setting duty_for_mean(const Circuit& circuit, const Driver& driver, double frequency, double mean) {
  return least_setting(
      [&](double duty) { return steady_current(circuit, driver, {.frequency = frequency, .duty = duty}); }, 1.0, mean);
}

Setting voltage_for_mean(const Circuit& circuit, const std::function<Driver(double)>& driver_at, const Pulses& pulses,
                         double mean, double most) {
  require_positive("most", most);
  return least_setting([&](double voltage) { return steady_current(circuit, driver_at(voltage), pulses); }, most, mean);
}

}  // namespace coilwright::drive
