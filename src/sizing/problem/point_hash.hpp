#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace coilwright::sizing {

/// Hash of the bits of a point, by multiplication and folding.
[[nodiscard]] inline std::size_t hash_of(const std::vector<double>& point) noexcept {
  std::uint64_t hash = 0x9E3779B97F4A7C15ULL;
  for (const double value : point) {
    hash ^= std::bit_cast<std::uint64_t>(value);
    hash *= 0xD6E8FEB86659FD93ULL;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

/// `hash_of` for hash tables.
struct PointHash {
  std::size_t operator()(const std::vector<double>& point) const noexcept { return hash_of(point); }
};

}  // namespace coilwright::sizing
