#pragma once

#include <initializer_list>

#include "coilwright/mechanics/contact_impulses.hpp"

namespace coilwright::mechanics {

/// A vector of these coordinates.
inline CoordinateVector coordinates(std::initializer_list<double> values) {
  CoordinateVector out(static_cast<Eigen::Index>(values.size()));
  int i = 0;
  for (const double value : values) out[i++] = value;
  return out;
}

}  // namespace coilwright::mechanics
