// How far does a finger bend, how fast is it, and how hard does it grip; and what does a smaller gap change?
//
// Build  cmake --preset release && cmake --build --preset release --target example_evaluate_design
// Run    build/release/examples/evaluate_design [ACTUATOR.json]
//        Default: configs/actuators/paper_finger.json, counted from the folder in which it is run.
// Prints bending angle, peak bending speed and grasp force at 1.4 A, for the actuator as its file has it and with a
//        gap of 0.6 mm between coils and magnets.

#include <cstdio>
#include <exception>
#include <string>
#include <variant>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace {

using namespace coilwright;

void print(const std::string& title, const actuator::Design& design) {
  const simulation::EvaluatedDesign evaluated = simulation::evaluate(design, {.current = 1.4});
  std::printf("%s\n", title.c_str());
  for (const char* name : {"steady_angle_deg", "peak_bending_speed_deg_s", "grasp_force_N"}) {
    const simulation::ResultQuantity& quantity = simulation::standard_quantities().at(name);
    std::printf("  %-24s %8.2f\n", name, quantity.value(evaluated.view()).value());
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const formats::ActuatorFile file =
        formats::read_actuator(argc > 1 ? argv[1] : "configs/actuators/paper_finger.json");
    actuator::Design design = std::get<actuator::Design>(file.content);  // the other kind of file is a lumped model
    print(file.name, design);
    design.body.gap = 0.6e-3;  // in memory all numbers are SI
    print(file.name + " with a gap of 0.6 mm", design);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
