#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/actuator/design/layout.hpp"
#include "coilwright/actuator/model/as_built.hpp"
#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/magnet_grade.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/mechanics/silicone_grade.hpp"
#include "coilwright/winding/wire.hpp"

namespace coilwright::actuator {

/// What a person who builds the actuator decides, plus the conventions by which it is modelled. Plain values, SI: any
/// mix may be written down; whether it can be built is for `assemble` to say.

/// The coils, base to tip, whose currents may be set apart: as many as configuration D has. Further ones carry the
/// whole.
inline constexpr int most_current_shares = 4;

/// What is between the turns of a coil.
enum class Filler {
  unstated,  ///< the prototype's convention: heat passes as through silicone, and nothing weighs there
  silicone,  ///< potted: both
  air        ///< dry: neither
};

/// Every coil of the actuator.
struct CoilDesign {
  double inner_radius = 3e-3;  ///< of the bore, m
  int turns_radial = 15;       ///< layers
  int turns_axial = 30;        ///< turns in a layer
  int wire_gauge = 28;         ///< AWG, 10 to 50: names the wire where `wire_diameter` is 0
  double wire_diameter = 0.0;  ///< bare, m; 0: that of the gauge
  winding::Enamel enamel = winding::Enamel::grade_1;
  double wire_overall = 0.0;  ///< largest diameter over the enamel, m; 0: by its grade
  Filler filler = Filler::unstated;
  /// What each coil carries of the operating current, -1 to 1; other than 1 it needs a driver of its own.
  std::array<double, most_current_shares> current_shares{1.0, 1.0, 1.0, 1.0};
};

/// Every magnet of the actuator.
struct MagnetDesign {
  double radius = 10e-3;            ///< m
  double length = 6e-3;             ///< along the axis, m
  double remanence = 1.44;          ///< T; N52: 1.43 to 1.48 (makers' tables)
  double density = 7500.0;          ///< kg/m^3, sintered NdFeB
  double temperature_limit = 80.0;  ///< degC; grades without a letter
  /// What it is made of, a row of magnetics::magnet_grades(). nullptr: not known; then it has no recoil, does not
  /// weaken in the heat, and nobody can say when it is demagnetised.
  const magnetics::MagnetGrade* grade = nullptr;

  /// Makes it of a grade (or of nullptr, which changes no number): remanence (typical), density and temperature limit
  /// become the grade's. Set afterwards what was measured.
  void make_of(const magnetics::MagnetGrade* material);
  /// Mean polarisation in its own field at 20 degC, T: the remanence, less what recoil gives up.
  [[nodiscard]] double polarisation() const;
  /// What the forces act on, at 20 degC.
  [[nodiscard]] magnetics::CylinderMagnet cylinder() const;
};

/// A silicone. Its stiffness is named by one of three numbers: the first that is not 0 counts.
struct SiliconeDesign {
  double young_modulus = 0.0;      ///< Pa; 0: by a hardness
  double shore_hardness_00 = 0.0;  ///< Shore 00, 10 to 70; 0: by Shore A
  double shore_hardness = 28.0;    ///< Shore A, 20 to 80 (Elastosil M 4601: 28)
  double density = 1130.0;         ///< kg/m^3
  double heat_capacity = 1300.0;   ///< J/(kg K), silicone rubber: 1050 to 1300 (makers' tables)
  double conductivity = 0.2;       ///< W/(m K), unfilled silicone rubber
  /// What it is sold as, a row of mechanics::silicone_grades(); nullptr: not known.
  const mechanics::SiliconeGrade* grade = nullptr;

