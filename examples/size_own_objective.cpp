// Which finger grips hardest for its mass? Coilwright has no such quantity, so this program brings its own.
//
// Build  cmake --preset release && cmake --build --preset release --target example_size_own_objective
// Run    build/release/examples/size_own_objective
// Prints the best of 60 designs within a mass limit: its variables, its grasp force per mass, and how that compares
//        with the design from which the search started.

#include <cstddef>
#include <cstdio>
#include <exception>
#include <string_view>
#include <variant>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

namespace {

using namespace coilwright;

// The quantity: a name that ends in its unit, a line for people, an ordinary magnitude, and the value in that unit.
const simulation::ResultQuantity grip_per_mass = {
    .name = "grip_per_mass_N_kg",
    .meaning = "grasp force divided by the mass of the actuator",
    .scale = 15.0,
    .value = [](const simulation::DesignView& d) { return d.performance.cold.grasp_force / d.performance.mass; }};

// The study in code. From a file it is formats::read_study(path, {.quantities = table}): it may ask for the quantity,
// too.
sizing::Study study() {
  const simulation::QuantityTable table = simulation::standard_quantities().with(grip_per_mass);
  sizing::Study study;
  study.name = "grip per mass";
  study.current = sizing::ShareOfLimit{1.0};  // of the ampacity of the wire
  study.operating.duty = 0.5;
  const auto vary = [&study](std::string_view name, double lower, double upper) {
    study.variables.emplace_back(sizing::parameter_variable(name, sizing::Interval{.lower = lower, .upper = upper}));
  };
  vary("turns_radial", 10, 18);
  vary("magnet_length_mm", 4, 12);
  vary("gap_mm", 0.6, 1.5);
  study.objectives = {{.quantity = table.at("grip_per_mass_N_kg"), .sense = sizing::Sense::maximise}};
  study.limits = {{.quantity = table.at("mass_g"), .side = sizing::Limit::Side::at_most, .value = 70.0},
                  {.quantity = table.at("thermal_load"), .side = sizing::Limit::Side::at_most, .value = 1.0}};
  study.search.max_evaluations = 60;
  study.search.afterwards = sizing::Afterwards::nothing;
  study.quantities = table;
  return study;
}

}  // namespace

int main() {
  try {
    const sizing::DesignProblem problem(study());
    const sizing::SearchResult found = sizing::search(problem.problem(), problem.study().search);
    if (!found.feasible) {
      std::puts("no design keeps every limit");
      return 3;
    }
    for (std::size_t i = 0; i < found.best->point.size(); ++i)
      std::printf("%-20s %7.3f\n", sizing::name_of(problem.study().variables[i]).c_str(), found.best->point[i]);
    const auto base = std::get<sizing::EvaluatedDesign>(problem.evaluate_base());
    std::printf("%-20s %7.2f, from %.2f\n", grip_per_mass.name.c_str(), found.best->evaluation.objectives.front(),
                grip_per_mass.value(base.view()).value());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
