#pragma once

namespace coilwright::mechanics {

/// A thin strip of silicone that joins two segments.
struct HingeStrip {
  double width{};   ///< across the finger, m; > 0
  double height{};  ///< thickness of the bottom layer h_b, m; > 0
  double length{};  ///< length that bends, along the finger, m; > 0
};

/// Young's modulus of a rubber of Shore A hardness, Pa, for 20 <= shore_a <= 80. Source: A. N. Gent, Rubber Chem.
/// Technol. 31 (1958) 896. For castable silicones it is 29 % below to 27 % above the moduli by their makers' stress at
/// 100 %, and above those by tensile tests: 1.6 times that of a Yeoh law for Elastosil M 4601 (28A), 1.9 times that of
/// Dragon Skin 20, 2.0 times that of Dragon Skin 30 (silicone_grade.hpp). Throws std::invalid_argument outside that
/// range.
[[nodiscard]] double young_modulus_from_shore_a(double shore_a);

/// Young's modulus of a rubber of Shore 00 hardness, Pa, for 10 <= shore_00 <= 70: 9 F / (16 sqrt(R) delta^1.5), for a
/// sphere of R = 1.19 mm pressed by F = 0.203 N + 9.08 mN per point into an incompressible half-space by 25.4 um per
/// point below 100. Source: geometry and spring of ASTM D2240, type OO, with Hertz's contact, as Gent used it for Shore
/// A. Below 50 the sphere sinks in further than its radius, and Hertz no longer holds strictly: in the Ecoflex series,
/// moduli by the maker's stress at 100 % are 0.6 (00-50) to 2.2 (00-10) times this. Throws std::invalid_argument
/// outside that range.
[[nodiscard]] double young_modulus_from_shore_00(double shore_00);

/// An elastic, isotropic rubber under small strains.
struct Rubber {
  double young_modulus{};  ///< E, Pa; > 0
  double poisson_ratio{};  ///< nu; 0 to 0.5
  /// Young's modulus of the body above the ligament over that of the ligament, if they are two rubbers; > 0.
  double modulus_above = 1.0;
};

/// The ligament that remains where a cut from above divides a body into two segments, which turn about it.
struct Ligament {
  double width{};       ///< across the finger, m; > 0
  double height{};      ///< thickness of the bottom layer h_b, m; > 0
  double slot_width{};  ///< of the cut, along the finger, m; 0 for a slit made with a blade
};

/// Bending stiffness of a ligament as one rotary joint, N m/rad: E' w h^2 / c with E' = E / (1 - nu^2).
///
/// A slit has no length of its own, only h, so k goes with its square: c = 15.8, the rotation of an edge crack in
/// bending whose ligament is small (Tada, Paris, Irwin, The Stress Analysis of Cracks Handbook: 24 times the limit 0.66
/// of its function for the single edge notch in pure bending). A slot of width s adds a beam of that length, less the
/// part that its ends already give: c = 15.8 + 12 s/h - 0.503 (1 - exp(-s / (0.22 h))), fitted to plane-strain finite
/// elements within 0.1 % from s/h = 0 to 4 (tests/mechanics/plane_strain_test.cpp). If the body above is of a rubber of
/// r times the modulus, it takes part in the bending, and the slit's 15.8 becomes 8.77 + 7.03 r^-0.542: within 2 % of
/// the elements from r = 0.1 to 100; with a slot of a third of h within 4 % up to r = 10, and 9 % stiff at 100.
///
/// It holds for bodies that are high beside the ligament and otherwise homogeneous: the finite elements are 1 % stiffer
/// at h = 1.5 mm, 2 % at 2.5 and 6 % at 4 mm in the prototype's body of 24 mm with faces kept plane 6.3 mm from the
/// cut. Stiff cores 0.3 mm from the cut add 21, 28 and 38 % there, and more for a softer body above: 97 % at r = 0.1
/// and 2.5 mm, 5 % at r = 10. Throws std::invalid_argument naming field, rule and value.
[[nodiscard]] double ligament_stiffness(const Ligament& ligament, const Rubber& rubber);

/// Bending stiffness E w h^3 / (12 L) of the strip as one rotary joint, N m/rad: a beam of constant curvature. It holds
/// for a strip that was cast as such, with L > 3 h or so. A slit has no such length: with the L that meets the
/// prototype at h = 2.5 mm the law is 38 % too soft at 1.5 mm and 57 % too stiff at 4 mm. Throws std::invalid_argument
/// naming field, rule and value.
[[nodiscard]] double hinge_stiffness(const HingeStrip& strip, double young_modulus);

}  // namespace coilwright::mechanics
