#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/exports/subject.hpp"
#include "coilwright/page/page.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/simulation/heating.hpp"
#include "coilwright/simulation/step_motion.hpp"

namespace coilwright::page {

/// The straight body with its dimensions, as `export --as drawing` has it.
[[nodiscard]] Figure section_figure(const simulation::EvaluatedDesign& evaluated, const exports::Origin& origin);

/// Longitudinal sections to one scale: at rest, bent by the operating point's current, and where the step to it is
/// farthest. Without a motion at its temperatures: as cold, and without the last.
[[nodiscard]] std::vector<Figure> pose_figures_of(const simulation::EvaluatedDesign& evaluated,
                                                  const std::optional<simulation::StepMotion>& motion);

/// Bending angle and joint angles of the step over time, with where it ends.
[[nodiscard]] Figure response_figure(const simulation::EvaluatedDesign& evaluated,
                                     const simulation::StepMotion& motion);

/// Rate of the bending angle over time.
[[nodiscard]] Figure speed_figure(const simulation::StepMotion& motion);

/// Torque of coil and magnet at each joint over its angle, beside what the silicone of that joint holds against it, at
/// 20 degC. Joints of the same torque share a curve.
[[nodiscard]] Figure torque_figure(const simulation::EvaluatedDesign& evaluated);

/// Force between the first coil and its magnet side by side over the gap between their faces, at 20 degC.
[[nodiscard]] Figure force_figure(const simulation::EvaluatedDesign& evaluated);

/// Temperature of every coil and magnet over time, with their limits.
[[nodiscard]] Figure temperature_figure(const simulation::EvaluatedDesign& evaluated,
                                        const simulation::Heating& heating);

/// How long a step is worth showing, s: until it has settled and a little on, 3 s at most.
[[nodiscard]] double shown_duration(const simulation::EvaluatedDesign& evaluated);

/// All of them, as sections "The design", "Response", "Torque and force", "Temperature".
[[nodiscard]] std::vector<Section> design_sections(const simulation::EvaluatedDesign& evaluated,
                                                   const exports::Origin& origin);

}  // namespace coilwright::page