  /// Makes it of a grade (or of nullptr, which changes no number): modulus and density become the grade's. Set
  /// afterwards what was measured.
  void make_of(const mechanics::SiliconeGrade* material);
  /// Young's modulus at small strains, Pa. Throws std::invalid_argument for a hardness outside its range.
  [[nodiscard]] double modulus() const;
  /// As a person orders it: "Ecoflex 00-30", "Shore 28A", "0.25 MPa".
  [[nodiscard]] std::string name() const;
};

/// The silicone body around the parts. Cross-section and hinge line follow from it: see Dimensions.
struct BodyDesign : SiliconeDesign {
  double gap = 0.9e-3;           ///< coil face to magnet face at angle 0, m: two silicone walls (the paper's d_0)
  double bottom_layer = 2.5e-3;  ///< h_b, m: the hinge strip
  double side_wall = 1.0e-3;     ///< left and right of the widest part, m
  double bottom_wall = 0.25e-3;  ///< between the widest part and the bottom layer, m
  double top_wall = 1.25e-3;     ///< above the widest part, m
  double front_length = 8.6e-3;  ///< silicone beyond the last component, m
  double rear_length = 20e-3;    ///< silicone behind the first component, held by the base, m
  double slot_width = 0.9e-3;    ///< of the cut between two segments, along the finger, m; HingeLaw::slot alone
  double hinge_length = 2.4e-3;  ///< length of the bottom layer that bends, m; HingeLaw::beam alone
  double poisson_ratio = 0.5;    ///< 0 to 0.5; silicone's bulk modulus is a thousand times its E: 0.4998 and more
  double loss_factor = 0.15;     ///< of the silicone at the finger's first mode; DampingLaw::loss_factor alone
  double loss_time = 4.8e-3;     ///< damping over stiffness of the silicone, s; DampingLaw::proportional alone
  /// Damping of a joint that does not follow its hinge (wires, faces that rub at the cut), N m s/rad, in a body 22 mm
  /// wide; what the prototype's 0.129 N mm s/rad leave beside 0.15. In another it goes with the cube of the width.
  double constant_damping = 0.0692e-3;
};

/// Where segments are allowed to meet when a joint closes.
enum class ContactChoice {
  /// Only the stiff parts stop a joint, as if there were no silicone before them: coil and magnet touch at their top.
  /// The paper's model has no contact at all; in its range this is the same, and it cannot run away at negative
  /// current.
  hard_parts,
  /// The silicone walls are cut to touch at angle 0 and push back with their own stiffness from there. The prototype's
  /// 79 N m/rad let two magnets of configuration C close them by 0.07 degrees.
  walls
};

/// How the bottom layer turns into a rotary spring.
enum class HingeLaw {
  slit,  ///< what a cut without width leaves: k goes with h_b squared; the paper divides its cast body by hand
  slot,  ///< the same beside a cut of BodyDesign::slot_width
  beam   ///< a strip of BodyDesign::hinge_length that was cast as such: h_b cubed. Files of 0.1 mean this
};

/// How the silicone's part of a joint's damping follows its hinge; the rest is BodyDesign::constant_damping.
enum class DampingLaw {
  loss_factor,  ///< b = loss_factor k / omega, omega of the finger's first mode: the same loss a cycle
  proportional  ///< b = loss_time k
};

/// How segments carry their mass.
enum class SegmentMass {
  on_axis_points,  ///< point masses on the coil axis, no inertia of their own: the paper's (1)-(3)
  rigid_bodies     ///< centre of mass and inertia of the boxes and cylinders they consist of
};

/// Which chassis-wiring current a gauge has.
enum class AmpacityChoice {
  law,   ///< winding::Wire::smooth_ampacity: no gauge is better than its neighbours
  table  ///< the table's own, rounded values
};

/// What carries heat away from the surface.
enum class FilmChoice {
  calibrated,  ///< Surroundings::heat_transfer with its calibration
  still_air    ///< natural convection and radiation by themselves: still_air_film()
};

/// Conventions of the model, each worth a few per cent or more: a result without them cannot be compared.
struct ModelChoices {
  magnetics::CurrentDistribution winding = magnetics::CurrentDistribution::uniform;
  magnetics::Fidelity torque = magnetics::Fidelity::exact;
  ContactChoice faces = ContactChoice::walls;
  SegmentMass masses = SegmentMass::rigid_bodies;
  HingeLaw hinge = HingeLaw::slit;
  DampingLaw damping = DampingLaw::loss_factor;
  AmpacityChoice ampacity = AmpacityChoice::law;
  FilmChoice film = FilmChoice::calibrated;
};

/// Where it works.
struct Surroundings {
  double gravity = 9.81;      ///< m/s^2
  double base_tilt = 0.0;     ///< rad, towards opening; 0: the finger hangs
  double ambient = 25.0;      ///< degC
  double coil_limit = 155.0;  ///< degC, of the enamel
  /// From the outer surface, convection and radiation together, W/(m^2 K); calibrated on the prototype.
  double heat_transfer = 155.8;
};

/// The joint on which k and b were measured, all measured or derived there. Another law of the hinge or of damping
/// passes through it: see with_hinge_law(), with_damping().
struct HingeReference {
  double width{};         ///< of the cross-section, m
  double bottom_layer{};  ///< h_b, m
  double stiffness{};     ///< k, N m/rad
  double damping{};       ///< b, N m s/rad
  double first_mode{};    ///< of its finger, Hz: see first_mode_frequency()
};

/// Measured over derived, for what was measured on a built actuator; 1 where nothing was. The factors stay with the
/// design when its variables move.
struct Calibration {
  double axial_pitch = 1.0;          ///< of turns in a layer
  double radial_pitch = 1.0;         ///< of layers
  double joint_stiffness = 1.0;      ///< k
  double joint_damping = 1.0;        ///< the silicone's part of b
  double constant_damping = 1.0;     ///< the rest of b; >= 0
  double axis_offset = 1.0;          ///< h
  double magnet_segment_mass = 1.0;  ///< m_1
  double coil_segment_mass = 1.0;    ///< m_2, with a front part where it is the last
  double tip_com = 1.0;              ///< l_2
  double coil_resistance = 1.0;
  double heat_transfer = 1.0;  ///< surface heat transfer coefficient, on the prototype's
  /// Where k and b were measured; nothing where nothing was, and in files of 0.1.
  std::optional<HingeReference> hinge{};
};

/// A whole actuator.
struct Design {
  Layout layout = layout_of(Configuration::B);
  CoilDesign coil{};
  MagnetDesign magnet{};
  BodyDesign body{};
  /// Of the bottom layer, the hinge, where that is cast of another silicone than the body above it.
  std::optional<SiliconeDesign> bottom_silicone{};
  Surroundings surroundings{};
  ModelChoices choices{};
  Calibration calibration{};
  std::vector<Effect> effects{};  ///< that the model has beside its stages; each kind at most once
  AsBuilt as_built{};             ///< how the one that was built differs from its numbers
  /// To which its torques and forces are made curves, of the largest value of each. No file says it: by default two
  /// orders below the 1e-5 to which a coil is wound.
  double curve_tolerance = 1e-6;
};

/// The wire of the coils. Throws std::invalid_argument for a gauge or a diameter that there is not.
[[nodiscard]] winding::Wire wire_of(const CoilDesign& coil);

/// Section of all turns of a coil over their enamel, m2. Throws as wire_of().
[[nodiscard]] double wires_section(const CoilDesign& coil);

/// The silicone that bends: that of the bottom layer.
[[nodiscard]] const SiliconeDesign& hinge_silicone(const Design& design);

}  // namespace coilwright::actuator
