#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace coilwright::measurement::signals {

/// A stretch of a record in which nothing moves, evenly sampled.
struct StillPiece {
  std::span<const double> values{};
  double interval{};  ///< s between samples
};

/// A spectral line of the noise: hum.
struct NoiseLine {
  double frequency{};  ///< Hz
  double amplitude{};  ///< in the unit of the record
};

/// The noise of an instrument as a record without motion shows it.
struct NoiseColour {
  /// A part of the spectrum without its lines.
  struct Band {
    double from{}, to{};  ///< Hz
    double density{};     ///< mean squared coefficient over the variance: 1 in all bands of white noise
    double freedom{};     ///< number of coefficients in it
  };
  /// Density in the lowest band of noise that grows towards low frequencies: density (f / to)^-exponent, level below
  /// `from`, where the record shows nothing.
  struct LowEnd {
    double from{}, to{};  ///< Hz
    double exponent{};    ///< > 0; 1 is 1/f noise
    double density{};     ///< at `to`
  };
  double sigma{};                   ///< standard deviation without the lines, in the unit of the record
  double freedom{};                 ///< degrees of freedom of its square
  std::vector<Band> bands{};        ///< from the lowest frequency to the highest, without gaps
  std::optional<LowEnd> low_end{};  ///< nothing: the lowest band is level
  std::vector<NoiseLine> lines{};
  bool is_white{};  ///< whether the bands differ no more than chance makes them, once in a hundred records

  /// The density at a frequency in Hz, between the middles of the bands straight in both logarithms.
  [[nodiscard]] double density_at(double frequency) const;
};

/// Level, lines and spectrum of the noise in these pieces, all of one sampling interval. The mean of each piece is
/// removed, so that nothing is known below one half of its inverse length, and the density there is that of the lowest
/// band, or goes on growing to a quarter of that frequency where its 96 lowest coefficients grow. Bands are a quarter
/// of an octave wide and have at least 16 cosine coefficients; lines are those ordinates of the longest piece's
/// periodogram that exceed their surroundings by more than chance, once in a thousand records. Throws
/// std::invalid_argument where there are fewer than 32 samples in the longest piece.
[[nodiscard]] NoiseColour colour_of(std::span<const StillPiece> pieces);

}  // namespace coilwright::measurement::signals
