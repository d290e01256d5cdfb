#pragma once

namespace coilwright::actuator::effects {

/// A joint that sticks swings on its bristles at this angular frequency, rad/s, with this damping ratio: it springs
/// back by 0.04 mrad in a finger with 0.6 N mm, and no rig asks for steps shorter than 2 ms by sticking. At 300 rad/s
/// joints came to rest up to half a degree beside where Coulomb's law holds them.
inline constexpr double presliding_frequency = 1500.0;
inline constexpr double presliding_damping = 0.7;

/// Fastest turning over of a bristle, 1/s. Without a floor, weak friction on a fast joint turns over within
/// microseconds and the integrator has to follow; half a millisecond is below a sample.
inline constexpr double turnover_rate = 2e3;

}  // namespace coilwright::actuator::effects
