#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/part.hpp"

namespace coilwright::sizing {

/// One design of a sweep.
struct SweptDesign {
  std::size_t index{};        ///< as in DesignProblem::point, or among the points of the options
  std::vector<double> point;  ///< coordinates
  Evaluation evaluation;      ///< quantities, objectives and constraints, or the reason why there are none
};

/// How designs are drawn from the whole range of a study.
enum class Sampling {
  latin_hypercube,  ///< one in each of as many equal shares of every variable, the shares paired at random (McKay,
                    ///< Beckman and Conover, Technometrics 21 (1979) 239)
  random            ///< each by itself
};

/// Each by its word in options and results.
inline constexpr std::array<std::pair<std::string_view, Sampling>, 2> sampling_words = {
    {{"latin_hypercube", Sampling::latin_hypercube}, {"random", Sampling::random}}};
/// "latin_hypercube", "random".
[[nodiscard]] std::string_view name_of(Sampling sampling);

/// Which designs stand for the range of a study.
struct DesignSample {
  Sampling sampling = Sampling::latin_hypercube;
  std::size_t drawn{};   ///< how many are drawn; > 0
  std::uint64_t seed{};  ///< another one draws others
};

/// Coordinates of the designs of a sample, in the order of drawing, each once. A list or a grid has equal shares for
/// its values; a study all of whose variables are such may draw a design again, and then has fewer than are drawn.
[[nodiscard]] std::vector<std::vector<double>> sampled_points(const DesignProblem& problem, const DesignSample& sample);

/// How a sweep runs. The result does not depend on it, but for `points`.
struct SweepOptions {
  unsigned threads = 0;                       ///< designs evaluated at the same time; 0: one per core
  std::vector<std::vector<double>> points{};  ///< evaluated in place of the grid; empty: the grid
  std::optional<IndexRange> only{};           ///< the designs with these indices; nothing: all
  std::stop_token stop{};                     ///< ends the sweep early
  /// Evaluates the point of that index, with the bits of the problem's own evaluation, say from what is recorded;
  /// called from several threads at once. Empty: the problem's own.
  std::function<Evaluation(std::size_t index, std::span<const double> point)> evaluate{};
};

/// Evaluates every point of a problem's grid, or those of the options, several at the same time, and passes each to
/// `take` in the order of the points, on the caller's thread. The memory needed is that of some hundred designs, for
/// any size of the grid. Returns the number of designs passed, which is below theirs only after a request to stop; they
/// are then the first ones, without a gap. Throws as DesignProblem::point_count, and what `take` throws.
std::size_t sweep(const DesignProblem& problem, const SweepOptions& options,
                  const std::function<void(const SweptDesign&)>& take);

}  // namespace coilwright::sizing
