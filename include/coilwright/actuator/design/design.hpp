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
#include "coilwright/magnetics/irreversible_loss.hpp"
#include "coilwright/magnetics/magnet_grade.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/mechanics/silicone_grade.hpp"
#include "coilwright/winding/wire.hpp"

namespace coilwright::actuator {

/// The decisions of the person who builds the actuator, and the conventions by which it is modelled. All values are
/// plain numbers in SI. Any combination may be written down; `assemble` checks whether it can be built.

/// Number of coils, from the base, whose currents may be set separately: as many as configuration D has. Further coils
/// carry the whole current.
inline constexpr int most_current_shares = 4;

/// The material between the turns of a coil.
enum class Filler {
  unstated,  ///< the prototype's convention: silicone in heat, no mass
  silicone,  ///< potted: silicone in heat and mass
  air        ///< dry: air in heat and mass
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
  /// Share of the operating current that each coil carries, -1 to 1. A share other than 1 needs a driver of its own.
  std::array<double, most_current_shares> current_shares{1.0, 1.0, 1.0, 1.0};
};

/// Every magnet of the actuator.
struct MagnetDesign {
  double radius = 10e-3;            ///< m
  double length = 6e-3;             ///< along the axis, m
  double remanence = 1.44;          ///< T; N52: 1.43 to 1.48 (makers' tables)
  double density = 7500.0;          ///< kg/m^3, sintered NdFeB
  double temperature_limit = 80.0;  ///< degC; grades without a letter
  /// The grade, a row of magnetics::magnet_grades(), or nullptr if it is unknown: it names the price, and brings what
  /// follows. Without it, and where nothing is stated, the magnet has no recoil, does not weaken in the heat, and has
  /// no demagnetisation margin. @{
  const magnetics::MagnetGrade* grade = nullptr;
  double coercivity = 0.0;              ///< HcJ at 20 degC, A/m; 0: unknown
  double remanence_coefficient = 0.0;   ///< of Br, from 20 degC, 1/K; sintered NdFeB has -0.0009 to -0.0013
  double coercivity_coefficient = 0.0;  ///< of HcJ, from 20 degC, 1/K; 0: unknown
  double recoil_permeability = 1.0;     ///< relative, of the line on which the magnet works; 1 to 1.2
  double squareness = magnetics::typical_squareness;  ///< of magnetics::DemagnetisationCurve; 0.6 to 0.99
  ///@}

  /// Takes over all numbers of a grade, with its typical remanence; nullptr keeps remanence, density and temperature
  /// limit, and forgets what is unknown without a grade. Set measured values afterwards.
  void make_of(const magnetics::MagnetGrade* material);
  /// Whether HcJ is known at every temperature, so that the magnet has a demagnetisation margin.
  [[nodiscard]] bool has_coercivity() const noexcept { return coercivity > 0.0 && coercivity_coefficient != 0.0; }
  /// Mean polarisation in the magnet's own field at 20 degC, T: the remanence less the loss by recoil.
  [[nodiscard]] double polarisation() const;
  /// The magnet as the force formulas take it, at 20 degC.
  [[nodiscard]] magnetics::CylinderMagnet cylinder() const;
};

/// A silicone. One of three numbers gives its stiffness: the first that is not 0.
struct SiliconeDesign {
  double young_modulus = 0.0;      ///< Pa; 0: by a hardness
  double shore_hardness_00 = 0.0;  ///< Shore 00, 10 to 70; 0: by Shore A
  double shore_hardness = 28.0;    ///< Shore A, 20 to 80 (Elastosil M 4601: 28)
  double density = 1130.0;         ///< kg/m^3
  double heat_capacity = 1300.0;   ///< J/(kg K), silicone rubber: 1050 to 1300 (makers' tables)
  double conductivity = 0.2;       ///< W/(m K), unfilled silicone rubber
  /// The product, a row of mechanics::silicone_grades(), or nullptr if it is unknown.
  const mechanics::SiliconeGrade* grade = nullptr;

