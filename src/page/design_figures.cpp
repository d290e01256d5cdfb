#include "coilwright/page/design_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "coilwright/exports/body_plan.hpp"
#include "coilwright/exports/kinds.hpp"
#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/page/chart.hpp"
#include "coilwright/page/poses.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::page {
namespace {

using actuator::HingePair;
using mechanics::JointVector;
using simulation::EvaluatedDesign;
using simulation::StepMotion;

constexpr std::size_t response_samples = 601;
constexpr std::size_t heating_samples = 121;
constexpr std::size_t torque_samples = 91;

const simulation::FreeMotion& motion_of(const EvaluatedDesign& evaluated) {
  return evaluated.performance.free.motion ? *evaluated.performance.free.motion : evaluated.performance.cold;
}

std::vector<double> bending_angles(const StepMotion& motion) {
  std::vector<double> angles;
  for (const simulation::State& state : motion.states) angles.push_back(state.angles.sum() * units::degrees_per_radian);
  return angles;
}

// "1", "1 and 2": joints from 1.
std::string joints_text(const std::vector<int>& joints) {
  std::vector<int> shown;
  for (const int joint : joints) shown.push_back(joint + 1);
  return fmt::format("{} {}", joints.size() == 1 ? "joint" : "joints", fmt::join(shown, " and "));
}

// Curves of the joints, those that are the same to the bit under one name.
void add_joint_series(Chart& chart, std::string_view what, const std::vector<double>& angles,
                      const std::vector<std::vector<double>>& of_joints) {
  std::vector<bool> done(of_joints.size(), false);
  for (std::size_t i = 0; i < of_joints.size(); ++i) {
    if (done[i] || of_joints[i].empty()) continue;
    std::vector<int> joints;
    for (std::size_t j = i; j < of_joints.size(); ++j) {
      if (of_joints[j] != of_joints[i]) continue;
      done[j] = true;
      joints.push_back(static_cast<int>(j));
    }
    chart.series.push_back({.name = fmt::format("{}, {}", what, joints_text(joints)), .x = angles, .y = of_joints[i]});
  }
}

std::string part_name(const EvaluatedDesign& evaluated, std::size_t i) {
  const bool magnet = evaluated.design.layout[i].kind == actuator::ComponentKind::magnet;
  return fmt::format("{} at place {}", magnet ? "magnet" : "coil", i + 1);
}

}  // namespace

Figure section_figure(const EvaluatedDesign& evaluated, const exports::Origin& origin) {
  const exports::DesignSubject subject{.origin = origin, .design = evaluated.design, .assembly = evaluated.assembly};
  return {.id = "section",
          .title = "Dimensions of the straight body",
          .description = "Longitudinal section and cross-sections through a coil and a magnet, lengths in mm.",
          .content = Image{exports::drawing(subject, {}).front().text}};
}

std::vector<Figure> pose_figures_of(const EvaluatedDesign& evaluated, const std::optional<StepMotion>& motion) {
  const exports::BodyPlan plan =
      exports::body_plan({.origin = {}, .design = evaluated.design, .assembly = evaluated.assembly});
  const simulation::FreeMotion& free = motion_of(evaluated);
  const std::string current = fmt::format("{:.4g} A", evaluated.point.current);
  std::vector<Pose> poses{{.id = "rest", .title = "at rest, without current", .angles = free.rest_angles},
                          {.id = "bent", .title = "bent, held at " + current, .angles = free.steady_angles}};
  if (motion) {
    const std::size_t peak = simulation::peak_of(*motion);
    poses.push_back({.id = "peak",
                     .title = fmt::format("farthest in the step to {}, after {:.3g} s", current, motion->times[peak]),
                     .angles = motion->states[peak].angles});
  }
  return pose_figures(plan, poses, evaluated.design.surroundings.base_tilt);
}

Figure response_figure(const EvaluatedDesign& evaluated, const StepMotion& motion) {
  Chart chart{.id = "response",
              .title = "Angle after a step of the current",
              .description = {},
              .x_title = "time, s",
              .y_title = "angle, deg",
              .series = {{.name = "bending angle", .x = motion.times, .y = bending_angles(motion)}}};
  for (Eigen::Index joint = 0; joint < motion.states.front().angles.size(); ++joint) {
    Series series{.name = fmt::format("joint {}", joint + 1), .x = motion.times};
    for (const simulation::State& state : motion.states)
      series.y.push_back(state.angles[joint] * units::degrees_per_radian);
    chart.series.push_back(std::move(series));
  }
  const simulation::FreeMotion& free = motion_of(evaluated);
  chart.series.push_back({.name = "bending angle in the end",
                          .y = {free.steady_angles.sum() * units::degrees_per_radian},
                          .mark = Mark::level});
  chart.description = fmt::format(
      "From rest at {:.1f} deg the current steps to {:.4g} A; the bending angle reaches {:.1f} deg at most and ends at "
      "{:.1f} deg. Magnets are as warm as holding that current makes them.",
      free.rest_angles.sum() * units::degrees_per_radian, evaluated.point.current,
      free.peak_angle * units::degrees_per_radian, free.steady_angles.sum() * units::degrees_per_radian);
  return figure_of(chart);
}

