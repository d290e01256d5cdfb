// The loops that figures.py writes in Python, in C++: seconds of processor time of `count` forces of a pair, or of
// `count` evaluations of an actuator.
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace {

using namespace coilwright;

double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double forces(const std::string& path, int count) {
  const formats::PairFile file = formats::read_pair(path);
  const auto& coil = std::get<magnetics::DrivenCoil>(file.bodies[0].part);
  const auto& body = std::get<magnetics::Magnet>(file.bodies[1].part);
  const auto& shape = std::get<magnetics::Ring>(body.shape);
  const magnetics::CylinderMagnet magnet(
      {.radius = shape.outer_radius, .length = shape.length, .remanence = body.remanence.z()});
  std::vector<magnetics::Wrench> out(static_cast<std::size_t>(count));
  const double begin = seconds();
  for (int i = 0; i < count; ++i)
    out[static_cast<std::size_t>(i)] = magnetics::wrench(
        coil.coil, coil.current, magnet,
        {.position = {1e-3 * (i % 7), 1e-3 * (i % 5), 1e-3 * (14 + i % 11)}, .axis = {0.3, -0.1, 0.9}});
  return seconds() - begin;
}

double evaluations(const std::string& path, int count) {
  const formats::ActuatorFile file = formats::read_actuator(path);
  const auto& design = std::get<actuator::Design>(file.content);
  double sum = 0.0;
  const double begin = seconds();
  for (int i = 0; i < count; ++i) {
    actuator::Design changed = design;
    changed.body.gap = 0.9e-3 + 1e-7 * (i % 1000);
    sum += simulation::evaluate(std::move(changed), {.current = 1.4}).performance.cold.peak_bending_speed;
  }
  if (!(sum > 0.0)) std::puts("no speed");
  return seconds() - begin;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  try {
    const bool of_force = std::string_view(argv[1]) == "force";
    std::printf("%.6f\n", (of_force ? forces : evaluations)(argv[2], std::stoi(argv[3])));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
