#pragma once

#include "sizing/sampling/samples.hpp"

namespace coilwright::sizing {

/// The box below a local upper bound of a front whose points are not dominated by the neighbours of the bound.
struct Gap {
  Objectives origin;  ///< corner of smallest objectives
  Objectives span;    ///< width along each objective
  double volume = 1;  ///< normalised by the front's frame, >= 0
};

/// The gap below a bound of `samples.bounds()`, down to the neighbours of the bound or the ideal point.
[[nodiscard]] Gap gap_below(const Samples& samples, const UpperBound& bound);

}  // namespace coilwright::sizing
