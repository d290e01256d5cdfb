#pragma once

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::experiment {

/// What an instrument does to what it measures, SI.
struct Instrument {
  double noise{};       ///< standard deviation of white Gaussian noise; >= 0
  double resolution{};  ///< readings are multiples of it; 0: exact
};

/// Instruments of a rig; angles of joints and of the whole finger are seen by the same camera.
struct Instruments {
  Instrument angle{}, rate{}, torque{}, force{}, temperature{};
  [[nodiscard]] const Instrument& of(data::Quantity quantity) const;
};

}  // namespace coilwright::measurement::experiment
