#pragma once

#include <string>
#include <vector>

#include "attribution/score.hpp"

namespace attribution {

/// One case from the simulation of its set to the score of its diagnosis.
struct CaseRun {
  Outcome outcome;
  double seconds_made{};                                 ///< time to simulate and write the set, s
  double seconds_diagnosed{};                            ///< time to read and diagnose it, s
  std::vector<coilwright::measurement::Phase> phases{};  ///< of the diagnosis
};

/// Simulates the set, writes it into a temporary folder, reads it like a user's, diagnoses it with `threads` threads
/// and scores the diagnosis against the answer. Throws what reader and diagnosis throw.
[[nodiscard]] CaseRun run_case(const Case& asked, int threads);

}  // namespace attribution
