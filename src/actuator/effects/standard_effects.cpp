#include "coilwright/actuator/model/effect_catalogue.hpp"

#include "actuator/effects/effect_rows.hpp"

// The whole list: a line declares an effect and puts it in its place. In the order of the stages; within a stage, in
// the order in which the effects act and are built in, so that those that change a spring stand before those that read
// it.
#define COILWRIGHT_EFFECTS(EFFECT) \
  EFFECT(driver_deadband)          \
  EFFECT(driver_saturation)        \
  EFFECT(current_offset)           \
  EFFECT(coil_heating)             \
  EFFECT(coil_lag)                 \
  EFFECT(off_axis_force)           \
  EFFECT(coil_coil_force)          \
  EFFECT(force_gain)               \
  EFFECT(magnet_heating)           \
  EFFECT(static_attraction)        \
  EFFECT(back_emf)                 \
  EFFECT(backlash)                 \
  EFFECT(joint_asymmetry)          \
  EFFECT(rest_angle)               \
  EFFECT(stiffness_hardening)      \
  EFFECT(mullins_softening)        \
  EFFECT(viscoelastic_creep)       \
  EFFECT(hysteresis)               \
  EFFECT(dry_friction)             \
  EFFECT(load_friction)            \
  EFFECT(quadratic_drag)           \
  EFFECT(end_stop)                 \
  EFFECT(added_mass)               \
  EFFECT(rotor_inertia)            \
  EFFECT(base_tilt)                \
  EFFECT(mount_compliance)         \
  EFFECT(measurement_delay)        \
  EFFECT(tracking_lag)             \
  EFFECT(angle_scale)              \
  EFFECT(angle_offset)

namespace coilwright::actuator {
namespace effects {

// Each is defined in the file of what it changes.
#define COILWRIGHT_DECLARE(id) EffectProperties id();
COILWRIGHT_EFFECTS(COILWRIGHT_DECLARE)
#undef COILWRIGHT_DECLARE

}  // namespace effects

const EffectCatalogue& standard_effects() {
#define COILWRIGHT_LIST(id) &effects::kind_of<effects::id>(),
  static const EffectCatalogue all({COILWRIGHT_EFFECTS(COILWRIGHT_LIST)});
#undef COILWRIGHT_LIST
  return all;
}

}  // namespace coilwright::actuator
