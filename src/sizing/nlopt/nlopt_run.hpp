#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::sizing {

/// Value at `x`; fills `gradient` unless it is empty. May throw.
using NloptObjective = std::function<double(std::span<const double> x, std::span<double> gradient)>;
/// Fills `values` (<= 0 is feasible) and, unless it is empty, `jacobian` (row after row) at `x`. May throw.
using NloptConstraints =
    std::function<void(std::span<const double> x, std::span<double> values, std::span<double> jacobian)>;

/// One minimisation by NLopt.
struct NloptTask {
  Algorithm algorithm{};             ///< any but `automatic`
  std::vector<double> lower, upper;  ///< bounds; lower < upper in each
  std::vector<double> start;         ///< clamped to the bounds
  double first_step{};               ///< of the derivative-free algorithms; 0: NLopt's own
  NloptObjective objective;          ///< always set
  std::size_t constraint_count{};    ///< 0 for algorithms without `takes_constraints`
  NloptConstraints constraints{};    ///< set if constraint_count > 0
  int max_calls{};                   ///< of the objective
  double relative_tolerance{};       ///< on x; 0: none
  std::uint64_t seed{};              ///< NLopt's generator, per thread
};

/// Whether the algorithm itself handles inequality constraints.
[[nodiscard]] bool takes_constraints(Algorithm algorithm);
/// Whether the algorithm asks for gradients.
[[nodiscard]] bool takes_gradients(Algorithm algorithm);
/// Whether it looks at the whole box by itself, so that another start would only repeat it.
[[nodiscard]] bool is_global(Algorithm algorithm);

/// Runs NLopt and returns its last point. The point is a suggestion only: callers keep what they evaluated. What a
/// callback throws is stored, NLopt asked to stop, and the exception rethrown here: none ever crosses NLopt. NLopt's
/// own complaints (roundoff, a degenerate box) are not errors: the point reached so far is returned.
[[nodiscard]] std::vector<double> run_nlopt(const NloptTask& task);

}  // namespace coilwright::sizing