Figure speed_figure(const StepMotion& motion) {
  Series series{.name = "rate of the bending angle", .x = motion.times};
  double fastest = 0.0;
  for (const simulation::State& state : motion.states) {
    series.y.push_back(state.rates.sum() * units::degrees_per_radian);
    fastest = std::max(fastest, std::abs(series.y.back()));
  }
  return figure_of(
      Chart{.id = "speed",
            .title = "Speed after a step of the current",
            .description = fmt::format("Rate of the bending angle; the largest one shown is {:.4g} deg/s.", fastest),
            .x_title = "time, s",
            .y_title = "rate, deg/s",
            .series = {std::move(series)}});
}

Figure torque_figure(const EvaluatedDesign& evaluated) {
  const actuator::Model& model = evaluated.assembly.model;
  const double widest = std::max(motion_of(evaluated).peak_joint_angle + 0.2, 0.6);
  double lower = 0.0;
  double upper = widest;
  for (const HingePair& pair : model.magnetics().hinge_pairs()) {
    lower = std::max(lower, pair.torque_per_ampere->lower());
    upper = std::min(upper, pair.torque_per_ampere->upper());
  }
  const actuator::CoilCurrents currents = model.all_coils(evaluated.point.current);
  std::vector<double> angles;
  const auto joints = static_cast<std::size_t>(model.joints());
  std::vector<std::vector<double>> drive(joints);
  std::vector<std::vector<double>> hold(joints);
  for (std::size_t i = 0; i < torque_samples; ++i) {
    const double angle = lower + (upper - lower) * static_cast<double>(i) / static_cast<double>(torque_samples - 1);
    angles.push_back(angle * units::degrees_per_radian);
    const JointVector hinges = model.hinge_torques(JointVector::Constant(model.joints(), angle));
    std::vector<double> sums(joints, 0.0);
    for (const HingePair& pair : model.magnetics().hinge_pairs())
      sums[static_cast<std::size_t>(pair.joint)] +=
          1e3 * pair.sense * currents[pair.coil] * pair.torque_per_ampere->value(angle);
    for (std::size_t j = 0; j < joints; ++j) hold[j].push_back(-1e3 * hinges[static_cast<Eigen::Index>(j)]);
    for (const HingePair& pair : model.magnetics().hinge_pairs()) {
      std::vector<double>& curve = drive[static_cast<std::size_t>(pair.joint)];
      if (curve.size() <= i) curve.push_back(sums[static_cast<std::size_t>(pair.joint)]);
    }
  }
  Chart chart{
      .id = "torque",
      .title = "Torque of each joint over its angle",
      .description = fmt::format("Torque of the coil and the magnet next to a joint at {:.4g} A and 20 degC, and what "
                                 "the silicone there holds against it. Gravity and magnets further along add to both.",
                                 evaluated.point.current),
      .x_title = "angle of the joint, deg",
      .y_title = "torque, N mm"};
  add_joint_series(chart, "coil and magnet", angles, drive);
  add_joint_series(chart, "silicone", angles, hold);
  return figure_of(chart);
}

Figure force_figure(const EvaluatedDesign& evaluated) {
  const actuator::HingePairParts::Spec& pair = evaluated.assembly.model.magnetics().hinge_pairs().front().parts->spec();
  const actuator::Dimensions& size = evaluated.assembly.dimensions;
  const double faces = 0.5 * (size.coil_length + evaluated.design.magnet.length);
  const double rest_gap = evaluated.design.body.gap;
  std::vector<double> gaps{rest_gap};
  for (int i = 0; i <= 60; ++i) gaps.push_back(20e-3 * i / 60.0);
  std::ranges::sort(gaps);
  std::vector<double> distances;
  for (const double gap : gaps) distances.push_back(faces + gap);
  std::vector<double> forces(gaps.size());
  magnetics::axial_force_per_ampere(pair.coil, pair.magnet, distances, forces);
  // The force at the rest gap is known with its sense: which way the pair is built in is not looked at twice.
  const auto rest = static_cast<std::size_t>(std::ranges::find(gaps, rest_gap) - gaps.begin());
  const double sense = std::copysign(1.0, evaluated.assembly.rest_force_per_ampere * forces[rest]);
  Series series{.name = "coil on magnet"};
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    series.x.push_back(1e3 * gaps[i]);
    series.y.push_back(sense * evaluated.point.current * forces[i]);
  }
  const double at_rest = series.y[rest];
  Series own{.name = "at the gap of this design", .x = {1e3 * rest_gap}, .y = {at_rest}, .mark = Mark::points};
  return figure_of(Chart{
      .id = "force",
      .title = "Force between a coil and its magnet over their gap",
      .description = fmt::format(
          "Straight in line, at {:.4g} A and 20 degC; positive is repulsion. At the gap of {:.4g} mm it is {:.4g} N.",
          evaluated.point.current, 1e3 * rest_gap, at_rest),
      .x_title = "gap between the faces, mm",
      .y_title = "force, N",
      .series = {std::move(series), std::move(own)}});
}

