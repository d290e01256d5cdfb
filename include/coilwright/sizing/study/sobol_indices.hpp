#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace coilwright::sizing {

/// Share of a quantity's variance that a scatter causes, with its 95 % interval by bootstrap: by itself, or including
/// its interactions (Saltelli et al., Computer Physics Communications 181 (2010) 259, with Jansen's sums). Each is 0 to
/// 1: an estimate beyond that becomes the bound.
struct SobolIndex {
  double value{};
  double low{};
  double high{};
};

/// Values of one output at Saltelli's designs: at A, at B, and for each input at A with that input from B.
struct SaltelliValues {
  std::vector<double> a, b;
  std::vector<std::vector<double>> mixed;  ///< for each input
};

/// Sobol's indices of every input.
struct SobolIndices {
  std::vector<SobolIndex> first, total;  ///< for each input
};
/// Estimates the indices, with intervals from 400 resamples of the rows by `seed`; absent if the output does not vary.
[[nodiscard]] std::optional<SobolIndices> sobol_indices(const SaltelliValues& values, std::uint64_t seed);

}  // namespace coilwright::sizing
