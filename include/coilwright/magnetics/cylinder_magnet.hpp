#pragma once

namespace coilwright::magnetics {

/// Permanent magnet, a full cylinder, rigidly and uniformly magnetised along its axis (recoil permeability 1).
/// Equivalent to a sheet of current remanence / mu0 (A/m) round its side. Immutable; copies are cheap.
class CylinderMagnet {
 public:
  /// Inputs of a CylinderMagnet. Name every field at the call site.
  struct Spec {
    double radius{};     ///< m; finite, > 0
    double length{};     ///< m, along the axis; finite, > 0
    double remanence{};  ///< T, magnetic polarisation J along +axis; finite, > 0 (turn the axis to turn the polarity)
  };
  /// Throws std::invalid_argument naming the field, the rule and the value received.
  explicit CylinderMagnet(const Spec& spec);

  [[nodiscard]] double radius() const noexcept { return spec_.radius; }        ///< m
  [[nodiscard]] double length() const noexcept { return spec_.length; }        ///< m
  [[nodiscard]] double remanence() const noexcept { return spec_.remanence; }  ///< T

 private:
  Spec spec_;
};

}  // namespace coilwright::magnetics
