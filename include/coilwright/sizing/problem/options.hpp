#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::sizing {

/// How the space is searched. `automatic` fits local models to the archive and lets NLopt optimise those; every other
/// one is an NLopt algorithm run on the problem itself (in `pareto`: on scalarised problems).
/// Measured in docs/decisions/0006-search-strategy.md.
enum class Algorithm {
  automatic,   ///< models of the archive, optimised by NLopt's SLSQP: the default
  cobyla,      ///< NLOPT_LN_COBYLA
  bobyqa,      ///< NLOPT_LN_BOBYQA, constraints by an exact penalty
  sbplx,       ///< NLOPT_LN_SBPLX, constraints by an exact penalty
  neldermead,  ///< NLOPT_LN_NELDERMEAD, constraints by an exact penalty
  slsqp,       ///< NLOPT_LD_SLSQP, gradients by finite differences (counted as evaluations)
  mma,         ///< NLOPT_LD_MMA, gradients by finite differences (counted as evaluations)
  isres,       ///< NLOPT_GN_ISRES
  crs2,        ///< NLOPT_GN_CRS2_LM, constraints by an exact penalty
  esch,        ///< NLOPT_GN_ESCH, constraints by an exact penalty
  direct_l     ///< NLOPT_GN_DIRECT_L, constraints by an exact penalty
};

/// The name a study uses: "automatic", "cobyla", ...
[[nodiscard]] std::string_view name_of(Algorithm algorithm);

/// The algorithm of that name. Throws std::invalid_argument listing the names there are.
[[nodiscard]] Algorithm algorithm_named(std::string_view name);

/// All of them, in the order of the enumeration.
[[nodiscard]] const std::vector<Algorithm>& algorithms();

/// What a search reports while it runs.
struct Progress {
  std::size_t evaluations{};      ///< made so far
  std::size_t max_evaluations{};  ///< allowed
  std::size_t feasible{};         ///< of those made
  std::size_t front_size{};       ///< designs on the front (1 or 0 for one objective)
};

/// What `search` does once it has an answer.
enum class Afterwards {
  sensitivity,  ///< evaluates the surroundings of the answer, see sensitivity.hpp
  nothing       ///< returns at once
};

/// Limits and seeds of a search. The answer depends on `algorithm`, `max_evaluations`, `seed`, not on `threads`.
struct SearchOptions {
  Algorithm algorithm = Algorithm::automatic;       ///< how to search
  std::size_t max_evaluations = 2000;               ///< designs evaluated at most, all counted; >= 1
  std::uint64_t seed = 1;                           ///< of everything random
  unsigned threads = 0;                             ///< evaluations at once; 0: one per core
  Afterwards afterwards = Afterwards::sensitivity;  ///< `search` only
  std::stop_token stop{};                           ///< asks for an early end; what was found is returned
  std::function<void(const Progress&)> progress{};  ///< called between batches, on the caller's thread; may be empty
};

/// Options of `pareto`.
using ParetoOptions = SearchOptions;

/// Why a search ended.
enum class StopReason {
  evaluation_limit,  ///< max_evaluations were made
  space_exhausted,   ///< every design there is was evaluated
  converged,         ///< the algorithm saw nothing left to gain
  interrupted        ///< asked to stop through `stop`
};

/// "evaluation_limit", "space_exhausted", "converged", "interrupted".
[[nodiscard]] std::string_view name_of(StopReason reason);

}  // namespace coilwright::sizing
