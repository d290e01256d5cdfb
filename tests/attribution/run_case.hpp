#pragma once

#include <string>
#include <vector>

#include "attribution/score.hpp"

namespace attribution {

/// A case from start to end.
struct CaseRun {
  Outcome outcome;
  double seconds_made{};                                 ///< to make and write the set
  double seconds_diagnosed{};                            ///< to read and diagnose it
  std::vector<coilwright::measurement::Phase> phases{};  ///< where that went
};

/// Makes the set, writes it into a temporary folder, reads it back as a user's would be, diagnoses it with `threads`
/// threads and holds the diagnosis against the answer. Throws what reader and diagnosis throw.
[[nodiscard]] CaseRun run_case(const Case& asked, int threads);

}  // namespace attribution
