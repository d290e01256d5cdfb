#pragma once

#include <vector>

#include "coilwright/actuator/design/layout.hpp"
#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::actuator {

/// What a person who builds the actuator decides, plus the conventions by which it is modelled. Plain values, SI: any
/// mix may be written down; whether it can be built is for `assemble` to say.

/// Every coil of the actuator.
struct CoilDesign {
  double inner_radius = 3e-3;  ///< of the bore, m
  int turns_radial = 15;       ///< layers
  int turns_axial = 30;        ///< turns in a layer
  int wire_gauge = 28;         ///< AWG, 20 to 40
};

/// Every magnet of the actuator.
struct MagnetDesign {
  double radius = 10e-3;            ///< m
  double length = 6e-3;             ///< along the axis, m
  double remanence = 1.44;          ///< T; N52: 1.43 to 1.48 (makers' tables)
  double density = 7500.0;          ///< kg/m^3, sintered NdFeB
  double temperature_limit = 80.0;  ///< degC; grades without a letter
};

/// The silicone body around the parts. Cross-section and hinge line follow from it: see Dimensions.
struct BodyDesign {
  double gap = 0.9e-3;            ///< coil face to magnet face at angle 0, m: two silicone walls (the paper's d_0)
  double bottom_layer = 2.5e-3;   ///< h_b, m: the hinge strip
  double side_wall = 1.0e-3;      ///< left and right of the widest part, m
  double bottom_wall = 0.25e-3;   ///< between the widest part and the bottom layer, m
  double top_wall = 1.25e-3;      ///< above the widest part, m
  double front_length = 8.6e-3;   ///< silicone beyond the last component, m
  double rear_length = 20e-3;     ///< silicone behind the first component, held by the base, m
  double hinge_length = 2.4e-3;   ///< length of the bottom layer that bends, m; calibrated on the prototype
  double shore_hardness = 28.0;   ///< Shore A, 20 to 80 (Elastosil M 4601: 28)
  double loss_time = 10.3e-3;     ///< damping over stiffness of a hinge, s; calibrated on the prototype
  double density = 1130.0;        ///< kg/m^3
  double heat_capacity = 1300.0;  ///< J/(kg K), silicone rubber: 1050 to 1300 (makers' tables)
  double conductivity = 0.2;      ///< W/(m K), unfilled silicone rubber
};

/// Where segments are allowed to meet when a joint closes.
enum class ContactChoice {
  /// Only the stiff parts stop a joint: the silicone walls give way until coil and magnet touch at their top. The
  /// paper's
  /// model has no contact at all; in its range this is the same, and it cannot run away at negative current.
  hard_parts,
  /// The silicone walls are cut to touch at angle 0 and push back with their own stiffness from there.
  walls
};

/// How segments carry their mass.
enum class SegmentMass {
  on_axis_points,  ///< point masses on the coil axis, no inertia of their own: the paper's (1)-(3)
  rigid_bodies     ///< centre of mass and inertia of the boxes and cylinders they consist of
};

/// Conventions of the model, each worth a few per cent or more: a result without them cannot be compared.
struct ModelChoices {
  magnetics::CurrentDistribution winding = magnetics::CurrentDistribution::uniform;
  magnetics::Fidelity torque = magnetics::Fidelity::exact;
  ContactChoice faces = ContactChoice::hard_parts;
  SegmentMass masses = SegmentMass::rigid_bodies;
};

/// Where it works.
struct Surroundings {
  double gravity = 9.81;      ///< m/s^2
  double base_tilt = 0.0;     ///< rad, towards opening; 0: the finger hangs
  double ambient = 25.0;      ///< degC
  double coil_limit = 155.0;  ///< degC, of the enamel
  /// From the outer surface, convection and radiation together, W/(m^2 K); calibrated on the prototype.
  double heat_transfer = 51.5;
};

/// Measured over derived, for what was measured on a built actuator; 1 where nothing was. The factors stay with the
/// design when its variables move.
struct Calibration {
  double axial_pitch = 1.0;          ///< of turns in a layer
  double radial_pitch = 1.0;         ///< of layers
  double joint_stiffness = 1.0;      ///< k
  double joint_damping = 1.0;        ///< b
  double axis_offset = 1.0;          ///< h
  double magnet_segment_mass = 1.0;  ///< m_1
  double coil_segment_mass = 1.0;    ///< m_2, with a front part where it is the last
  double tip_com = 1.0;              ///< l_2
  double coil_resistance = 1.0;
  double heat_transfer = 1.0;  ///< surface heat transfer coefficient, on the prototype's
};

/// A whole actuator.
struct Design {
  Layout layout = layout_of(Configuration::B);
  CoilDesign coil{};
  MagnetDesign magnet{};
  BodyDesign body{};
  Surroundings surroundings{};
  ModelChoices choices{};
  Calibration calibration{};
  std::vector<Effect> effects{};  ///< that the model has beside its stages; each kind at most once
};

}  // namespace coilwright::actuator
