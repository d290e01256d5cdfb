#pragma once

#include <functional>
#include <optional>

#include "measurement/fit/least_squares.hpp"

namespace coilwright::measurement::fit {

/// `made()`, or what an earlier run of the program recorded of it (PreparedRun::known_fits): to the last bit the same,
/// the local numbers of `blocks` included. `blocks` must be as they were built for `request`.
[[nodiscard]] std::optional<Optimum> recorded_or(const FitRequest& request, ResidualBlocks& blocks, Unknowns unknowns,
                                                 const std::function<std::optional<Optimum>()>& made);

}  // namespace coilwright::measurement::fit
