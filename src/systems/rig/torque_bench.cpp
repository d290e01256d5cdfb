#include "coilwright/systems/rig/torque_bench.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/dimensions.hpp"
#include "coilwright/units/angle.hpp"
#include "systems/check.hpp"
#include "systems/rig/models_of.hpp"

namespace coilwright::systems::rig {
namespace {

using actuator::Design;

constexpr double widest_angle = 120.0 * units::degree;  // where a design's torque curves end

void check(const TorqueBench& bench) {
  require(bench.axis_offset > 0.0, "axis offset", "finite and > 0", bench.axis_offset * 1e3, "mm");
  require(bench.gauge_distance > 0.0, "gauge distance", "finite and > 0", bench.gauge_distance * 1e3, "mm");
  require(bench.current != 0.0, "current", "finite and not 0", bench.current, "A");
  require_some(!bench.angles.empty(), "the angles");
  for (const double angle : bench.angles)
    require(angle >= 0.0 && angle <= widest_angle + rounding, "angle", "from 0 to 120 deg", angle / units::degree,
            "deg");
}

// The first two neighbours of which one is a coil and one a magnet. Every layout has some.
actuator::Layout first_pair(const actuator::Layout& layout) {
  for (std::size_t i = 0; i + 1 < layout.size(); ++i)
    if (layout[i].kind != layout[i + 1].kind) return {layout[i], layout[i + 1]};
  throw std::invalid_argument("layout must have a coil beside a magnet");
}

}  // namespace

TorqueBench paper_torque_bench(const Design& design) {
  TorqueBench bench{.axis_offset = actuator::dimensions(design).axis_offset + 2e-3};
  for (int step = 0; step < 12; ++step) bench.angles.push_back(step * 7.5 * units::degree);
  return bench;
}

Design rigid_counterpart(const Design& design, double axis_offset) {
  Design out = design;
  out.layout = first_pair(design.layout);
  out.coil.current_shares.fill(1.0);  // the bench drives its one coil
  out.calibration.axis_offset *= axis_offset / actuator::dimensions(design).axis_offset;
  out.as_built.torque_correction.reset();  // nobody knows whether magnets or hinges make it
  std::erase_if(out.effects, [](const actuator::Effect& effect) {
    const actuator::Stage stage = effect.kind->stage();
    return stage != actuator::Stage::drive && stage != actuator::Stage::magnetics;
  });
  return without_inapplicable_effects(std::move(out));
}

std::vector<TorqueBenchPoint> readings(const Design& design, const TorqueBench& bench) {
  check(bench);
  const Design joint = rigid_counterpart(design, bench.axis_offset);
  const auto models = models_of(joint);
  std::vector<TorqueBenchPoint> out;
  for (const double angle : bench.angles)
    out.push_back(
        {.angle = angle, .reading = per_fidelity([&](magnetics::Fidelity fidelity) {
                           const actuator::Model& model = models.of(fidelity);
                           const mechanics::JointVector at = mechanics::JointVector::Constant(1, angle);
                           const double torque = model.magnetic_torques(at, model.all_coils(bench.current))[0];
                           return TorqueReading{.torque = torque, .gauge_force = torque / bench.gauge_distance};
                         })});
  return out;
}

double mean_difference(const std::vector<TorqueBenchPoint>& points) {
  double sum = 0.0;
  for (const TorqueBenchPoint& point : points)
    sum += std::abs(point.reading.line_of_centres.torque - point.reading.exact.torque);
  return sum / static_cast<double>(points.size());
}

}  // namespace coilwright::systems::rig
