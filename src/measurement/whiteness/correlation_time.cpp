#include "coilwright/measurement/whiteness/correlation_time.hpp"

#include <algorithm>

namespace coilwright::measurement::whiteness {
namespace {

struct Piece {
  const double* values;
  std::size_t size;
};

std::vector<Piece> pieces_of(std::span<const ScaledResidual> residuals) {
  std::vector<Piece> pieces;
  for (const ScaledResidual& residual : residuals)
    for (std::size_t w = 0; w < residual.starts.size(); ++w) {
      const std::size_t end = w + 1 < residual.starts.size() ? residual.starts[w + 1] : residual.values.size();
      pieces.push_back({residual.values.data() + residual.starts[w], end - residual.starts[w]});
    }
  return pieces;
}

}  // namespace

double correlation_time(std::span<const ScaledResidual> residuals) {
  check(residuals);
  const std::vector<Piece> pieces = pieces_of(residuals);
  std::size_t longest = 0;
  double energy = 0.0;
  double samples = 0.0;
  for (const Piece& piece : pieces) {
    longest = std::max(longest, piece.size);
    samples += static_cast<double>(piece.size);
    for (std::size_t i = 0; i < piece.size; ++i) energy += piece.values[i] * piece.values[i];
  }
  if (energy <= 0.0) return 1.0;

  double time = 1.0;
  constexpr double window = 5.0;
  for (std::size_t lag = 1; lag < longest && static_cast<double>(lag) < window * std::max(time, 1.0); ++lag) {
    double sum = 0.0;
    for (const Piece& piece : pieces)
      for (std::size_t i = lag; i < piece.size; ++i) sum += piece.values[i] * piece.values[i - lag];
    // Divided by all samples, not by the pairs at this lag: long lags, known badly, then weigh less.
    time += 2.0 * sum / energy;
  }
  return std::clamp(time, 1.0, samples);
}

}  // namespace coilwright::measurement::whiteness
