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
  double backlash = 0.0;              ///< rad: each magnet is loose by so much, from one side of its seat to the other
  double backlash_inertia =
      0.15;  ///< of a loose magnet, over the effective inertia of its joint in the straight finger
  // hinge
  double friction = 0.0;        ///< N m
  double stribeck_ratio = 1.0;  ///< friction of a joint at rest over that of a fast one
  double stribeck_rate = 1.0;   ///< rad/s: friction falls as exp(-(rate / stribeck_rate)^2)
  double drag = 0.0;            ///< N m s^2/rad^2
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
  double tracking_time = 0.0;  ///< s: the camera's tracker is a low-pass filter of the first order

  // Outside any catalogue.
  double shake = 0.0;               ///< m/s^2, horizontal acceleration of the base
  double shake_frequency = 5.0;     ///< Hz
  double drift = 0.0;               ///< share of the stiffness that is lost per hour of the session
  double mullins = 0.0;             ///< share of the stiffness that is lost by an infinite stretch
  double mullins_angle = 0.5;       ///< rad
  double cable = 0.0;               ///< N m/sqrt(s), random walk
  double mount_compliance = 0.0;    ///< 1/(mass of the mount over that of the finger)
  double mount_frequency = 15.0;    ///< Hz, of the mount alone
  double mount_damping = 0.05;      ///< ratio
  double contact_loss = 0.0;        ///< share of the current that is lost while the contact is bad
  double contact_rate = 1.0;        ///< 1/s
  double ripple = 0.0;              ///< N m
  double ripple_count = 12.0;       ///< periods per turn
  double hum = 0.0;                 ///< rad, added to the shown angle
  double hum_frequency = 50.0;      ///< Hz
  double frozen_frames = 0.0;       ///< s, mean length of a frozen picture
  double frozen_rate = 3.0;         ///< 1/s
  double stamp_jitter = 0.0;        ///< s, standard deviation of the exposure relative to its time stamp
  double angle_friction = 0.0;      ///< N m/rad: friction that grows with the bending of the hinge
  double warm_friction = 0.0;       ///< N m/A^2: friction that grows with the heat of the coils
  double warm_friction_time = 5.0;  ///< s
  double joint_coupling = 0.0;      ///< N m/rad: silicone between the segments resists a difference of the angles
  double iron_saturation = 0.0;     ///< 1/A: share of the force that is lost per ampere
  double contact_share = 0.0;       ///< share of the first coil's current that goes through the second beyond an angle
  double contact_angle = 0.3;       ///< rad
  double magnet_shift = 0.0;        ///< share of the force that is lost when the magnets have moved out of their seats
  double shift_travel = 3.0;        ///< rad of motion of a joint over which they do
  double cable_stiffness = 0.0;     ///< N m/rad, from the first joint to where the cable sticks
  double cable_hold = 1e-4;         ///< N m: with more tension it slips and is slack
  double gust = 0.0;                ///< N m on both joints, standard deviation of the air's push
  double gust_time = 0.2;           ///< s, its correlation time
  double ringing_time = 0.0;        ///< s over rad: reciprocal of the natural frequency of a current loop
  double ringing_damping = 0.2;     ///< its damping ratio
  double parallax = 0.0;            ///< 1/rad: the shown angle has an error quadratic in the angle
  double shutter_skew = 0.0;        ///< s/rad: the later a finger is seen the further it is bent (rolling shutter)
  double bend_share = 0.0;          ///< share of the tip segment's mass on a part that bends
  double bend_frequency = 20.0;     ///< Hz, of that part alone
  double bend_damping = 0.03;       ///< ratio

  /// Whether the tracker is late at all: 0.1 ms are less than any picture shows, and would need steps as short.
  [[nodiscard]] bool tracks() const { return tracking_time > 1e-4; }

  std::uint64_t chance = 0;  ///< random seed of phases, walks and losses
};

}  // namespace truth
