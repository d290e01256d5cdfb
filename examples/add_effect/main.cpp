// A finger has iron beside its magnets, and its model does not know of any. Does a diagnosis name that effect, if the
// effect is of this program and not of Coilwright?
//
// Build  cmake --preset release && cmake --build --preset release --target example_add_effect
// Run    build/release/examples/add_effect
// Prints the effects that the program knows, the one that the diagnosis found with its fitted numbers, and the same
//        after it was written into the text of an actuator file and read back.

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/measurement/corrected_model.hpp"
#include "coilwright/measurement/data/hold_out.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "coilwright/measurement/replay/declare.hpp"
#include "coilwright/units/unit.hpp"

const coilwright::actuator::EffectKind& reluctance_torque();  // reluctance_torque.cpp

namespace {

using namespace coilwright;
using namespace coilwright::measurement;

// The line that adds the effect.
const actuator::EffectCatalogue& effects() {
  static const actuator::EffectCatalogue catalogue = actuator::standard_effects().with(reluctance_torque());
  return catalogue;
}

planning::PlannedRun run(const std::string& name, planning::InputShape input, double duration) {
  const data::Channel camera{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle};
  return {.plan = {.name = name, .channels = {camera}}, .input = std::move(input), .duration = duration, .rate = 100.0};
}

// Records of a finger with the effect, seen by a camera.
data::Dataset measured(const replay::DeclaredModel& rig) {
  using namespace planning;
  const Experiment runs{.name = "finger with iron",
                        .instruments = {.angle = {.noise = 0.005}},  // rad: 0.3 degrees
                        .runs = {run("step_0.5A", StepShape{.after = 0.5, .at = 0.1}, 1.0),
                                 run("step_1.0A", StepShape{.after = 1.0, .at = 0.1}, 1.0),
                                 run("step_1.4A", StepShape{.after = 1.4, .at = 0.1}, 1.0),
                                 run("sine", SineShape{.amplitude = 0.7, .offset = 0.5, .frequency = 1.0}, 2.0),
                                 run("release", StepShape{.before = 1.2, .at = 0.1}, 1.0)}};
  const actuator::Effect iron{.kind = &reluctance_torque(), .values = {2e-3, 0.5}};  // 2 mH, 0.5 rad
  data::Dataset set;
  set.fit = simulate_experiment(runs, rig, {&iron, 1}, 1);
  return data::with_runs_held_out(set);  // some of them for the final errors only
}

void print(const actuator::Effect& effect) {
  std::printf("  %s\n", std::string(effect.kind->id()).c_str());
  for (std::size_t i = 0; i < effect.values.size(); ++i) {
    const actuator::EffectParameter& number = effect.kind->parameters()[i];
    std::printf("    %-14s %.2f\n", std::string(number.key).c_str(), units::from_memory(effect.values[i], number.key));
  }
}

}  // namespace

int main() {
  try {
    std::printf("%zu effects are known; of the magnetics:", effects().kinds().size());
    for (const actuator::EffectKind* kind : effects().kinds())
      if (kind->stage() == actuator::Stage::magnetics) std::printf(" %s", std::string(kind->id()).c_str());

    actuator::Design finger;  // the defaults are the prototype's
    const replay::DeclaredModel declared = replay::declare(finger);
    const Diagnosis diagnosis = diagnose(measured(declared), declared, {.effects = effects()});
    std::printf("\nverdict: %s\n", std::string(name_of(diagnosis.verdict)).c_str());
    for (const actuator::Effect& effect : effects_of(diagnosis)) print(effect);

    finger.effects = effects_of(diagnosis);
    const std::string text = formats::to_json(finger, "finger with iron").text();
    const formats::ActuatorFile back = formats::parse_actuator(text, "finger.json", effects());
    std::puts("read back from its file:");
    for (const actuator::Effect& effect : std::get<actuator::Design>(back.content).effects) print(effect);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
