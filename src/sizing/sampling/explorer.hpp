#pragma once

#include <boost/random/sobol.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "sizing/sampling/samples.hpp"
#include "sizing/sampling/unit_point.hpp"

namespace coilwright::sizing {

/// Proposes unknown designs without a model: from a quasi-random sequence, by differential evolution, or one by one.
class Explorer {
 public:
  /// `space` must outlive it; `seed` shifts the sequence and draws the recombinations.
  Explorer(const DesignSpace& space, std::uint64_t seed);

  /// The next unknown point of a Sobol sequence over the whole space, the combinations of levels in turn. Empty if many
  /// points in a row are known already.
  [[nodiscard]] std::optional<UnitPoint> sobol_point(const Samples& samples);

  /// A member of `parents` (indices of samples) moved by the scaled difference of two others in some axes, or, on a
  /// grid, by one to three steps in one axis, or given another combination of levels. Empty if many attempts in a row
  /// are known already.
  [[nodiscard]] std::optional<UnitPoint> evolved_point(const Samples& samples, const std::vector<std::size_t>& parents);

  /// A design that differs from another in one coordinate.
  struct Probe {
    UnitPoint point;
    std::size_t axis{};
  };
  /// A member of `parents` with one coordinate drawn anew from its whole range: from a design that is good in all
  /// others it shows what that coordinate does. Coordinates whose probes were promising (`count_probe`) are drawn more
  /// often. Empty if many attempts in a row are known already.
  [[nodiscard]] std::optional<Probe> probe(const Samples& samples, const std::vector<std::size_t>& parents);
  /// Takes in what became of a probe.
  void count_probe(std::size_t axis, bool promising);

  /// The next unknown design in the order of the grid. For spaces with a grid in every variable.
  [[nodiscard]] std::optional<UnitPoint> next_of_grid(const Samples& samples);

 private:
  [[nodiscard]] UnitPoint recombined(const Samples& samples, const std::vector<std::size_t>& parents);
  [[nodiscard]] std::size_t drawn_axis();
  [[nodiscard]] std::uint64_t below(std::uint64_t count);

  const DesignSpace& space_;
  std::mt19937_64 random_;
  std::optional<boost::random::sobol> sobol_;
  std::vector<double> shift_;
  std::vector<double> probes_, promising_probes_;  // of each coordinate
  std::uint64_t sobol_points_ = 0, grid_points_ = 0;
};

}  // namespace coilwright::sizing
