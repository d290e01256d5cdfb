#include "coilwright/simulation/shut_joints.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/pressed_joints.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Component;
using actuator::ComponentKind;
using actuator::Design;
using actuator::Layout;
using Of = OpeningChange::Of;

constexpr Component coil{.kind = ComponentKind::coil};
constexpr Component magnet{.kind = ComponentKind::magnet};

Design of_row(Layout layout) {
  Design out;
  out.layout = std::move(layout);
  return out;
}

struct HeldRow {
  Design design;
  double current;
};

// Rows of other lengths, sizes and silicones whose magnets hold joints shut.
std::vector<HeldRow> held_rows() {
  std::vector<HeldRow> out{{of_row({coil, magnet, coil, magnet, coil}), 0.5},
                           {of_row({coil, magnet, coil, coil, magnet, coil}), 0.5},
                           {of_row({coil, magnet, coil, magnet, coil, magnet, coil}), 0.8},
                           {of_row({magnet, coil, magnet}), 0.4}};
  Design small = of_row({coil, magnet, coil, magnet, coil});
  small.coil.turns_radial = 10;
  small.coil.turns_axial = 20;
  small.magnet.radius = 7e-3;
  small.magnet.length = 8e-3;
  small.body.gap = 1.2e-3;
  small.choices.torque = magnetics::Fidelity::line_of_centres;
  out.push_back({small, 0.2});
  return out;
}

std::vector<int> shut(const EvaluatedDesign& design) {
  return pressed_joints(design.assembly.model, design.performance.free.motion->steady_angles);
}

TEST(ShutJoints, AreHeldByTheForceOfTheMagnetsOnTheirSides) {
  for (const HeldRow& each : held_rows()) {
    const EvaluatedDesign taken = evaluate(each.design, {.current = each.current});
    const std::string text = what_shuts_joints(taken.view());
    ASSERT_FALSE(shut(taken).empty());
    // The distance of the first two magnets of a straight row, by the lengths of the parts between them.
    const Layout& row = each.design.layout;
    const auto first = std::ranges::find(row, ComponentKind::magnet, &Component::kind);
    const auto second = std::find_if(first + 1, row.end(), [](const auto& part) { return part == magnet; });
    const auto coils = static_cast<double>(second - first - 1);
    const actuator::Dimensions& size = taken.assembly.dimensions;
    const double distance = 2.0 * (size.magnet_half_pitch + coils * size.coil_half_pitch);
    const magnetics::CylinderMagnet body = each.design.magnet.cylinder();
    const double force = -magnetics::axial_force(body, body, distance);
    const auto at = text.find("attract each other through");
    ASSERT_NE(at, std::string::npos) << text;
    const double said = std::stod(text.substr(text.find(" with ", at) + 6));
    EXPECT_NEAR(said, force, 0.02 * force) << text;  // three digits, and joints closed by some hundredths of a degree
    EXPECT_NE(text.find(fmt::format("a coil gives its magnet {:.3g} N at {:.3g} A",
                                    std::abs(taken.performance.axial_force), each.current)),
              std::string::npos)
        << text;
    const std::vector<PartLimit> limits = part_limits(taken.view());
    for (const PartLimit& limit : told(limits, taken.view())) {
      if (limit.quantity == "smallest_joint_angle_deg") {
        EXPECT_TRUE(limit.consequence.ends_with("; " + text));
        // What no text needs is not worked out: the torques of every pair of bodies.
        EXPECT_EQ(std::ranges::find(limits, limit.quantity, &PartLimit::quantity)->consequence + "; " + text,
                  limit.consequence);
      }
    }
  }
}

TEST(ShutJoints, OpenByEveryChangeThatIsSaidToOpenThem) {
  for (const HeldRow& each : held_rows()) {
    const EvaluatedDesign taken = evaluate(each.design, {.current = each.current});
    const std::vector<OpeningChange> changes = what_opens_joints(taken.view());
    EXPECT_FALSE(changes.empty());
    for (const OpeningChange& change : changes) {
      // Built anew by what it names.
      Design design = each.design;
      design.layout = change.result.design.layout;
      const EvaluatedDesign again = evaluate(design, {.current = change.result.point.current});
      EXPECT_TRUE(shut(again).empty());
      EXPECT_EQ(again.performance.cold.rest_angles, change.result.performance.cold.rest_angles);
      EXPECT_EQ(change.of == Of::current, again.point.current != each.current);
      EXPECT_EQ(change.of == Of::row, design.layout.size() != each.design.layout.size());
      EXPECT_EQ(change.of == Of::polarity, !change.parts.empty());
    }
  }
}

TEST(ShutJoints, AreClosedByACoilOrByWeightToo) {
  const EvaluatedDesign backwards = evaluate(of_row({coil, magnet, coil}), {.current = -1.0});
  EXPECT_TRUE(what_shuts_joints(backwards.view()).starts_with("coil 1 and magnet 1 attract each other with "));
  const std::vector<OpeningChange> changes = what_opens_joints(backwards.view());
  EXPECT_TRUE(std::ranges::any_of(changes, [](const OpeningChange& change) {
    return change.of == Of::current && change.result.point.current == 1.0;
  }));

  // It leans back, and falls shut without current.
  Design upright = of_row({coil, magnet, coil});
  upright.surroundings.base_tilt = 120.0 * std::numbers::pi / 180.0;
  const EvaluatedDesign at_rest = evaluate(upright, {.current = 1.0});
  ASSERT_FALSE(pressed_joints(at_rest.assembly.model, at_rest.performance.cold.rest_angles).empty());
  EXPECT_EQ(what_shuts_joints(at_rest.view()), "weight closes them");
}

TEST(ShutJoints, AreNotSaidOfAFingerWhoseJointsAreOpen) {
  const EvaluatedDesign open = evaluate(of_row({coil, magnet, coil}), {.current = 0.5});
  EXPECT_EQ(what_shuts_joints(open.view()), "");
  EXPECT_TRUE(what_opens_joints(open.view()).empty());
  const auto stroke = standard_quantities().at("smallest_joint_stroke_deg").value(open.view());
  const FreeMotion& motion = *open.performance.free.motion;
  const mechanics::JointVector change = motion.steady_angles - motion.rest_angles;
  EXPECT_NEAR(*stroke, std::min(change[0], change[1]) * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_GT(*stroke, 5.0);
  const EvaluatedDesign dead = evaluate(held_rows().front().design, {.current = 0.5});
  EXPECT_NEAR(*standard_quantities().at("smallest_joint_stroke_deg").value(dead.view()), 0.0, 0.05);
}

}  // namespace
}  // namespace coilwright::simulation
