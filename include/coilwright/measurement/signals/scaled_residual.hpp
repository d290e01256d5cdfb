#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace coilwright::measurement::signals {

/// The residual of a model in one channel of one run, in units of the noise, and white if the model is right: noise of
/// known colour has been whitened.
struct ScaledResidual {
  std::string run{};                   ///< its file, as WhitenessResult::where names it
  std::vector<double> times{};         ///< s, increasing; empty on a bench, whose samples are in the order of the file
  std::vector<double> values{};        ///< residual / sigma; finite
  std::vector<std::size_t> starts{0};  ///< first sample of each window, increasing from 0; {0} without windows
  /// Whether sigma was estimated from the same record: it may then be wrong by more than its degrees of freedom say,
  /// because motion and colour enter it.
  bool own_estimate = false;
  /// Degrees of freedom of the estimate of the noise's variance; infinite where it is known.
  double freedom = std::numeric_limits<double>::infinity();
  /// Where the spectrum of the noise was estimated too: how well each part of it is known, from the lowest frequency
  /// on.
  struct KnownBand {
    double to{};       ///< cycles per sample
    double freedom{};  ///< number of squares from which its level was estimated
  };
  std::vector<KnownBand> bands{};

  /// Degrees of freedom of the noise's level below a frequency, in cycles per sample.
  [[nodiscard]] double freedom_below(double frequency) const;
  /// The same at a frequency.
  [[nodiscard]] double freedom_at(double frequency) const;
};

/// Throws std::invalid_argument naming run and rule if sizes do not match or a value is not finite.
void validate_residuals(std::span<const ScaledResidual> residuals);

}  // namespace coilwright::measurement::signals
