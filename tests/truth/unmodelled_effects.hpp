#pragma once

#include <cstdint>
#include <limits>

namespace truth {

/// All effects of the simulated finger that the declared model lacks, SI. Each is absent by default.
struct UnmodelledEffects {
  // drive
  double deadband = 0.0;                                        ///< A
  double saturation = std::numeric_limits<double>::infinity();  ///< A
  double current_offset = 0.0;                                  ///< A
  double current_lag = 0.0;                                     ///< s
  double coil_fade = 0.0;                                       ///< 1/A^2: steady relative rise of the resistance
  double coil_time = 10.0;                                      ///< s
  double warm_start = 1.0;  ///< 1: runs from rest start with coils and magnets warm from a long hold; 0: cold
  // magnetics
  double force_gain = 1.0;
  double magnet_loss = 0.0;  ///< 1/A^2: steady relative loss of force
  double magnet_time = 10.0;
  bool off_axis = false;
  bool coil_coil = false;
  double motional_conductance = 0.0;  ///< 1/ohm: torque -kappa (dq/di)^2 omega
  double attraction = 0.0;            ///< N m on the first joint at angle 0: iron on which its magnet pulls
  double attraction_range = 1.0;      ///< rad from angle 0 to the iron
  double attraction_side = -1.0;      ///< side of the iron: 1 opening, -1 closing
  // hinge
  double friction = 0.0;  ///< N m
  double drag = 0.0;      ///< N m s^2/rad^2
  double creep_share = 0.0;
  double creep_time = 1.0;            ///< s
  double hysteresis = 0.0;            ///< N m
  double hysteresis_sharpness = 1.0;  ///< 1/rad
  double hardening = 0.0;             ///< 1/rad^2
  double second_stiffness_ratio = 1.0;
  double rest_angle = 0.0;  ///< rad
  double stop_angle = 0.0;  ///< rad
  double stop_stiffness = 0.0;
  double stop_side = 1.0;  ///< 1: holds an opening joint, -1: a closing one
  // chain
  double base_tilt = 0.0;   ///< rad, towards opening
  double added_mass = 0.0;  ///< kg, at the tip segment's centre of mass
  // camera
  double delay = 0.0;         ///< s
  double angle_offset = 0.0;  ///< rad, added to the shown angle
  double angle_scale = 1.0;

  // Outside any catalogue.
  double shake = 0.0;             ///< m/s^2, horizontal acceleration of the base
  double shake_frequency = 5.0;   ///< Hz
  double drift = 0.0;             ///< share of the stiffness that is lost per hour of the session
  double mullins = 0.0;           ///< share of the stiffness that is lost by an infinite stretch
  double mullins_angle = 0.5;     ///< rad
  double cable = 0.0;             ///< N m/sqrt(s), random walk
  double mount_compliance = 0.0;  ///< 1/(mass of the mount over that of the finger)
  double mount_frequency = 15.0;  ///< Hz, of the mount alone
  double mount_damping = 0.05;    ///< ratio
  double contact_loss = 0.0;      ///< share of the current that is lost while the contact is bad
  double contact_rate = 1.0;      ///< 1/s
  double ripple = 0.0;            ///< N m
  double ripple_count = 12.0;     ///< periods per turn
  double hum = 0.0;               ///< rad, added to the shown angle
  double hum_frequency = 50.0;    ///< Hz
  double frozen_frames = 0.0;     ///< s, mean length of a frozen picture
  double frozen_rate = 3.0;       ///< 1/s
  double stamp_jitter = 0.0;      ///< s, standard deviation of the exposure relative to its time stamp
  std::uint64_t chance = 0;       ///< random seed of phases, walks and losses
};

}  // namespace truth
