#pragma once

#include <array>
#include <cstddef>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// How the current of a body is spread over its radius.
enum class Spread { shells, uniform };

/// A body as current sheets round its side: what a coil and a magnet have in common.
struct SheetBody {
  double inner_radius;     ///< m, of the innermost sheet
  double outer_radius;     ///< m, of the outermost sheet
  double half_length;      ///< m
  double surface_current;  ///< A/m, sum over all sheets
  int shells;              ///< number of sheets when spread is shells
  Spread spread;

  [[nodiscard]] double mean_radius() const noexcept { return 0.5 * (inner_radius + outer_radius); }
  [[nodiscard]] double half_width() const noexcept { return 0.5 * (outer_radius - inner_radius); }
};

[[nodiscard]] SheetBody sheets_of(const ThickCoil& coil, double current) noexcept;
/// Without what recoil changes.
[[nodiscard]] SheetBody sheets_of(const CylinderMagnet& magnet) noexcept;
/// With what recoil leaves in the mean over the magnet: its field from afar.
[[nodiscard]] SheetBody weakened_sheets_of(const CylinderMagnet& magnet);

}  // namespace coilwright::magnetics
