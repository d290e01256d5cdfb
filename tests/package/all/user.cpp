// Evaluates the prototype through the installed headers: 0 if its steady angle is the known one.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <variant>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/simulation/performance.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  using namespace coilwright;
  const formats::ActuatorFile file = formats::read_actuator(argv[1]);
  const actuator::Design& design = std::get<actuator::Design>(file.content);
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  const auto result = simulation::performance_of(design, assembly, {.current = 1.4});
  const auto& motion = std::get<simulation::Performance>(result).cold;
  const double angle = motion.steady_angles.sum() * 180.0 / std::numbers::pi;
  std::printf("steady angle %.2f deg\n", angle);
  return std::abs(angle - 63.62) < 0.01 ? 0 : 1;  // the errata's figure, to its last digit
}
