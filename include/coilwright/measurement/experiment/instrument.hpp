#pragma once

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::experiment {

/// How an instrument distorts what it measures, SI.
struct Instrument {
  double noise{};       ///< standard deviation of white Gaussian noise; >= 0
  double resolution{};  ///< readings are multiples of it; 0 if readings are exact
};

/// The instruments of a rig. One camera sees the angles of the joints and of the whole finger.
struct Instruments {
  Instrument angle{}, rate{}, torque{}, force{}, temperature{};
  /// The instrument that measures channels of this kind.
  [[nodiscard]] const Instrument& of(data::ChannelKind kind) const;
};

}  // namespace coilwright::measurement::experiment
