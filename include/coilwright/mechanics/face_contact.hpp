#pragma once

namespace coilwright::mechanics {

/// Two segment faces that meet when their joint closes: a unilateral rotary spring and damper.
///
/// The faces push and never pull. With the penetration p = closing_angle - theta > 0 the opening torque is max(0,
/// stiffness p - damping theta'), N m. The damper makes a bounce lossy without a separate law of restitution; the
/// torque jumps at first touch only if the faces meet at speed.
struct FaceContact {
  double closing_angle{};  ///< joint angle at which the faces meet, rad; <= 0 for faces that are apart at rest
  double stiffness{};      ///< N m/rad; >= 0, 0 for no contact
  double damping{};        ///< N m s/rad; >= 0

  /// Opening torque, N m, >= 0.
  [[nodiscard]] double torque(double angle, double rate) const noexcept {
    const double penetration = closing_angle - angle;
    if (penetration <= 0.0) return 0.0;
    const double push = stiffness * penetration - damping * rate;
    return push > 0.0 ? push : 0.0;
  }

  /// Negative slope of the torque by the angle, of the spring alone, N m/rad.
  [[nodiscard]] double tangent_stiffness(double angle) const noexcept {
    return angle < closing_angle ? stiffness : 0.0;
  }

  /// Energy in the spring, J.
  [[nodiscard]] double energy(double angle) const noexcept {
    const double penetration = closing_angle - angle;
    return penetration > 0.0 ? 0.5 * stiffness * penetration * penetration : 0.0;
  }
};

/// Damping of a contact over its critical damping: it rebounds with about 40 % of its speed, as silicone does that
/// bounces once and rests. Approximate; it decides how a joint rings at its stop, not where it stops.
inline constexpr double contact_damping_ratio = 0.3;

/// Damping of a contact of `stiffness` (N m/rad) at a joint of `mobility` (PlanarChain::joint_mobility(), 1/(kg m^2)),
/// N m s/rad.
[[nodiscard]] double contact_damping(double stiffness, double mobility);

/// Silicone walls pressed between two stiff faces that turn about a hinge at their lower edge.
struct FaceWalls {
  double width{};          ///< of the face, m
  double height{};         ///< from the hinge to the top edge, m
  double thickness{};      ///< of both walls together, m
  double young_modulus{};  ///< Pa
};

/// Rotary stiffness of the pressed walls, N m/rad: every strip at height y is a column strained by y theta / t, so k =
/// E w H^3 / (3 t). Bulging is free (no lateral confinement) and the strain is small; both err by tens of per cent. It
/// suffices that the wall is thousands of times stiffer than the hinge (prototype: 6e3).
[[nodiscard]] double wall_stiffness(const FaceWalls& walls);

}  // namespace coilwright::mechanics
