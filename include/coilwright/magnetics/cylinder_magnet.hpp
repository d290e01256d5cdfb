#pragma once

namespace coilwright::magnetics {

/// Permanent magnet, a full cylinder, magnetised along its axis. With recoil permeability 1 it is rigid and uniform: a
/// sheet of current remanence / mu0 (A/m) round its side. With more, the magnet's own field reduces its magnetisation,
/// most at its faces and edges; the result holds to first order in recoil_permeability - 1 (docs/theory/magnetics.md,
/// "Inner field and recoil"). Immutable; copies are cheap.
class CylinderMagnet {
 public:
  /// Largest recoil permeability accepted: the first order leaves 0.02 % of a force at 1.05, 0.3 % at 1.2.
  static constexpr double most_recoil_permeability = 1.2;

  /// Inputs of a CylinderMagnet. Name every field at the call site.
  struct Spec {
    double radius{};                 ///< m; finite, > 0
    double length{};                 ///< m, along the axis; finite, > 0
    double remanence{};              ///< Br, T, along +axis; finite, > 0 (turn the axis to turn the polarity)
    double recoil_permeability = 1;  ///< relative, of the line B(H) on which the magnet works; 1 to 1.2, NdFeB 1.05
  };
  /// Makes the magnet. Throws std::invalid_argument naming the field, the rule and the value received.
  explicit CylinderMagnet(const Spec& spec);

  [[nodiscard]] double radius() const noexcept { return spec_.radius; }                            ///< m
  [[nodiscard]] double length() const noexcept { return spec_.length; }                            ///< m
  [[nodiscard]] double remanence() const noexcept { return spec_.remanence; }                      ///< T
  [[nodiscard]] double recoil_permeability() const noexcept { return spec_.recoil_permeability; }  ///< relative
  /// The same magnet with recoil permeability 1.
  [[nodiscard]] CylinderMagnet without_recoil() const;

 private:
  Spec spec_;
};

}  // namespace coilwright::magnetics
