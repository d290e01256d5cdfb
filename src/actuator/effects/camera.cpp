#include "actuator/effects/effect_rows.hpp"

// The camera shows another angle. After the lag of its tracking, the scale, then the offset: what it shows at zero.
namespace coilwright::actuator::effects {

EffectProperties angle_scale() {
  return {.id = "angle_scale",
          .stage = Stage::camera,
          .description = "the sensor's scale is off: lens, encoder counts",
          .equation = "y = s theta, every angle shown",
          .source = "definition",
          .check = "bend the joints by a known angle, along a printed template, and compare what the sensor shows",
          .parameters = {about_one("scale", "angle shown over angle", 2.0)},
          .starts = always({0.97, 1.03}),
          .build = [](Values values, ModelSpec& /*spec*/) {
            return shown_angle([scale = values[0]](double angle) { return scale * angle; });
          }};
}

EffectProperties angle_offset() {
  return {.id = "angle_offset",
          .stage = Stage::camera,
          .description = "the sensor's zero is off",
          .equation = "y = theta + theta_b, every angle shown",
          .source = "definition",
          .check = "hold the finger straight against a ruler and read the angle that the sensor shows",
          .parameters = {about_zero("angle_deg", "shown at angle zero", 10.0 / degrees)},
          .starts = always({1.0 / degrees, -1.0 / degrees}),
          .build = [](Values values, ModelSpec& /*spec*/) {
            return shown_angle([offset = values[0]](double angle) { return angle + offset; });
          }};
}

}  // namespace coilwright::actuator::effects
