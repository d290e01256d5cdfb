#include "measurement/experiment/candidate_experiments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace coilwright::measurement::experiment {
namespace {

using actuator::ModelSpec;

constexpr double pi = std::numbers::pi;

}  // namespace

std::vector<CandidateExperiment> candidate_experiments(const DriveRange& range) {
  const auto amount = [&](double share) { return fmt::format("{:.3g} {}", share * range.amplitude, range.unit); };
  const auto sine = [](double frequency) {
    return [frequency](double t) { return 0.5 + 0.5 * std::sin(2.0 * pi * frequency * t); };
  };
  std::vector<CandidateExperiment> out{
      {.kind = "step",
       .input = fmt::format("0 to {} at once, 2 s", amount(1.0)),
       .why = "a step shows stiffness, damping and creep apart",
       .duration = 2.0,
       .command = [](double t) { return t < 0.1 ? 0.0 : 1.0; }},
      {.kind = "step",
       .input = fmt::format("0 to {} at once, 2 s", amount(0.25)),
       .why = "a small step shows what does not grow with the amplitude",
       .duration = 2.0,
       .command = [](double t) { return t < 0.1 ? 0.0 : 0.25; }},
      {.kind = "sine",
       .input = fmt::format("{0} + {0} sin(2 pi t), 1 Hz, 4 s", amount(0.5)),
       .why = "a slow cycle shows loops that do not depend on speed",
       .duration = 4.0,
       .command = sine(1.0)},
      {.kind = "sine",
       .input = fmt::format("{0} + {0} sin(2 pi 5 t), 5 Hz, 2 s", amount(0.5)),
       .why = "near resonance phase and damping show",
       .duration = 2.0,
       .command = sine(5.0)},
      {.kind = "chirp",
       .input = fmt::format("{0} + {0} sin, 0.5 to 20 Hz in 8 s", amount(0.5)),
       .why = "all frequencies: a delay turns the phase in proportion, a lag bends it",
       .duration = 8.0,
       .command = [](double t) { return 0.5 + 0.5 * std::sin(2.0 * pi * (0.5 * t + 19.5 / 16.0 * t * t)); }},
      {.kind = "release",
       .input = fmt::format("hold {} for 1 s, then 0 for 2 s", amount(1.0)),
       .why = "the free decay shows how friction depends on amplitude",
       .duration = 3.0,
       .command = [](double t) { return t < 1.0 ? 1.0 : 0.0; }},
      {.kind = "hot_hold",
       .input = fmt::format("hold {} for 60 s, then {} for 20 s", amount(1.0), amount(0.3)),
       .why = "heat grows with the square of the current and stays when it falls; creep follows the angle",
       .duration = 80.0,
       .command = [](double t) { return t < 60.0 ? 1.0 : 0.3; }},
      {.kind = "small_large_small",
       .input = fmt::format("1 Hz cycles: 2 to {}, 2 to {}, 2 to {}", amount(0.3), amount(1.0), amount(0.3)),
       .why = "what remembers the largest angle differs between the two small cycles",
       .duration = 6.0,
       .command =
           [](double t) {
             const double size = t >= 2.0 && t < 4.0 ? 1.0 : 0.3;
             return size * 0.5 * (1.0 - std::cos(2.0 * pi * t));
           }},
      {.kind = "reversed_current",
       .input = fmt::format("0 to -{} at once, 2 s", amount(0.5)),
       .why = "what does not turn with the current's sign stands out",
       .duration = 2.0,
       .command = [](double t) { return t < 0.1 ? 0.0 : -0.5; }},
      {.kind = "turned_base",
       .input = fmt::format("base turned by 90 deg towards opening, 0 to {}, 2 s", amount(0.5)),
       .why = "gravity turns with the base, springs, sensors and magnets do not",
       .duration = 2.0,
       .command = [](double t) { return t < 0.5 ? 0.0 : 0.5; },
       .change =
           [](ModelSpec& spec) {
             spec.chain = spec.chain.under_gravity(spec.chain.gravity(), spec.chain.base_tilt() + 0.5 * pi);
           }},
  };
  if (range.coils)
    out.push_back({.kind = "coil_open",
                   .input = fmt::format("hold {} for 1 s, then open the circuit for 2 s", amount(1.0)),
                   .why = "without a closed circuit neither driver nor induced current acts: what changes is theirs",
                   .duration = 3.0,
                   .command = [](double t) { return t < 1.0 ? 1.0 : 0.0; },
                   .change =
                       [](ModelSpec& spec) {
                         std::erase_if(spec.effects, [](const actuator::Effect& effect) {
                           return effect.kind->needs_closed_circuit();
                         });
                       }});
  return out;
}

}  // namespace coilwright::measurement::experiment
