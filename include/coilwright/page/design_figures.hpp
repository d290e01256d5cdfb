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

/// The straight body with its dimensions, as `export --as drawing` draws it.
[[nodiscard]] Figure section_figure(const simulation::EvaluatedDesign& evaluated, const exports::Origin& origin);

/// Longitudinal sections to one scale: at rest, bent by the operating point's current, and at the largest angle of the
/// step to it. If there is no motion at its temperatures, the cold poses without the last.
[[nodiscard]] std::vector<Figure> pose_figures_of(const simulation::EvaluatedDesign& evaluated,
                                                  const std::optional<simulation::StepMotion>& motion);

/// Bending angle and joint angles of the step over time, with their final values.
[[nodiscard]] Figure response_figure(const simulation::EvaluatedDesign& evaluated,
                                     const simulation::StepMotion& motion);

/// Rate of the bending angle over time.
[[nodiscard]] Figure speed_figure(const simulation::StepMotion& motion);

/// Torque of coil and magnet at each joint over its angle, beside the torque with which the silicone of that joint
/// resists, at 20 degC. Joints of the same torque share a curve.
[[nodiscard]] Figure torque_figure(const simulation::EvaluatedDesign& evaluated);

/// Force between the first coil and its magnet, coaxial, over the gap between their faces, at 20 degC.
[[nodiscard]] Figure force_figure(const simulation::EvaluatedDesign& evaluated);

/// Temperature of every coil and magnet over time, with their limits.
[[nodiscard]] Figure temperature_figure(const simulation::EvaluatedDesign& evaluated,
                                        const simulation::Heating& heating);

/// Duration of the step that a figure shows, s: a little more than the settling time, at most 3 s.
[[nodiscard]] double shown_duration(const simulation::EvaluatedDesign& evaluated);

/// The figures above as the sections "The design", "Response", "Torque and force" and "Temperature".
[[nodiscard]] std::vector<Section> design_sections(const simulation::EvaluatedDesign& evaluated,
                                                   const exports::Origin& origin);

}  // namespace coilwright::page
