#pragma once

#include <span>

#include "magnetics/gauss_legendre.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {

/// Where the field is wanted, in the source's cylindrical coordinates. Sizes are multiples of 8; points that are near
/// each other in the list should be near in space, since the effort is chosen per eight.
struct FieldPoints {
  std::span<const double> radius;  ///< distance from the axis, m, >= 0
  std::span<const double> height;  ///< along the axis from the centre, m
};

/// The field there, A/m per A/m of the source's whole surface current.
struct FieldValues {
  std::span<double> radial;
  std::span<double> axial;
};

/// Magnetic field of a body, each sheet by the closed form of its two ends. Relative error about exp(log_error) of the
/// field nearby; loses digits as (distance / size)^3 far away.
void field_of_sheets(const SheetBody& body, double log_error, const FieldPoints& points, const FieldValues& values);

/// The same with the current of each sheet gathered in loops at the heights of `along` (a rule over the length): for
/// points far enough that a few loops are as good as the sheet; no digits are lost however far.
void field_of_loops(const SheetBody& body, double log_error, const QuadratureRule& along, const FieldPoints& points,
                    const FieldValues& values);

}  // namespace coilwright::magnetics
