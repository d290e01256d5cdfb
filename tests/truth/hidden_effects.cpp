#include "truth/hidden_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "degree.hpp"

namespace truth {
namespace {

constexpr double milli = 1e3;  // mm, ms, mN, mA, g in a kg

using Strength = std::function<void(UnmodelledEffects&, double)>;
using Shape = std::function<void(Random&, UnmodelledEffects&)>;

// Sets a number between its absent value and a bound.
Strength towards(double UnmodelledEffects::*member, double absent, double bound) {
  return [=](UnmodelledEffects& effects, double share) { effects.*member = absent + share * (bound - absent); };
}

HiddenKind plain(std::string id, std::vector<HiddenNumber> numbers, double UnmodelledEffects::*member, double absent,
                 double bound, Shape shape = nullptr) {
  return {.id = std::move(id),
          .numbers = std::move(numbers),
          .draw = [=](Random& random, const AngleRange&, UnmodelledEffects& effects) {
            if (shape) shape(random, effects);
            return towards(member, absent, bound);
          }};
}

// The same, towards either of two bounds.
HiddenKind two_sided(std::string id, std::vector<HiddenNumber> numbers, double UnmodelledEffects::*member,
                     double absent, double lower, double upper) {
  return {.id = std::move(id),
          .numbers = std::move(numbers),
          .draw = [=](Random& random, const AngleRange&, UnmodelledEffects&) {
            return towards(member, absent, random.sign() > 0.0 ? upper : lower);
          }};
}

HiddenKind without_strength(std::string id, bool UnmodelledEffects::*member) {
  return {.id = std::move(id),
          .numbers = {},
          .draw = [=](Random&, const AngleRange&, UnmodelledEffects& effects) -> Strength {
            effects.*member = true;
            return [](UnmodelledEffects&, double) {};
          }};
}

// Its strength is that after the fit of stiffness and damping: one that they compensate would test nothing.
HiddenKind beyond_calibration(HiddenKind kind) {
  kind.strength_beyond_calibration = true;
  return kind;
}

HiddenKind outsider(HiddenKind kind) {
  kind.standing = Standing::outsider;
  return beyond_calibration(std::move(kind));
}

HiddenKind kept(HiddenKind kind) {
  kind.standing = Standing::kept;
  return beyond_calibration(std::move(kind));
}

HiddenKind stribeck_friction() {
  HiddenKind kind = plain("dry_friction",
                          {{"torque_Nmm", &UnmodelledEffects::friction, milli},
                           {"stribeck_ratio", &UnmodelledEffects::stribeck_ratio},
                           {"stribeck_rate_rad_s", &UnmodelledEffects::stribeck_rate}},
                          &UnmodelledEffects::friction, 0.0, 4e-3, [](Random& random, UnmodelledEffects& effects) {
                            effects.stribeck_ratio = random.uniform(1.3, 2.2);
                            effects.stribeck_rate = random.log_uniform(0.2, 3.0);
                          });
  kind.variant = "stribeck_friction";
  return kind;
}

HiddenKind end_stop() {
  return {.id = "end_stop",
          .numbers = {{"angle_deg", &UnmodelledEffects::stop_angle, radian_in_degrees},
                      {"stiffness_Nmm_rad", &UnmodelledEffects::stop_stiffness, milli},
                      {"side", &UnmodelledEffects::stop_side}},
          .draw = [](Random& random, const AngleRange& range, UnmodelledEffects& effects) {
            effects.stop_side = random.sign();
            effects.stop_stiffness = random.log_uniform(0.06, 0.6);  // 5 to 50 times the hinge
            const double free = effects.stop_side > 0.0 ? range.highest : range.lowest;
            const double middle = 0.5 * (range.highest + range.lowest);
            return towards(&UnmodelledEffects::stop_angle, free, middle);
          }};
}

HiddenKind static_attraction() {
  return {.id = "static_attraction",
          .numbers = {{"torque_Nmm", &UnmodelledEffects::attraction, milli},
                      {"range_deg", &UnmodelledEffects::attraction_range, radian_in_degrees},
                      {"side", &UnmodelledEffects::attraction_side}},
          .draw = [](Random& random, const AngleRange&, UnmodelledEffects& effects) {
            effects.attraction_side = random.sign();
            effects.attraction_range = random.log_uniform(0.6, 1.5);
            return towards(&UnmodelledEffects::attraction, 0.0,
                           effects.attraction_side * 4e-3);  // iron attracts the magnet
          }};
}

Shape between(double UnmodelledEffects::*member, double lower, double upper) {
  return [=](Random& random, UnmodelledEffects& effects) { effects.*member = random.log_uniform(lower, upper); };
}

// A time constant, and whether runs start warm.
Shape heat(double UnmodelledEffects::*time, double lower, double upper) {
  return [=](Random& random, UnmodelledEffects& effects) {
    between(time, lower, upper)(random, effects);
    effects.warm_start = random.sign() > 0.0 ? 1.0 : 0.0;
  };
}

// Bounds are the largest values at which a finger of this size is still usable. If a strength cannot be reached within
// them, the answer states the strength that was.
std::vector<HiddenKind> all_kinds() {
  using Q = UnmodelledEffects;
  return {
      plain("driver_deadband", {{"current_A", &Q::deadband}}, &Q::deadband, 0.0, 0.4),
      plain("driver_saturation", {{"current_A", &Q::saturation}}, &Q::saturation, 1.4, 0.4),
      two_sided("current_offset", {{"current_mA", &Q::current_offset, milli}}, &Q::current_offset, 0.0, -0.3, 0.3),
      plain("coil_heating",
            {{"fade_1_A2", &Q::coil_fade}, {"time_constant_s", &Q::coil_time}, {"warm_start", &Q::warm_start}},
            &Q::coil_fade, 0.0, 0.4, heat(&Q::coil_time, 1.0, 15.0)),
      plain("coil_lag", {{"time_constant_ms", &Q::current_lag, milli}}, &Q::current_lag, 0.0, 0.05),
      two_sided("force_gain", {{"gain", &Q::force_gain}}, &Q::force_gain, 1.0, 0.6, 1.4),
      plain("magnet_heating",
            {{"loss_1_A2", &Q::magnet_loss}, {"time_constant_s", &Q::magnet_time}, {"warm_start", &Q::warm_start}},
            &Q::magnet_loss, 0.0, 0.1, heat(&Q::magnet_time, 2.0, 30.0)),
      without_strength("off_axis_force", &Q::off_axis),
      without_strength("coil_coil_force", &Q::coil_coil),
      static_attraction(),
      plain("back_emf", {{"conductance_1_Ohm", &Q::motional_conductance}}, &Q::motional_conductance, 0.0, 3.0),
      two_sided("joint_asymmetry", {{"stiffness_ratio", &Q::second_stiffness_ratio}}, &Q::second_stiffness_ratio, 1.0,
                0.4, 2.5),
      two_sided("rest_angle", {{"angle_deg", &Q::rest_angle, radian_in_degrees}}, &Q::rest_angle, 0.0, -0.4, 0.4),
      two_sided("stiffness_hardening", {{"coefficient_1_rad2", &Q::hardening}}, &Q::hardening, 0.0, -1.0 / 3.0, 5.0),
      plain("viscoelastic_creep", {{"stiffness_ratio", &Q::creep_share}, {"time_constant_s", &Q::creep_time}},
            &Q::creep_share, 0.0, 1.5, between(&Q::creep_time, 0.03, 5.0)),
      plain("hysteresis", {{"amplitude_Nmm", &Q::hysteresis, milli}, {"sharpness_1_rad", &Q::hysteresis_sharpness}},
            &Q::hysteresis, 0.0, 4e-3, between(&Q::hysteresis_sharpness, 2.0, 20.0)),
      plain("dry_friction", {{"torque_Nmm", &Q::friction, milli}}, &Q::friction, 0.0, 4e-3),
      plain("quadratic_drag", {{"drag_Nmms2_rad2", &Q::drag, milli}}, &Q::drag, 0.0, 3e-5),
      end_stop(),
      plain("added_mass", {{"mass_g", &Q::added_mass, milli}}, &Q::added_mass, 0.0, 20e-3),
      two_sided("base_tilt", {{"angle_deg", &Q::base_tilt, radian_in_degrees}}, &Q::base_tilt, 0.0, -0.5, 0.5),
      plain("measurement_delay", {{"delay_ms", &Q::delay, milli}}, &Q::delay, 0.0, 0.06),
      two_sided("angle_scale", {{"scale", &Q::angle_scale}}, &Q::angle_scale, 1.0, 0.7, 1.3),
      two_sided("angle_offset", {{"angle_deg", &Q::angle_offset, radian_in_degrees}}, &Q::angle_offset, 0.0, -0.17,
                0.17),

      outsider(plain("shaken_base", {{"acceleration_m_s2", &Q::shake}, {"frequency_Hz", &Q::shake_frequency}},
                     &Q::shake, 0.0, 20.0, between(&Q::shake_frequency, 2.0, 25.0))),
      outsider(two_sided("drifting_stiffness", {{"share_1_h", &Q::drift}}, &Q::drift, 0.0, -1.2, 1.2)),
      beyond_calibration(plain("mullins_softening",
                               {{"softening", &Q::mullins}, {"angle_deg", &Q::mullins_angle, radian_in_degrees}},
                               &Q::mullins, 0.0, 0.6, between(&Q::mullins_angle, 0.2, 0.6))),
      outsider(plain("random_cable", {{"torque_Nmm_s0.5", &Q::cable, milli}}, &Q::cable, 0.0, 4e-3)),
      beyond_calibration(plain("mount_compliance",
                               {{"mass_ratio", &Q::mount_compliance},
                                {"mount_frequency_Hz", &Q::mount_frequency},
                                {"mount_damping_ratio", &Q::mount_damping}},
                               &Q::mount_compliance, 0.0, 3.0,
                               [](Random& random, UnmodelledEffects& effects) {
                                 effects.mount_frequency = random.log_uniform(6.0, 25.0);
                                 effects.mount_damping = random.log_uniform(0.01, 0.05);
                               })),
      outsider(plain("loose_contact", {{"share", &Q::contact_loss}, {"rate_1_s", &Q::contact_rate}}, &Q::contact_loss,
                     0.0, 1.0, between(&Q::contact_rate, 1.0, 3.0))),
      outsider(plain("torque_ripple", {{"torque_Nmm", &Q::ripple, milli}, {"periods", &Q::ripple_count}}, &Q::ripple,
                     0.0, 4e-3, between(&Q::ripple_count, 15.0, 45.0))),
      outsider(plain("mains_hum", {{"amplitude_deg", &Q::hum, radian_in_degrees}}, &Q::hum, 0.0, 0.2)),
      outsider(plain("frozen_frames",
                     {{"length_ms", &Q::frozen_frames, milli},
                      {"rate_1_s", &Q::frozen_rate},
                      {"jitter_ms", &Q::stamp_jitter, milli}},
                     &Q::frozen_frames, 0.0, 0.3,
                     [](Random& random, UnmodelledEffects& effects) {
                       effects.frozen_rate = random.log_uniform(2.0, 8.0);
                       effects.stamp_jitter = random.log_uniform(0.3e-3, 1.5e-3);
                     })),

      stribeck_friction(),
      plain("backlash", {{"gap_deg", &Q::backlash, radian_in_degrees}, {"inertia_share", &Q::backlash_inertia}},
            &Q::backlash, 0.0, 10.0 / radian_in_degrees,
            [](Random& random, UnmodelledEffects& effects) { effects.backlash_inertia = random.uniform(0.13, 0.17); }),
      plain("tracking_lag", {{"time_constant_ms", &Q::tracking_time, milli}}, &Q::tracking_time, 0.0, 0.06),

      outsider(plain("friction_of_bent_hinge", {{"torque_Nmm_rad", &Q::angle_friction, milli}}, &Q::angle_friction, 0.0,
                     8e-3)),
      outsider(plain("bending_segment",
                     {{"share", &Q::bend_share}, {"frequency_Hz", &Q::bend_frequency}, {"damping", &Q::bend_damping}},
                     &Q::bend_share, 0.0, 0.8,
                     [](Random& random, UnmodelledEffects& effects) {
                       effects.bend_frequency = random.log_uniform(10.0, 40.0);
                       effects.bend_damping = random.log_uniform(0.02, 0.1);
                     })),
      outsider(plain("shifting_magnet", {{"share", &Q::magnet_shift}, {"travel_rad", &Q::shift_travel}},
                     &Q::magnet_shift, 0.0, 0.3, between(&Q::shift_travel, 1.0, 8.0))),
      outsider(plain("contact_between_coils",
                     {{"share", &Q::contact_share}, {"angle_deg", &Q::contact_angle, radian_in_degrees}},
                     &Q::contact_share, 0.0, 0.5, between(&Q::contact_angle, 0.25, 0.5))),
      outsider(plain("gusts", {{"torque_Nmm", &Q::gust, milli}, {"time_constant_s", &Q::gust_time}}, &Q::gust, 0.0,
                     2e-3, between(&Q::gust_time, 0.05, 0.5))),
      outsider(plain("saturating_iron", {{"share_1_A", &Q::iron_saturation}}, &Q::iron_saturation, 0.0, 0.3)),
      outsider(two_sided("camera_parallax", {{"share_1_rad", &Q::parallax}}, &Q::parallax, 0.0, -0.2, 0.2)),
      outsider(plain("sticking_cable",
                     {{"stiffness_Nmm_rad", &Q::cable_stiffness, milli}, {"hold_Nmm", &Q::cable_hold, milli}},
                     &Q::cable_stiffness, 0.0, 5e-3, between(&Q::cable_hold, 0.1e-3, 0.6e-3))),

      kept(plain("coupled_joints", {{"stiffness_Nmm_rad", &Q::joint_coupling, milli}}, &Q::joint_coupling, 0.0, 20e-3)),
      kept(plain("warming_friction",
                 {{"torque_Nmm_A2", &Q::warm_friction, milli}, {"time_constant_s", &Q::warm_friction_time}},
                 &Q::warm_friction, 0.0, 2e-3, between(&Q::warm_friction_time, 0.3, 5.0))),
      kept(plain("ringing_driver", {{"time_ms", &Q::ringing_time, milli}, {"damping_ratio", &Q::ringing_damping}},
                 &Q::ringing_time, 0.0, 20e-3, between(&Q::ringing_damping, 0.1, 0.4))),
      kept(two_sided("rolling_shutter", {{"skew_ms_rad", &Q::shutter_skew, milli}}, &Q::shutter_skew, 0.0, -25e-3,
                     25e-3)),
  };
}

}  // namespace

std::span<const HiddenKind> hidden_kinds() {
  static const std::vector<HiddenKind> kinds = all_kinds();
  return kinds;
}

const HiddenKind& hidden_kind(std::string_view name) {
  for (const HiddenKind& kind : hidden_kinds())
    if (kind.name() == name) return kind;
  throw std::invalid_argument(fmt::format("hidden effect: must be one of the table; got \"{}\"", name));
}

}  // namespace truth
