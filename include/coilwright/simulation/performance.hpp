#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/demagnetisation.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/simulation/modes.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::simulation {

using actuator::OperatingPoint;

/// The motion of a free finger at one current.
struct FreeMotion {
  mechanics::JointVector rest_angles;    ///< hanging without current, rad
  mechanics::JointVector steady_angles;  ///< end of a step from rest, rad
  double peak_bending_speed{};           ///< peak speed in that step, rad/s
  double peak_speed_time{};              ///< s
  double peak_angle{};                   ///< largest bending angle of that step, rad
  double peak_joint_angle{};             ///< largest magnitude of any joint's angle in that step, rad
  double overshoot{};                    ///< excess over the change of the bending angle
  std::optional<double> rise_time;       ///< 10 to 90 %, s
  std::optional<double> settling_time;   ///< to 2 %, s
  std::vector<Mode> modes;               ///< modes at the steady angles, slowest first
};

/// The force of a finger whose tip is held.
struct Grasp {
  double grasp_force{};                 ///< against the wall of the operating point, N
  mechanics::JointVector grasp_angles;  ///< of the joints in that grasp, rad
  double contact_force_no_current{};    ///< the force in the same pose without current, N
};

/// The motion and force of a model at one current.
struct MotionSummary : FreeMotion, Grasp {};

/// Values of coils and supply with coils as warm as the operating point makes them; absent in a thermal runaway.
struct Electrics {
  std::optional<double> resistance{};      ///< of the hottest coil, ohm
  std::optional<double> voltage{};         ///< across the hottest coil, V
  std::optional<double> power{};           ///< of all coils while on, W
  std::optional<double> supply_voltage{};  ///< open-circuit voltage that the supply needs, V
  std::optional<double> supply_current{};  ///< current that the supply delivers while on, A
  std::optional<double> driven_current{};  ///< largest current in every coil that the stated supply drives, A; absent
                                           ///< without a stated supply
};

/// Temperatures of coils and magnets when the operating point is held in one pose.
struct Heat {
  std::optional<double> coil_temperature{};    ///< mean of the hottest coil, degC; absent in a thermal runaway
  std::optional<double> coil_hot_spot{};       ///< hottest turn of that coil, degC; absent in a thermal runaway
  std::optional<double> magnet_temperature{};  ///< hottest magnet, degC; absent in a thermal runaway
  std::optional<double> skin_temperature{};  ///< hottest place of the outer surface, degC; absent in a thermal runaway
  thermal::NodeVector temperatures{};        ///< of every component, base to tip, degC; empty in a thermal runaway
  double continuous_current{};               ///< largest steady current for the coils' limit, A
  double magnet_continuous_current{};        ///< largest steady current for the magnets' limit, A
  double runaway_current{};                  ///< current above which there is no steady state, A
  double still_air_current{};                ///< the smaller of the two steady currents in still air, A
  std::optional<double> time_to_limit{};     ///< from cold until a part is at its limit, current on, s; absent if never
  std::optional<double> time_to_limit_warm{};  ///< time from the steady state of the mean load until a part is at its
                                               ///< limit, s; absent if never
  std::optional<double> ripple{};              ///< of a coil's mean temperature over a period, peak to peak, K
  Electrics electrics{};

  /// The largest current that coils and magnets bear for good, A.
  [[nodiscard]] double current_for_good() const noexcept {
    return std::min(continuous_current, magnet_continuous_current);
  }
};

/// The finger held free at the operating point.
struct FreeCase {
  Heat heat{};                         ///< at its steady joint angles
  std::optional<FreeMotion> motion{};  ///< at those temperatures; absent in a runaway that the magnets feel
};

/// The finger held against a wall at the operating point.
struct GrippingCase {
  Heat heat{};                   ///< heat at the joint angles of the grasp
  std::optional<Grasp> grasp{};  ///< grasp at those temperatures; absent in a thermal runaway that the magnets feel
};

/// All results of a design at an operating point.
struct Performance {
  MotionSummary cold;  ///< with everything at 20 degC, where remanence and resistance are stated
  FreeCase free;
  GrippingCase gripping;
  /// Demagnetisation of the magnets in the hotter of the two cases, at the current while on; absent if the magnets have
  /// no grade or one case runs away.
  std::optional<actuator::Demagnetisation> demagnetisation{};
  double axial_force{};      ///< of one coil on a magnet at the rest gap, 20 degC, N, positive for repulsion
  double mass{};             ///< kg
  double coil_resistance{};  ///< one coil at 20 degC, ohm
  double inductance{};       ///< one coil, H
  Electrics electrics_cold;  ///< with all coils at 20 degC
  double current_limit{};    ///< ampacity of the gauge by the design's choice, A
  double table_limit{};      ///< ampacity of the gauge in the chassis-wiring table, A
  double cost{};             ///< US$
};

/// Why a design has no performance: one line.
struct NoPerformance {
  std::string reason;
};

/// The motion of any model as it stands, also of a lumped one; magnets have their remanence at 20 degC. Throws
/// std::invalid_argument for an invalid `grasp`: see blocked_grasp().
[[nodiscard]] std::variant<MotionSummary, NoPerformance> motion_of(const actuator::Model& model, double current,
                                                                   const actuator::GraspPoint& grasp = {});

/// The performance of an assembled design. Pure: the same input gives the same bits. Throws std::invalid_argument for a
/// duty outside 0 to 1.
[[nodiscard]] std::variant<Performance, NoPerformance> performance_of(const actuator::Design& design,
                                                                      const actuator::Assembly& assembly,
                                                                      const OperatingPoint& point);

}  // namespace coilwright::simulation
