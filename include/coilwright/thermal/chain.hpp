#pragma once

#include <optional>
#include <vector>

#include "coilwright/thermal/network.hpp"

namespace coilwright::thermal {

/// A box of silicone around a round core: one segment of the actuator.
struct HeatSegment {
  NodeKind kind{};              ///< a coil or a magnet
  double core_length{};         ///< of the coil or magnet, m; finite, > 0
  double core_radius{};         ///< outer radius of the core, m; > 0, inside the body
  double bore_radius{};         ///< inner radius of the core, m; >= 0, below core_radius; 0 for a magnet
  double core_conductivity{};   ///< across the wires of a coil, or of a magnet, W/(m K); > 0
  double core_heat_capacity{};  ///< of the core with what fills its bore, J/K; > 0
  double wall{};                ///< silicone between the core and each face of the segment, m; > 0
  double solid_end{};           ///< silicone beyond the first or last segment (rear or front part), m; >= 0
  double resistance{};          ///< of the coil at 20 degC, ohm; 0 for a magnet
  double temperature_limit{};   ///< of the hottest place, degC
  double current_share = 1.0;   ///< of the coil in the actuator's current; finite
};

/// The bottom layer if it is of another silicone than the body.
struct BottomLayer {
  double conductivity{};   ///< W/(m K); > 0
  double heat_capacity{};  ///< per volume, J/(m3 K); > 0
};

/// An actuator as a thermal chain, with geometry and materials, from which build_network() makes a Network.
struct HeatChain {
  double width{};                       ///< of the cross-section, m
  double height{};                      ///< of the cross-section, m
  double hinge_layer{};                 ///< part of the height that joins two segments with an open joint, m; > 0
  double axis_offset{};                 ///< from the hinge axis to the cores' axis, m; above each core_radius
  double heat_transfer{};               ///< h of the outer surface: convection and radiation together, W/(m2 K); > 0
  double silicone_conductivity{};       ///< W/(m K); > 0
  double silicone_heat_capacity{};      ///< per volume, J/(m3 K); > 0
  std::optional<BottomLayer> bottom{};  ///< bottom layer of thickness hinge_layer; absent: as the rest
  double air_conductivity{0.03};        ///< W/(m K); > 0. Still air at 80 degC: 0.030 (CRC Handbook)
  double ambient{};                     ///< degC
  double temperature_coefficient{};     ///< alpha of the coils, 1/K; > 0
  std::vector<HeatSegment> segments;    ///< in order along the actuator; the first and the last may have a solid end
  std::vector<double> joint_angles;     ///< between neighbours, rad; >= 0, 0 closed; one less than segments
};

/// Index of the core of a segment among the nodes of `build_network`.
[[nodiscard]] constexpr std::size_t core_node(std::size_t segment) {
  return segment;
}
/// Index of the silicone around the core of a segment. Behind the segments follow the rear and the front solid end, if
/// they exist.
[[nodiscard]] constexpr std::size_t jacket_node(std::size_t segments, std::size_t segment) {
  return segments + segment;
}

/// Network of a chain: a node per core, one per silicone jacket around it, and one per solid end. Accuracy and limits:
/// docs/theory/thermal.md.
///
/// A core's heat goes through its winding (ring_conduction), then outwards to the surface, sector by sector through
/// silicone and film in series, and through its faces into the neighbours or a solid end (solid_end_node, with the
/// spreading from the core's disc over the section). An open joint loses heat from both its faces (open_face_share) and
/// conducts the rest across the air wedge. Throws std::invalid_argument naming the field, the rule and the value
/// received.
[[nodiscard]] Network build_network(const HeatChain& chain);

/// Temperature of the hottest place of the body's outer surface, degC, at `temperatures` of the nodes of
/// build_network(chain), degC: beside a core, where the silicone between it and the surface is thinnest. Heat is taken
/// to go straight through wall and film, from the core's surface at the mean of its nodes. By finite differences the
/// rise above ambient is therefore 0.5 % low for walls of 1 to 2 mm and 4 to 9 % low for walls of 7 mm. Faces inside a
/// slit and solid ends are not included. Throws as build_network, and std::invalid_argument for another number of
/// temperatures than of nodes.
[[nodiscard]] double skin_temperature(const HeatChain& chain, const NodeVector& temperatures);

/// Mean temperature of the surface by which heat leaves, degC, at `temperatures` of the nodes of build_network(chain),
/// degC: all heat over the film and the area, with faces in an open joint weighted by their view of the surroundings.
/// Throws as skin_temperature.
[[nodiscard]] double mean_surface_temperature(const HeatChain& chain, const NodeVector& temperatures);

/// The heat transfer coefficient, W/(m2 K), at which the hottest coil of `chain` is exactly at its temperature limit
/// under `continuous_current` (A, > 0; the same in every coil). `chain.heat_transfer` is not used.
///
/// Calibrate on the prototype, then use the coefficient for other geometries: it represents everything outside
/// (convection, radiation, wires, mounting) as a property of a surface. Throws std::invalid_argument with the current
/// that each end allows if no coefficient from 0.01 to 10,000 W/(m2 K) suffices (the conduction inside alone may be too
/// poor).
[[nodiscard]] double calibrate_heat_transfer(const HeatChain& chain, double continuous_current);

}  // namespace coilwright::thermal
