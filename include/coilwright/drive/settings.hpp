#pragma once

#include <functional>
#include <optional>

#include "coilwright/drive/steady_current.hpp"

namespace coilwright::drive {

/// A setting of a drive that gives a wanted mean current, or what can be had.
struct Setting {
  std::optional<double> value{};  ///< of the setting; nothing where the mean current is out of reach
  SteadyCurrent current{};        ///< at that setting; at the largest one where there is none
};

/// The duty at which the driver's mean current is `mean` (A; finite, > 0), to 1e-12 of a period. Just below duty 1 and
/// where the pulse comes to exceed the dead time the mean current jumps, and so it may where a current limit chops:
/// there it is the smallest duty with at least that mean; setting.current has what it gives. Throws
/// std::invalid_argument as steady_current() does, and for a mean that is none.
[[nodiscard]] Setting duty_for_mean(const Circuit& circuit, const Driver& driver, double frequency, double mean);

/// The same for a supply voltage up to `most` (V; finite, > 0), to 1e-12 of it, at given pulses; `driver_at` makes the
/// driver of each voltage.
[[nodiscard]] Setting voltage_for_mean(const Circuit& circuit, const std::function<Driver(double)>& driver_at,
                                       const Pulses& pulses, double mean, double most);

}  // namespace coilwright::drive
