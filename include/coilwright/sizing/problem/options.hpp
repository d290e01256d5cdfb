#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::sizing {

/// The method of a search. `automatic` fits local models to the archive and lets NLopt optimise those. Every other one
/// is an NLopt algorithm that runs on the problem itself (in `pareto`, on scalarised problems).
/// docs/decisions/0006-search-strategy.md compares them.
enum class Algorithm {
  automatic,   ///< models of the archive, optimised by NLopt's SLSQP
  cobyla,      ///< NLOPT_LN_COBYLA
  bobyqa,      ///< NLOPT_LN_BOBYQA, constraints by a penalty
  sbplx,       ///< NLOPT_LN_SBPLX, constraints by a penalty
  neldermead,  ///< NLOPT_LN_NELDERMEAD, constraints by a penalty
  slsqp,       ///< NLOPT_LD_SLSQP, gradients by finite differences (counted as evaluations)
  mma,         ///< NLOPT_LD_MMA, gradients by finite differences (counted as evaluations)
  isres,       ///< NLOPT_GN_ISRES
  crs2,        ///< NLOPT_GN_CRS2_LM, constraints by a penalty
  esch,        ///< NLOPT_GN_ESCH, constraints by a penalty
  direct_l     ///< NLOPT_GN_DIRECT_L, constraints by a penalty
};

/// The name a study uses: "automatic", "cobyla", ...
[[nodiscard]] std::string_view name_of(Algorithm algorithm);

/// The algorithm of that name. Throws std::invalid_argument listing the names.
[[nodiscard]] Algorithm algorithm_named(std::string_view name);

/// All algorithms, in the order of the enumeration.
[[nodiscard]] const std::vector<Algorithm>& algorithms();

/// A report of a search while it runs.
struct Progress {
  std::size_t evaluations{};      ///< number of designs evaluated so far
  std::size_t max_evaluations{};  ///< number of designs allowed
  std::size_t feasible{};         ///< number of feasible designs so far
  std::size_t front_size{};       ///< number of designs on the front (1 or 0 for one objective)
};

/// The steps of `search` after it has an answer.
enum class Afterwards {
  sensitivity,  ///< evaluates the surroundings of the answer, see sensitivity.hpp
  nothing       ///< returns at once
};

/// Settings of a search. The answer depends on `algorithm`, `max_evaluations` and `seed`, but not on `threads`.
struct SearchOptions {
  Algorithm algorithm = Algorithm::automatic;  ///< method of the search
  std::size_t max_evaluations = 2000;          ///< largest number of designs evaluated, including failed ones; >= 1
  std::uint64_t seed = 1;                      ///< of every random number; any value
  unsigned threads = 0;                        ///< designs evaluated at the same time; 0: one per core
  Afterwards afterwards = Afterwards::sensitivity;  ///< `search` only
  std::stop_token stop{};                           ///< ends the search early; what was found is returned
  std::function<void(const Progress&)> progress{};  ///< called between rounds, on the caller's thread; may be empty
};

/// Options of `pareto`.
using ParetoOptions = SearchOptions;

/// Why a search ended.
enum class StopReason {
  evaluation_limit,  ///< max_evaluations designs were evaluated
  space_exhausted,   ///< every design of the space was evaluated
  converged,         ///< the algorithm ended by itself
  interrupted        ///< `stop` asked for an end
};

/// The word in results: "evaluation_limit", "space_exhausted", "converged", "interrupted".
[[nodiscard]] std::string_view name_of(StopReason reason);

}  // namespace coilwright::sizing