Figure temperature_figure(const EvaluatedDesign& evaluated, const simulation::Heating& heating) {
  Chart chart{
      .id = "temperature",
      .title = "Temperature over time",
      .description = fmt::format("Means of every coil and magnet from {:.4g} degC on, with {:.4g} A for {:.4g} of the "
                                 "time, at the angles where the free finger ends; a limit of a temperature counts the "
                                 "hottest of the poses that are held (cases of the operating point). {}",
                                 evaluated.design.surroundings.ambient, evaluated.point.current, evaluated.point.duty,
                                 heating.runaway ? "There is no steady state: it runs away." : ""),
      .x_title = "time, s",
      .y_title = "temperature, degC",
      .x_scale = AxisScale::logarithmic};
  for (std::size_t part = 0; part < evaluated.design.layout.size(); ++part) {
    Series series{.name = part_name(evaluated, part)};
    for (std::size_t i = 1; i < heating.times.size(); ++i) {
      series.x.push_back(heating.times[i]);
      series.y.push_back(heating.means[i][static_cast<Eigen::Index>(part)]);
    }
    chart.series.push_back(std::move(series));
  }
  const auto components = static_cast<Eigen::Index>(evaluated.design.layout.size());
  Eigen::Index hottest = 0;
  for (Eigen::Index i = 0; i < components; ++i)
    if (heating.hot_spots.back()[i] > heating.hot_spots.back()[hottest]) hottest = i;
  Series spot{.name = "hottest turn"};
  for (std::size_t i = 1; i < heating.times.size(); ++i) {
    spot.x.push_back(heating.times[i]);
    spot.y.push_back(heating.hot_spots[i][hottest]);
  }
  chart.series.push_back(std::move(spot));
  chart.series.push_back(
      {.name = "limit of the enamel", .y = {evaluated.design.surroundings.coil_limit}, .mark = Mark::level});
  chart.series.push_back(
      {.name = "limit of the magnets", .y = {evaluated.design.magnet.temperature_limit}, .mark = Mark::level});
  return figure_of(chart);
}

double shown_duration(const EvaluatedDesign& evaluated) {
  const std::optional<double>& settling = motion_of(evaluated).settling_time;
  return settling ? std::clamp(1.2 * *settling, 0.1, 3.0) : 1.0;
}

std::vector<Section> design_sections(const EvaluatedDesign& evaluated, const exports::Origin& origin) {
  const std::optional<StepMotion> motion =
      simulation::step_motion(evaluated, shown_duration(evaluated), response_samples);
  Section poses{.id = "design", .title = "The design"};
  poses.blocks.push_back(Widget{"<div class=\"poses\">\n"});
  for (Figure& figure : pose_figures_of(evaluated, motion)) poses.blocks.emplace_back(std::move(figure));
  poses.blocks.push_back(Widget{"</div>\n"});
  poses.blocks.emplace_back(section_figure(evaluated, origin));
  Section response{.id = "motion", .title = "Response over time"};
  if (motion) {
    response.blocks.emplace_back(response_figure(evaluated, *motion));
    response.blocks.emplace_back(speed_figure(*motion));
  } else {
    response.blocks.emplace_back(Lines{"At its operating point it runs away in heat: there is no motion to show."});
  }
  Section torque{.id = "torques", .title = "Torque and force"};
  torque.blocks.emplace_back(torque_figure(evaluated));
  torque.blocks.emplace_back(force_figure(evaluated));
  Section heat{.id = "heat", .title = "Temperature"};
  heat.blocks.emplace_back(temperature_figure(evaluated, simulation::heating(evaluated, heating_samples)));
  return {std::move(poses), std::move(response), std::move(torque), std::move(heat)};
}

}  // namespace coilwright::page
