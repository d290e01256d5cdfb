#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

namespace coilwright::simulation {

/// Where `changed` first becomes true, to a billionth of the way from `before`, where it is not, to `after`, where it
/// is.
template <typename Changed>
double bisected(double before, double after, const Changed& changed) {
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (before + after);
    (changed(middle) ? after : before) = middle;
  }
  return after;
}

/// Where `excess` crosses zero: from `before`, where it is below, to `after`, where it is above; there or just behind.
template <typename Excess>
double crossing(double before, double after, const Excess& excess) {
  const double low = excess(before);
  const double high = excess(after);
  // What has just been let go sets out from zero itself.
  if (!(low < 0.0 && high > 0.0)) return bisected(before, after, [&](double at) { return excess(at) > 0.0; });
  std::uintmax_t most = 60;
  constexpr int bits = 36;  // as fine as the step's own errors
  return boost::math::tools::toms748_solve(excess, before, after, low, high,
                                           boost::math::tools::eps_tolerance<double>(bits), most)
      .second;
}

}  // namespace coilwright::simulation
