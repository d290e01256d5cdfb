#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::sizing {

/// Returns the value at `x` and fills `gradient` unless it is empty. May throw.
using NloptObjective = std::function<double(std::span<const double> x, std::span<double> gradient)>;
/// Fills `values` (<= 0 is feasible) and, unless it is empty, `jacobian` (row after row) at `x`. May throw.
using NloptConstraints =
    std::function<void(std::span<const double> x, std::span<double> values, std::span<double> jacobian)>;

/// One minimisation by NLopt.
struct NloptTask {
  Algorithm algorithm{};             ///< any but `automatic`
  std::vector<double> lower, upper;  ///< bounds; lower < upper in each
  std::vector<double> start;         ///< clamped to the bounds
  double first_step{};               ///< of derivative-free algorithms; 0: NLopt's default
  NloptObjective objective;          ///< always set
  std::size_t constraint_count{};    ///< 0 for algorithms without `takes_constraints`
  NloptConstraints constraints{};    ///< set if constraint_count > 0
  int max_calls{};                   ///< largest number of calls of the objective
  double relative_tolerance{};       ///< on x; 0: none
  std::uint64_t seed{};              ///< of NLopt's random generator, which each thread has
};

/// Whether the algorithm itself handles inequality constraints.
[[nodiscard]] bool takes_constraints(Algorithm algorithm);
/// Whether the algorithm asks for gradients.
[[nodiscard]] bool takes_gradients(Algorithm algorithm);
/// Whether the algorithm searches the whole box, so that another start would only repeat the run.
[[nodiscard]] bool is_global(Algorithm algorithm);

/// Runs NLopt and returns its last point, which is a suggestion only: callers keep what they evaluated. An exception of
/// a callback is stored, NLopt is asked to stop, and the exception is thrown again here, so none crosses NLopt. A
/// failure that NLopt reports (roundoff, a degenerate box) is no error: the point reached so far is returned.
[[nodiscard]] std::vector<double> run_nlopt(const NloptTask& task);

}  // namespace coilwright::sizing