  /// Takes over modulus and density of a grade; nullptr changes no number. Set measured values afterwards.
  void make_of(const mechanics::SiliconeGrade* material);
  /// Young's modulus at small strains, Pa. Throws std::invalid_argument for a hardness outside its range.
  [[nodiscard]] double modulus() const;
  /// The name under which a person orders it: "Ecoflex 00-30", "Shore 28A", "0.25 MPa".
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
  /// Part of a joint's damping that does not follow its hinge (wires, faces that rub at the cut), N m s/rad, in a body
  /// 22 mm wide. It is the rest of the prototype's 0.129 N mm s/rad beside a loss factor of 0.15. It scales with the
  /// cube of the width.
  double constant_damping = 0.0692e-3;
};

/// The place at which segments meet when a joint closes.
enum class ContactChoice {
  /// Only the stiff parts stop a joint, as if no silicone were between them: coil and magnet touch at their top. The
  /// paper's model has no contact; in its range the result is the same, and the joint cannot run away at negative
  /// current.
  hard_parts,
  /// The silicone walls touch at angle 0 and push back with their own stiffness from there. With the prototype's 79 N
  /// m/rad two magnets of configuration C close them by 0.07 degrees.
  walls
};

/// The law by which the bottom layer becomes a rotary spring.
enum class HingeLaw {
  slit,  ///< a cut without width: k goes with h_b squared; the paper cuts its cast body by hand
  slot,  ///< a cut of BodyDesign::slot_width
  beam   ///< a strip of BodyDesign::hinge_length that was cast as such: h_b cubed. Files of version 0.1 mean this
};

/// The law by which the silicone's part of a joint's damping follows its hinge; the rest is
/// BodyDesign::constant_damping.
enum class DampingLaw {
  loss_factor,  ///< b = loss_factor k / omega, omega of the finger's first mode: the same loss in each cycle
  proportional  ///< b = loss_time k
};

/// The mass model of the segments.
enum class SegmentMass {
  on_axis_points,  ///< point masses on the coil axis, no inertia of their own: the paper's (1)-(3)
  rigid_bodies     ///< centre of mass and inertia of the boxes and cylinders they consist of
};

/// Which chassis-wiring current a gauge has.
enum class AmpacityChoice {
  law,   ///< winding::Wire::smooth_ampacity: no gauge is better than its neighbours
  table  ///< the table's own, rounded values
};

/// The mechanism that carries heat away from the surface.
enum class FilmChoice {
  calibrated,  ///< Surroundings::heat_transfer with its calibration
  still_air    ///< natural convection and radiation: still_air_film()
};

/// Conventions of the model. Each is worth a few per cent or more, so results can be compared only together with them.
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

/// The conditions in which the actuator works.
struct Surroundings {
  double gravity = 9.81;      ///< m/s^2
  double base_tilt = 0.0;     ///< rad, towards opening; 0: the finger hangs
  double ambient = 25.0;      ///< degC
  double coil_limit = 155.0;  ///< degC, of the enamel
  /// Heat transfer of the outer surface, convection and radiation together, W/(m^2 K); calibrated on the prototype.
  double heat_transfer = 155.8;
};

/// The joint on which stiffness and damping were measured, with its geometry. Another law of the hinge or of damping
/// passes through it: see with_hinge_law(), with_damping().
struct HingeReference {
  double width{};         ///< of the cross-section, m
  double bottom_layer{};  ///< h_b, m
  double stiffness{};     ///< k, N m/rad
  double damping{};       ///< b, N m s/rad
  double first_mode{};    ///< of its finger, Hz: see first_mode_frequency()
};

/// Factors measured over derived of a built actuator; 1 for whatever was not measured. The factors stay with the design
/// when its variables move.
struct Calibration {
  double axial_pitch = 1.0;          ///< of turns in a layer
  double radial_pitch = 1.0;         ///< of layers
  double joint_stiffness = 1.0;      ///< k
  double joint_damping = 1.0;        ///< the silicone's part of b
  double constant_damping = 1.0;     ///< the constant part of b; >= 0
  double axis_offset = 1.0;          ///< h
  double magnet_segment_mass = 1.0;  ///< m_1
  double coil_segment_mass = 1.0;    ///< m_2, including the front part if it is the last
  double tip_com = 1.0;              ///< l_2
  double coil_resistance = 1.0;
  double heat_transfer = 1.0;  ///< surface heat transfer coefficient, on the prototype's
  /// The joint on which stiffness and damping were measured. Absent if nothing was measured, and in files of version
  /// 0.1.
  std::optional<HingeReference> hinge{};
};

/// A whole actuator: parts, body, surroundings and conventions.
struct Design {
  Layout layout = layout_of(Configuration::B);
  CoilDesign coil{};
  MagnetDesign magnet{};
  BodyDesign body{};
  /// The silicone of the bottom layer, which is the hinge, if it differs from that of the body above it.
  std::optional<SiliconeDesign> bottom_silicone{};
  Surroundings surroundings{};
  ModelChoices choices{};
  Calibration calibration{};
  std::vector<Effect> effects{};  ///< effects beside the model's stages; each kind at most once
  AsBuilt as_built{};             ///< differences between the built actuator and its numbers
  /// Error of the curves of torques and forces, relative to the largest value of each; > 0. Files do not set it. The
  /// default is two orders below the 1e-5 to which a coil is wound.
  double curve_tolerance = 1e-6;
};

/// The wire of the coils. Throws std::invalid_argument for a gauge or a diameter that does not exist.
[[nodiscard]] winding::Wire wire_of(const CoilDesign& coil);

/// Section of all turns of a coil over their enamel, m2. Throws as wire_of().
[[nodiscard]] double wires_section(const CoilDesign& coil);

/// The silicone that bends: that of the bottom layer.
[[nodiscard]] const SiliconeDesign& hinge_silicone(const Design& design);

}  // namespace coilwright::actuator
