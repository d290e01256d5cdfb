#include "coilwright/systems/rig/grasp_bench.hpp"

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/simulation/blocked_grasp.hpp"
#include "systems/check.hpp"
#include "systems/rig/models_of.hpp"

namespace coilwright::systems::rig {

std::vector<GraspBenchPoint> readings(const actuator::Design& design, const GraspBench& bench) {
  require_some(!bench.currents.empty(), "the currents");
  for (const double current : bench.currents) require(true, "current", "finite", current, "A");
  const auto models = models_of(design);
  std::vector<GraspBenchPoint> out;
  for (const double current : bench.currents) {
    const auto grasps = per_fidelity([&](magnetics::Fidelity fidelity) {
      const actuator::Model& model = models.of(fidelity);
      const auto grasp = simulation::blocked_grasp(model, model.all_coils(current), bench.grasp);
      if (!grasp) throw std::runtime_error(fmt::format("comes to rest nowhere on the wall at {:.6g} A", current));
      return *grasp;
    });
    const auto bending = [](const simulation::BlockedGrasp& grasp) {
      return actuator::Model::bending_angle(grasp.angles);
    };
    out.push_back({.current = current,
                   .force = {.line_of_centres = grasps.line_of_centres.force, .exact = grasps.exact.force},
                   .bending = {.line_of_centres = bending(grasps.line_of_centres), .exact = bending(grasps.exact)}});
  }
  return out;
}

}  // namespace coilwright::systems::rig
