#pragma once

#include <functional>
#include <optional>

#include "coilwright/drive/steady_current.hpp"

namespace coilwright::drive {

/// A setting of a drive that gives a wanted mean current, or the nearest that can be had.
struct Setting {
  std::optional<double> value{};  ///< value of the setting; absent if the mean current is out of reach
  SteadyCurrent current{};        ///< current at that setting; at the largest one if there is no setting
};

/// Finds the duty at which the driver's mean current is `mean` (A; finite, > 0), to 1e-12 of a period. Near duty 1,
/// where the pulse comes to exceed the dead time, and where a current limit chops, the mean current may jump; there it
/// is the smallest duty with at least that mean, and setting.current has the mean that it gives. Throws
/// std::invalid_argument as steady_current() does, and for an invalid mean.
[[nodiscard]] Setting duty_for_mean(const Circuit& circuit, const Driver& driver, double frequency, double mean);

/// Finds the supply voltage up to `most` (V; finite, > 0) for a mean current at given pulses, to 1e-12 of it;
/// `driver_at` makes the driver of each voltage. Throws as duty_for_mean() does.
[[nodiscard]] Setting voltage_for_mean(const Circuit& circuit, const std::function<Driver(double)>& driver_at,
                                       const Pulses& pulses, double mean, double most);

}  // namespace coilwright::drive
