#pragma once

#include <span>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/magnetics/inner_field.hpp"

namespace coilwright::actuator {

/// The distance of the magnets from losing magnetisation for good. A margin is the share of the coercivity that the
/// field leaves, 1 - |H| / HcJ, from 0 to 1. Where the magnet is demagnetised it is negative, HcJ / |H| - 1, with the
/// same slope at 0, down to -1 where no coercivity is left.
struct Demagnetisation {
  double margin{};              ///< of the field's mean over the volume of the worst magnet; < 0: it is demagnetised
  double margin_worst_point{};  ///< of the worst point of any magnet's faces; the margin or less
  double irreversible_loss{};   ///< share of its moment that the worst magnet loses for good: irreversible_loss()
};

/// The fields inside the magnets of an assembled design whose coercivity is known, per magnet and ampere: everything
/// that does not depend on temperature. The finger is taken straight, where coils are nearest.
///
/// A magnet's own field is -N M; neighbouring magnets and coils add the mean of their fields over its volume. Coils
/// count with the sign of the current by which they demagnetise. Derivation and limits: docs/theory/actuator.md,
/// "Magnets".
class InnerFields {
 public:
  /// Computes the fields. Throws std::invalid_argument if !design.magnet.has_coercivity().
  InnerFields(const Design& design, const Assembly& assembly);

  /// The margins at `temperatures` (degC, one per component, base to tip) under a current of either sign (A, in every
  /// coil). Throws std::invalid_argument for another number of temperatures.
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

  MagnetDesign material_;
  magnetics::CylinderSize size_;
  double factor_;  // N
  magnetics::FaceValues face_factors_;
  std::size_t components_;
  std::vector<Inside> magnets_;
};

/// Remanence of each magnet at its temperature over that at 20 degC, base to tip; 1 if the design's magnets do not
/// weaken in the heat. `temperatures` has one value per component, degC.
[[nodiscard]] std::vector<double> magnet_strengths(const Design& design, std::span<const double> temperatures);

}  // namespace coilwright::actuator
