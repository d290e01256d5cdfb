#include "sizing/surrogate/gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace coilwright::sizing {
namespace {

// The reference point of the front's hypervolume, which bounds the outermost gaps.
double reference_of(const FrontFrame& frame, std::size_t i) {
  return frame.nadir[i] + 0.1 * (frame.nadir[i] - frame.ideal[i]);
}

}  // namespace

Gap gap_below(const Samples& samples, const UpperBound& bound) {
  const FrontFrame& frame = samples.frame();
  Gap gap;
  for (std::size_t i = 0; i < bound.corner.size(); ++i) {
    double low = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < bound.definers.size(); ++k) {
      if (k != i && bound.definers[k] != UpperBound::none) low = std::min(low, samples[bound.definers[k]].values[i]);
    }
    low = std::max(low, frame.ideal[i]);
    if (!std::isfinite(low)) low = frame.ideal[i];
    const double high = std::min(bound.corner[i], reference_of(frame, i));
    gap.origin.push_back(low);
    gap.span.push_back(high - low);
    gap.volume *= std::max(0.0, (high - low) / (frame.nadir[i] - frame.ideal[i]));
  }
  return gap;
}

}  // namespace coilwright::sizing
