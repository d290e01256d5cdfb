#pragma once

namespace coilwright::thermal {

/// A winding as a ring that conducts equally radially and axially (both across the wires) and makes heat evenly.
struct Ring {
  double inner_radius{};  ///< m; >= 0
  double outer_radius{};  ///< m; > inner_radius
  double length{};        ///< m; > 0
  double conductivity{};  ///< across the wires, W/(m K); > 0
};

/// Conduction of heat out of a ring, by its mean temperature.
struct RingConduction {
  double to_side{};           ///< from the mean to the outer surface, W/K
  double to_end{};            ///< from the mean to each end face, W/K
  double hot_spot_by_side{};  ///< hottest place above the mean, per heat, if all of it leaves at the side, K/W
  double hot_spot_by_ends{};  ///< hottest place above the mean, per heat, if all of it leaves at the ends, K/W
};

/// Computes the conduction from one-dimensional profiles of even heat: radial with an insulating bore, axial between
/// equal ends; both together as in the general cylinder of Mellor, Roberts and Turner, IEE Proceedings B 138 (1991)
/// 205.
[[nodiscard]] RingConduction ring_conduction(const Ring& ring);

/// Conductivity across the wires of a bundle, W/(m K): matrix (1 + f) / (1 - f), the lower bound of Hashin and
/// Shtrikman for cylinders that conduct far better than the matrix between them (Simpson, Wrobel and Mellor, IEEE
/// Transactions on Industry Applications 49 (2013) 2505, compare it with measured windings). `copper_share` of the
/// section, 0 to below 1; `filler` conductivity, W/(m K), > 0. Throws std::invalid_argument naming the value that is
/// outside.
[[nodiscard]] double across_wires(double copper_share, double filler);

/// A bar of silicone with convection all around, warm at its root.
struct SolidEnd {
  double length{};         ///< m; > 0
  double section{};        ///< m2; > 0
  double perimeter{};      ///< m; > 0
  double conductivity{};   ///< W/(m K); > 0
  double heat_capacity{};  ///< per volume, J/(m3 K); > 0
  double heat_transfer{};  ///< W/(m2 K); > 0
};

/// One node that represents a bar.
struct SolidEndNode {
  double to_root{};        ///< W/K
  double to_ambient{};     ///< W/K
  double heat_capacity{};  ///< J/K
};

/// The node whose admittance at the root agrees with the bar's, a fin with convection from its end face (Incropera and
/// DeWitt, table 3.4, case A, with time as the Laplace variable), at zero frequency with its first and second
/// derivative: exact in steady state, and right to second order for slow changes. For a long bar to_root is three times
/// the fin's conductance and the capacity that of 1.125 decay lengths.
[[nodiscard]] SolidEndNode solid_end_node(const SolidEnd& bar);

/// Share of the heat exchange of a free face that remains for one of the two faces of a joint open by `angle` (rad, 0
/// to pi): the view factor from a face to outside of the wedge. `height` of the face over its width, > 0. Exact for a
/// wide wedge, sin(angle/2) (Hottel); both open sides add (1 - sin(angle/2)) s / (1 + s), s = 0.4 height/width
/// sin(angle), within 0.02 of the view factor of finite plates (Feingold, Proc. Royal Society A 292 (1966) 51) for
/// heights of 0.5 to 2 widths and angles up to 120 degrees. The same share is taken for convection, whose channel is
/// free at such angles (Elenbaas): on the safe side.
[[nodiscard]] double open_face_share(double angle, double height_over_width);

/// A surface in still air.
struct StillAir {
  double height{};               ///< of the surface, m; > 0
  double ambient{};              ///< degC
  double surface_temperature{};  ///< degC; not below ambient
};

/// Heat transfer coefficient of a vertical surface in still air, W/(m2 K): natural convection by Churchill and Chu
/// (1975; Incropera and DeWitt, equation 9.27, laminar) with air at the mean temperature (table A.4 as powers of
/// absolute temperature, 1 % from 250 to 450 K), and radiation of an emissivity of 0.9 to surroundings at ambient
/// temperature. Throws std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] double still_air_film(const StillAir& place);

/// A gap that opens as a wedge when a joint bends.
struct Wedge {
  double angle{};           ///< between the faces, rad; >= 0
  double hinge_distance{};  ///< from the hinge axis to the cores' axis, m; > core_radius
  double core_radius{};     ///< of the faces that exchange heat, m; > 0
};

/// Thickness of the flat air gap that conducts as much heat as a wedge, m; 0 for a closed joint.
///
/// Heat crosses the wedge along arcs of length r angle about the hinge, so the thickness is angle over the mean of 1/r
/// across the disc: angle h rho^2 / (2 (1 - sqrt(1 - rho^2))), rho = core_radius / hinge_distance. Conduction only.
/// Throws std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] double equivalent_air_gap(const Wedge& wedge);

}  // namespace coilwright::thermal
