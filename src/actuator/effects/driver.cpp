#include <algorithm>
#include <cmath>

#include "actuator/effects/effect_rows.hpp"

// The driver gives another current than its command. A bias comes after band and limit: that of a current loop's sensor
// flows at any command, at none too.
namespace coilwright::actuator::effects {

// Continuous: what is lost at the band is lost beyond it too, as on a bridge whose switches take their dead time from
// every pulse. The other kind of band, which lets a larger command through whole, is a nonlinear driver and not a band.
EffectProperties driver_deadband() {
  return {.id = "driver_deadband",
          .stage = Stage::drive,
          .description = "small commands are lost in the driver",
          .equation = "i -> sgn(i) max(|i| - d, 0)",
          .source = "dead zone of an actuator: Tao and Kokotovic, IEEE Trans. Autom. Control 39 (1994) 59",
          .check = "put an ammeter in the coil's lead and command small currents in steps around the band",
          .parameters = {from_zero("current_A", "half the band of commands without an answer")},
          .starts = shares_of(&RigScale::current, {0.03, 0.15}),
          .build = [](Values values, ModelSpec& /*spec*/) {
            return driven_current([band = values[0]](double current) {
              return std::copysign(std::max(std::abs(current) - band, 0.0), current);
            });
          }};
}

// No finite limit is without effect on every command, so absent is infinity and lies outside the bounds; to a fit, any
// limit above its largest command is as good. It sees a limit only while it cuts something off: starts go from close
// below the largest command downwards.
EffectProperties driver_saturation() {
  return {.id = "driver_saturation",
          .stage = Stage::drive,
          .description = "the driver or its supply gives less current than the largest command",
          .equation = "i -> max(-i_max, min(i, i_max))",
          .source = "current limit of a driver or u_max / R of its supply; definition",
          .check = "put an ammeter in the coil's lead and command the largest current",
          .parameters = {{.key = "current_A",
                          .text = "largest current that the driver gives, either sign",
                          .lower = 0.0,
                          .upper = 1e3,
                          .absent = infinity}},
          .starts = shares_of(&RigScale::current, {0.95, 0.8, 0.6}),
          .build = [](Values values, ModelSpec& /*spec*/) {
            return driven_current([limit = values[0]](double current) { return std::clamp(current, -limit, limit); });
          }};
}

EffectProperties current_offset() {
  return {.id = "current_offset",
          .stage = Stage::drive,
          .description = "a bias of the driver or of its current sensor",
          .equation = "i -> i + i_0",
          .source = "definition",
          .check = "command zero and read an ammeter in the coil's lead",
          .parameters = {about_zero("current_mA", "current of every coil at no command", 5.0)},
          .needs_closed_circuit = true,
          .starts = shares_of(&RigScale::current, {0.02, -0.02}),
          .build = [](Values values, ModelSpec& /*spec*/) {
            return driven_current([offset = values[0]](double current) { return current + offset; });
          }};
}

}  // namespace coilwright::actuator::effects
