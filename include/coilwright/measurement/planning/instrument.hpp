#pragma once

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::planning {

/// How the noise of an instrument is spread over frequencies.
struct NoiseColour {
  /// White; white behind a low-pass filter of first order; or with a power that falls as 1 / f.
  enum class Kind { white, low_pass, one_over_f };
  Kind kind = Kind::white;
  double frequency{};  ///< of the low pass (-3 dB), Hz; > 0 for Kind::low_pass
};

/// How an instrument distorts what it measures, SI.
struct Instrument {
  double noise{};       ///< standard deviation of Gaussian noise, whatever its colour; >= 0
  double resolution{};  ///< readings are multiples of it; 0 if readings are exact
  NoiseColour colour{};
  double hum{};               ///< amplitude of a sine beside the noise; >= 0
  double hum_frequency{};     ///< Hz
  double outlier_share{};     ///< of the samples that are off by something else; 0 to 1
  double smallest_outlier{};  ///< size of these errors, evenly from the smallest to the largest, either sign
  double largest_outlier{};
};

/// The instruments of a rig. One camera sees the angles of the joints and of the whole finger.
struct Instruments {
  Instrument angle{}, rate{}, torque{}, force{}, temperature{};
  /// Noise of the column that records the input, A, V or N m; white.
  double input_noise{};
  /// The instrument that measures channels of this kind.
  [[nodiscard]] const Instrument& of(data::ChannelKind kind) const;
};

}  // namespace coilwright::measurement::planning
