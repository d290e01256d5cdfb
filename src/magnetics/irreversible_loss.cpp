#include "coilwright/magnetics/irreversible_loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "magnetics/field_kernels.hpp"
#include "magnetics/require.hpp"

namespace coilwright::magnetics {
namespace {

constexpr std::size_t rings = 8;  // as many as the kernels take points together, and face points a radius
constexpr std::size_t slices = 10;
constexpr std::size_t cells = rings * slices;  // slice by slice from the face at -z, each from the axis outwards
constexpr double cell_rule_error = 1e-8;

static_assert(face_points == 2 * rings);

using CellValues = std::array<double, cells>;

// Axial field, over its surface current, of a solenoid as long as a slice, at the middles of the rings in its own slice
// and in the nine above it; below them it is the same.
CellValues field_of_solenoid(const CylinderSize& size, double radius) {
  CellValues radii{};
  CellValues heights{};
  CellValues radial{};
  CellValues axial{};
  for (std::size_t i = 0; i < cells; ++i) {
    radii[i] = size.radius * (static_cast<double>(i % rings) + 0.5) / rings;
    const std::size_t slice = i / rings;
    heights[i] = size.length * static_cast<double>(slice) / slices;
  }
  const SheetBody sheet{.inner_radius = radius,
                        .outer_radius = radius,
                        .half_length = 0.5 * size.length / slices,
                        .surface_current = 1.0,
                        .shells = 1,
                        .spread = Spread::shells};
  field_of_sheets(sheet, std::log(cell_rule_error), {.radius = radii, .height = heights},
                  {.radial = radial, .axial = axial});
  return axial;
}

// What the magnetisation of one ring does to all: -H over M.
class CellFactors {
 public:
  explicit CellFactors(const CylinderSize& size) {
    CellValues inner{};
    for (std::size_t ring = 0; ring < rings; ++ring) {
      CellValues outer = field_of_solenoid(size, size.radius * static_cast<double>(ring + 1) / rings);
      for (std::size_t i = 0; i < cells; ++i) factors_[ring][i] = inner[i] - outer[i];
      factors_[ring][ring] += 1.0;
      inner = outer;
    }
  }

  // Of a cell in itself.
  [[nodiscard]] double own(std::size_t cell) const { return factors_[cell % rings][cell % rings]; }

  // To the fields in all cells, what `magnetisation` more in the cell `source` adds.
  void add(std::size_t source, double magnetisation, CellValues& fields) const {
    const CellValues& factors = factors_[source % rings];
    const std::size_t from = source / rings;
    for (std::size_t slice = 0; slice < slices; ++slice) {
      const double* factor = &factors[(from > slice ? from - slice : slice - from) * rings];
      double* field = &fields[slice * rings];
      for (std::size_t ring = 0; ring < rings; ++ring) field[ring] -= factor[ring] * magnetisation;
    }
  }

 private:
  std::array<CellValues, rings> factors_{};
};

// The outside field at the middles of the cells.
CellValues at_cells(const FaceValues& faces) {
  const auto on_face = [&faces](std::size_t face, std::size_t ring) {
    const double* value = &faces[face * rings];
    // The face points lie at the rings' inner radii; the last ring goes on as it came.
    return ring + 1 < rings ? 0.5 * (value[ring] + value[ring + 1]) : 1.5 * value[ring] - 0.5 * value[ring - 1];
  };
  CellValues out{};
  for (std::size_t i = 0; i < cells; ++i) {
    const std::size_t slice = i / rings;
    const double upper = (static_cast<double>(slice) + 0.5) / slices;
    out[i] = (1.0 - upper) * on_face(0, i % rings) + upper * on_face(1, i % rings);
  }
  return out;
}

// Of the curve beyond the knee, M0 over HcJ.
double steepness(const DemagnetisationCurve& curve) {
  return curve.squareness / (1.0 - curve.squareness);
}

// M of a cell in a field `applied` by everything else and its own -N M: the one place where both meet.
double magnetisation_of(const DemagnetisationCurve& curve, double applied, double own_factor) {
  const double on_recoil =
      (curve.magnetisation + curve.susceptibility * applied) / (1.0 + curve.susceptibility * own_factor);
  const double slope = steepness(curve) * curve.magnetisation / curve.coercivity;
  const double beyond = (steepness(curve) * curve.magnetisation + slope * applied) / (1.0 + slope * own_factor);
  return std::max(-curve.magnetisation, std::min(on_recoil, beyond));
}

// Where the recoil line meets what is beyond it.
double magnetisation_at_knee(const DemagnetisationCurve& curve) {
  const double slope = steepness(curve) * curve.magnetisation / curve.coercivity;
  return curve.magnetisation * (1.0 - curve.susceptibility * (steepness(curve) - 1.0) / (slope - curve.susceptibility));
}

}  // namespace

double DemagnetisationCurve::at(double field) const noexcept {
  if (coercivity <= 0.0) return field < 0.0 ? -magnetisation : magnetisation;
  return magnetisation_of(*this, field, 0.0);
}

double irreversible_loss(const CylinderSize& size, const DemagnetisationCurve& curve, const FaceValues& outside) {
  require_positive("cylinder radius", size.radius);
  require_positive("cylinder length", size.length);
  require(std::isfinite(curve.magnetisation) && curve.magnetisation >= 0.0, "magnetisation", "finite and >= 0",
          curve.magnetisation);
  require_finite("coercivity", curve.coercivity);
  require(curve.susceptibility >= 0.0, "susceptibility", ">= 0", curve.susceptibility);
  require(curve.squareness > 0.5 && curve.squareness < 1.0, "squareness", "> 0.5 and < 1", curve.squareness);
  if (curve.coercivity <= 0.0 || curve.magnetisation == 0.0) return 1.0;
  const CellFactors factor(size);
  CellValues fields = at_cells(outside);
  CellValues magnetisation{};
  magnetisation.fill(curve.magnetisation);
  for (std::size_t i = 0; i < cells; ++i) factor.add(i, curve.magnetisation, fields);
  // Cell by cell. The energy whose least value is sought is convex (factors are symmetric and positive by volume, the
  // curve rises), so this settles from any start. Beyond the knee cells go past their least value by three
  // tenths of the way to it (successive over-relaxation), where the energy still falls, along one parabola: it takes
  // six tenths of the sweeps.
  constexpr int most_sweeps = 1000;
  constexpr double settled = 1e-8;
  constexpr double relaxation = 1.3;
  const double knee = magnetisation_at_knee(curve);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0.0;
    for (std::size_t i = 0; i < cells; ++i) {
      const double others = fields[i] + factor.own(i) * magnetisation[i];
      const double least = magnetisation_of(curve, others, factor.own(i));
      const double beyond = magnetisation[i] + relaxation * (least - magnetisation[i]);
      const double next = least < knee ? std::max(-curve.magnetisation, std::min(beyond, knee)) : least;
      const double step = next - magnetisation[i];
      magnetisation[i] += step;
      factor.add(i, step, fields);
      change = std::max(change, std::abs(step));
    }
    if (change < settled * curve.magnetisation) break;
  }
  double kept = 0.0;
  double volume = 0.0;
  for (std::size_t i = 0; i < cells; ++i) {
    const double share = static_cast<double>(2 * (i % rings) + 1);
    kept += share * (magnetisation[i] - curve.susceptibility * fields[i]);
    volume += share;
  }
  return std::max(0.0, 1.0 - kept / (volume * curve.magnetisation));
}

}  // namespace coilwright::magnetics
