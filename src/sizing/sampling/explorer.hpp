#pragma once

#include <boost/random/sobol.hpp>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "sizing/sampling/samples.hpp"
#include "sizing/surrogate/infill.hpp"

namespace coilwright::sizing {

/// Designs proposed without a model: quasi-random over the whole space, or bred from good ones. Unknown ones only.
class Explorer {
 public:
  Explorer(const DesignSpace& space, std::uint64_t seed);

  /// The next point of a Sobol sequence (shifted by the seed), the combinations of levels in turn. Empty if many points
  /// in a row are known already.
  [[nodiscard]] std::optional<Candidate> scatter(const Samples& samples);

  /// A member of `parents` moved by the difference of two others in some axes (differential evolution), or, on a grid,
  /// by a step or two in one axis, or given other levels. Empty if many attempts in a row are known already.
  [[nodiscard]] std::optional<Candidate> breed(const Samples& samples, const std::vector<std::size_t>& parents);

  /// The next unknown design in the order of the grid. For spaces with a grid in every variable.
  [[nodiscard]] std::optional<Candidate> enumerate(const Samples& samples);

 private:
  [[nodiscard]] Candidate bred(const Samples& samples, const std::vector<std::size_t>& parents);
  [[nodiscard]] std::uint64_t below(std::uint64_t count);

  const DesignSpace& space_;
  std::mt19937_64 random_;
  std::optional<boost::random::sobol> sobol_;
  std::vector<double> shift_;
  std::uint64_t turn_ = 0, enumerated_ = 0;
};

}  // namespace coilwright::sizing
