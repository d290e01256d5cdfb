#pragma once

#include <vector>

#include "coilwright/thermal/network.hpp"

namespace coilwright::thermal {

/// A box of silicone around a round core: one segment of the actuator.
struct HeatSegment {
  NodeKind kind{};
  double length{};             ///< along the actuator, silicone walls included, m; finite, > 0
  double core_radius{};        ///< of the coil or magnet, m; > 0, inside the body
  double solid_end{};          ///< silicone that continues beyond the segment (front or rear part), m; >= 0
  double resistance{};         ///< of the coil at 20 degC, ohm; 0 for a magnet
  double heat_capacity{};      ///< of everything in the segment, J/K; > 0
  double temperature_limit{};  ///< degC
};

/// What lies between the cores of two neighbouring segments, in series.
struct Gap {
  double silicone{};  ///< thickness of both walls, m; finite, >= 0
  double air{};       ///< mean thickness of the open wedge between the faces, m; 0 where they touch. With silicone: > 0
};

/// An actuator as a thermal chain: geometry and materials in, Network out.
struct HeatChain {
  double width{};                     ///< of the cross-section, m
  double height{};                    ///< of the cross-section, m
  double heat_transfer{};             ///< h of the outer surface: convection and radiation together, W/(m2 K); > 0
  double silicone_conductivity{};     ///< W/(m K); > 0
  double air_conductivity{0.03};      ///< W/(m K); > 0. Still air at 80 degC: 0.030 (CRC Handbook)
  double ambient{};                   ///< degC
  double temperature_coefficient{};   ///< alpha of the coils, 1/K; > 0
  std::vector<HeatSegment> segments;  ///< in order along the actuator
  std::vector<Gap> gaps;              ///< between neighbours; one less than segments
};

/// A gap that opens as a wedge when a joint bends.
struct Wedge {
  double angle{};           ///< between the faces, rad; >= 0 (a joint that bends either way: its magnitude)
  double hinge_distance{};  ///< from the hinge axis to the cores' axis, m; > core_radius
  double core_radius{};     ///< of the faces that exchange heat, m; > 0
};

/// Thickness of the flat air gap that conducts as much heat as a wedge, m; 0 when closed. Use it as Gap::air.
///
/// Heat crosses the wedge along arcs of length r angle about the hinge, so the thickness is angle over the mean of 1/r
/// across the disc: angle h rho^2 / (2 (1 - sqrt(1 - rho^2))), rho = core_radius / hinge_distance. Conduction only:
/// what air carries out of an open wedge, and radiation across it, are not in it. Throws std::invalid_argument naming
/// the field, the rule and the value received.
[[nodiscard]] double equivalent_air_gap(const Wedge& wedge);

/// Network of a chain.
///
/// A segment loses heat through its silicone (shape factor of a cylinder centred in a square bar, 2 pi L /
/// ln(1.08 w / D), with w = sqrt(width height)), then from its sides, perimeter times length; both in series. A solid
/// end is a straight fin with convection from its end face, as hot at its root as the core. Faces between segments pass
/// heat only to the neighbour, through discs of the smaller core. Sources: Incropera and DeWitt, Fundamentals of Heat
/// and Mass Transfer, table 4.1 case 6 (conduction) and table 3.4 case A (fins). The shape factor is meant for long
/// bars; a segment is half as long as wide, but its ends are covered by neighbours or fins. Throws
/// std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] Network build_network(const HeatChain& chain);

/// The heat transfer coefficient, W/(m2 K), at which the hottest coil of `chain` is exactly at its temperature limit
/// under `continuous_current` (A, > 0; the same in every coil). `chain.heat_transfer` is not used.
///
/// Calibrate on the prototype, then carry the coefficient to other geometries: it stands for everything outside
/// (convection, radiation, wires, mounting) as a property of a surface.
/// Throws std::invalid_argument when no coefficient from 0.01 to 10,000 W/(m2 K) does it (the conduction inside alone
/// may already be too poor), saying which current each end allows.
[[nodiscard]] double calibrate_heat_transfer(const HeatChain& chain, double continuous_current);

}  // namespace coilwright::thermal
