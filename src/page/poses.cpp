#include "coilwright/page/poses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "coilwright/text/markup.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::page {
namespace {

using actuator::ComponentKind;
using exports::BodyPlan;
using exports::PlacedPart;
using mechanics::JointVector;

constexpr double edge = 4.0;         // mm around a body
constexpr double bar_length = 10.0;  // mm

double mm(double length) {
  return 1e3 * length;
}

// A rectangle of the straight body in the picture's axes: the body's height to the right, its length downwards.
std::string rectangle(const char* part, double along, double length, double up, double height) {
  return fmt::format("<rect class=\"{}\" x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\"/>\n", part,
                     mm(up), mm(along), mm(height), mm(length));
}

std::string letter(double along, double up, const char* pole) {
  return fmt::format("<text class=\"pole\" x=\"{:.3f}\" y=\"{:.3f}\" dy=\"0.35em\">{}</text>\n", mm(up), mm(along),
                     pole);
}

std::string part_svg(const BodyPlan& plan, const PlacedPart& part) {
  const double start = part.centre - 0.5 * part.length;
  if (part.component.kind == ComponentKind::magnet) {
    const bool north_to_tip = part.component.polarity > 0;
    return rectangle("magnet", start, part.length, plan.axis_height - part.radius, 2.0 * part.radius) +
           letter(part.centre - 0.25 * part.length, plan.axis_height, north_to_tip ? "S" : "N") +
           letter(part.centre + 0.25 * part.length, plan.axis_height, north_to_tip ? "N" : "S");
  }
  const double wall = part.radius - part.inner_radius;
  return rectangle("winding", start, part.length, plan.axis_height - part.radius, wall) +
         rectangle("winding", start, part.length, plan.axis_height + part.inner_radius, wall);
}

// Segment `i` with everything beyond it, which turns about its joint.
std::string segments_from(const BodyPlan& plan, const JointVector& angles, std::size_t i) {
  const double start = i == 0 ? 0.0 : plan.joints[i - 1];
  const double end = i < plan.joints.size() ? plan.joints[i] : plan.length;
  std::string out = rectangle("body", start, end - start, 0.0, plan.height) +
                    rectangle("layer", start, end - start, 0.0, plan.bottom_layer) + part_svg(plan, plan.parts[i]);
  if (i >= plan.joints.size()) return out;
  return out + fmt::format("<g transform=\"rotate({:.4f} {:.3f} {:.3f})\">\n{}</g>\n",
                           angles[static_cast<Eigen::Index>(i)] * units::degrees_per_radian, mm(plan.hinge_height),
                           mm(end), segments_from(plan, angles, i + 1));
}

PosedPoint turned(const PosedPoint& point, double angle, const PosedPoint& about) {
  const double right = point.right - about.right;
  const double down = point.down - about.down;
  return {.right = about.right + std::cos(angle) * right - std::sin(angle) * down,
          .down = about.down + std::sin(angle) * right + std::cos(angle) * down};
}

struct Box {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;  // mm

  void take(const PosedPoint& point) {
    left = std::min(left, mm(point.right));
    right = std::max(right, mm(point.right));
    top = std::min(top, mm(point.down));
    bottom = std::max(bottom, mm(point.down));
  }
};

// Of all poses together, so that each is drawn in a frame of the same size.
Box box_of(const BodyPlan& plan, const std::vector<Pose>& poses, double base_tilt) {
  Box box;
  std::vector<double> places{0.0, plan.length};
  for (const double joint : plan.joints) places.insert(places.end(), {joint - 1e-9, joint + 1e-9});
  for (const Pose& pose : poses)
    for (const double along : places)
      for (const double up : {0.0, plan.height}) box.take(posed(plan, pose.angles, base_tilt, along, up));
  return box;
}

std::string angles_text(const JointVector& angles) {
  std::vector<std::string> each;
  for (const double angle : angles) each.push_back(fmt::format("{:.1f}", angle * units::degrees_per_radian));
  return fmt::format("joint angles {} deg, bending angle {:.1f} deg", fmt::join(each, ", "),
                     angles.sum() * units::degrees_per_radian);
}

}  // namespace

PosedPoint posed(const BodyPlan& plan, const JointVector& angles, double base_tilt, double along, double up) {
  PosedPoint point{.right = up, .down = along};
  for (std::size_t i = plan.joints.size(); i-- > 0;)
    if (along > plan.joints[i])
      point = turned(point, angles[static_cast<Eigen::Index>(i)], {.right = plan.hinge_height, .down = plan.joints[i]});
  return turned(point, base_tilt, {});
}

std::vector<Figure> pose_figures(const BodyPlan& plan, const std::vector<Pose>& poses, double base_tilt) {
  for (const Pose& pose : poses)
    if (static_cast<std::size_t>(pose.angles.size()) != plan.joints.size())
      throw std::invalid_argument(
          fmt::format("pose {} must have {} joint angles; got {}", pose.id, plan.joints.size(), pose.angles.size()));
  const Box box = box_of(plan, poses, base_tilt);
  std::vector<Figure> figures;
  for (const Pose& pose : poses) {
    const std::string said = fmt::format("Longitudinal section {}: {}.", pose.title, angles_text(pose.angles));
    const double width = box.right - box.left + 2.0 * edge;
    const double height = box.bottom - box.top + 3.0 * edge;
    std::string svg = fmt::format(
        "<svg class=\"pose\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.3f} {:.3f} {:.3f} {:.3f}\" role=\"img\" "
        "aria-label=\"{}\">\n",
        box.left - edge, box.top - edge, width, height, text::escaped(said));
    svg += fmt::format("<line class=\"wall\" x1=\"{:.3f}\" y1=\"{:.3f}\" x2=\"{:.3f}\" y2=\"{:.3f}\"/>\n", -0.5 * edge,
                       0.0, mm(plan.height) + 0.5 * edge, 0.0);
    svg += fmt::format("<g transform=\"rotate({:.4f})\">\n{}</g>\n", base_tilt * units::degrees_per_radian,
                       segments_from(plan, pose.angles, 0));
    const double row = box.bottom + 1.2 * edge;
    const double start = box.left;
    svg += fmt::format(
        "<path class=\"scale\" d=\"M{0:.3f} {1:.3f}v2m0 -1h{2:.0f}m0 -1v2\"/>\n<text class=\"scale-text\" "
        "x=\"{3:.3f}\" y=\"{4:.3f}\">10 mm</text>\n</svg>\n",
        start, row - 1.0, bar_length, start + bar_length + 1.5, row + 1.0);
    figures.push_back(
        {.id = "pose-" + pose.id, .title = pose.title, .description = said, .content = Drawing{std::move(svg)}});
  }
  return figures;
}

}  // namespace coilwright::page
