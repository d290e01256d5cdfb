#pragma once

namespace coilwright::measurement::fit {

/// A value and the number of runs that were simulated to obtain it. One simulated run is one run of the set, with all
/// its windows, at one set of parameters. Simulations for the derivatives with respect to the initial states of windows
/// are not counted.
template <typename Value>
struct Counted {
  Value value{};
  long simulated_runs{};
};

}  // namespace coilwright::measurement::fit
