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

/// The method by which designs are drawn from the whole range of a study.
enum class Sampling {
  latin_hypercube,  ///< one in each of as many equal shares of every variable, the shares paired at random (McKay,
                    ///< Beckman and Conover, Technometrics 21 (1979) 239)
  random            ///< each by itself
};

/// The word of each in options and results.
inline constexpr std::array<std::pair<std::string_view, Sampling>, 2> sampling_words = {
    {{"latin_hypercube", Sampling::latin_hypercube}, {"random", Sampling::random}}};
/// The word of a method: "latin_hypercube", "random".
[[nodiscard]] std::string_view name_of(Sampling sampling);

/// A sample of designs that represents the range of a study.
struct DesignSample {
  Sampling sampling = Sampling::latin_hypercube;
  std::size_t drawn{};   ///< number of designs drawn; > 0
  std::uint64_t seed{};  ///< another one draws others
};

/// Coordinates of the designs of a sample, in the order of drawing, each once. The values of a list or a grid have
/// equal shares. A study whose variables are all lists or grids may draw a design twice, and then has fewer designs
/// than are drawn.
[[nodiscard]] std::vector<std::vector<double>> sampled_points(const DesignProblem& problem, const DesignSample& sample);

/// Settings of a sweep. Only `points` changes the result.
struct SweepOptions {
  unsigned threads = 0;                       ///< designs evaluated at the same time; 0: one per core
  std::vector<std::vector<double>> points{};  ///< evaluated in place of the grid; empty: the grid
  std::optional<IndexRange> only{};           ///< the designs with these indices; absent: all
  std::stop_token stop{};                     ///< ends the sweep early
  /// Evaluates the point of that index, with the bits of the problem's own evaluation; it may answer from a record.
  /// Called from several threads at once. Empty: the problem's own evaluation.
  std::function<Evaluation(std::size_t index, std::span<const double> point)> evaluate{};
};

/// Evaluates every point of a problem's grid, or those of the options, several at the same time, and passes each to
/// `take` in the order of the points, on the caller's thread. It needs the memory of some hundred designs, for any size
/// of the grid. Returns the number of designs passed, which is smaller than theirs only after a request to stop; they
/// are then the first ones, without a gap. Throws as DesignProblem::point_count, and passes on exceptions of `take`.
std::size_t sweep(const DesignProblem& problem, const SweepOptions& options,
                  const std::function<void(const SweptDesign&)>& take);

}  // namespace coilwright::sizing
