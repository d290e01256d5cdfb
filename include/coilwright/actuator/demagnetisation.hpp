#pragma once

#include <span>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/magnetics/inner_field.hpp"

namespace coilwright::actuator {

/// How far the magnets are from losing magnetisation for good. A margin is what of the coercivity the field leaves,
/// 1 - |H| / HcJ, from 0 to 1; beyond it, where the magnet is demagnetised, it is negative and goes on as what of the
/// field the magnet does not stand, HcJ / |H| - 1, with the same slope at 0, to -1 where it has no coercivity left.
struct Demagnetisation {
  double margin{};              ///< of the field's mean over the volume of the worst magnet; < 0: it is demagnetised
  double margin_worst_point{};  ///< of the worst point of any magnet's faces; the margin or less
  double irreversible_loss{};   ///< share of its moment that the worst magnet loses for good: irreversible_loss()
};

/// The fields inside the magnets of an assembled design whose magnets have a grade, per magnet and ampere: all that
/// does not depend on temperature. The finger is taken straight, where coils are nearest.
///
/// A magnet's own field is -N M; neighbouring magnets and coils add the mean of theirs over its volume. Coils count
/// with the sign of the current by which they demagnetise. Derivation and limits: docs/theory/actuator.md, "Magnets".
class InnerFields {
 public:
  /// Throws std::invalid_argument where the magnets have no grade.
  InnerFields(const Design& design, const Assembly& assembly);

  /// At `temperatures` (degC, one per component, base to tip) under a current of either sign (A, in every coil). Throws
  /// std::invalid_argument for another number of temperatures.
  [[nodiscard]] Demagnetisation demagnetisation(std::span<const double> temperatures, double current) const;

 private:
  struct Neighbour {
    std::size_t component;
    magnetics::AxialField field;  // of that magnet at its remanence at 20 degC, along the moment of this one, A/m
  };
  struct Inside {
    std::size_t component;
    magnetics::AxialField coils;  // of all coils at 1 A, along its moment, A/m
    std::vector<Neighbour> neighbours;
  };

  magnetics::MagnetGrade grade_;
  double remanence_;  // T, at 20 degC
  magnetics::CylinderSize size_;
  double factor_;  // N
  magnetics::FaceValues face_factors_;
  std::size_t components_;
  std::vector<Inside> magnets_;
};

/// Br of each component's magnet (degC, one temperature per component) over its value at 20 degC, one per magnet, base
/// to tip: 1 where the design's magnets have no grade.
[[nodiscard]] std::vector<double> magnet_strengths(const Design& design, std::span<const double> temperatures);

}  // namespace coilwright::actuator
