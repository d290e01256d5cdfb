#include "coilwright/page/design_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::page {
namespace {

simulation::EvaluatedDesign finger() {
  return simulation::evaluate(actuator::paper_finger(), {.current = 1.1, .duty = 0.7});
}

struct Curve {
  std::vector<double> x;
  std::vector<double> y;
};

// A series of a figure, as its specification has it.
Curve series_of(const Figure& figure, const std::string& name) {
  const text::Document document = text::parse_json(std::get<text::Json>(figure.content).text(), "spec");
  for (const text::Node& row : document.root().find("data").value().find("values").value().elements())
    if (row.find("series").value().text() == name)
      return {.x = row.find("x").value().numbers(), .y = row.find("y").value().numbers()};
  ADD_FAILURE() << "no series " << name;
  return {};
}

// Where the torque of the magnets and what holds against it meet, gravity apart, the model's own static residual is
// that of gravity: here by Model::torques, a route that the figure does not take.
TEST(DesignFigures, ShowTheTorquesOfTheModel) {
  const simulation::EvaluatedDesign design = finger();
  const Figure figure = torque_figure(design);
  const Curve drive = series_of(figure, "coil and magnet, joints 1 and 2");
  const Curve hold = series_of(figure, "silicone, joints 1 and 2");
  const actuator::Model& model = design.assembly.model;
  for (const std::size_t i : {std::size_t{5}, std::size_t{40}, std::size_t{80}}) {
    const double angle = drive.x[i] * std::numbers::pi / 180.0;
    const auto both = model.torques(mechanics::JointVector::Constant(2, angle), mechanics::JointVector::Zero(2),
                                    model.all_coils(1.1));
    EXPECT_NEAR(drive.y[i] - hold.y[i], 1e3 * both[0], 1e-9);
    EXPECT_NEAR(drive.y[i] - hold.y[i], 1e3 * both[1], 1e-9);
  }
}

// The force at the design's own gap is what Performance states, which repels.
TEST(DesignFigures, ShowTheForceAtTheGapOfTheDesign) {
  const simulation::EvaluatedDesign design = finger();
  const Curve point = series_of(force_figure(design), "at the gap of this design");
  ASSERT_EQ(point.y.size(), 1U);
  EXPECT_NEAR(point.x[0], 1e3 * design.design.body.gap, 1e-12);
  EXPECT_NEAR(point.y[0], design.performance.axial_force, 1e-9 * design.performance.axial_force);
  EXPECT_GT(point.y[0], 0.0);
}

TEST(DesignFigures, StartAtRestAndEndAtTheSteadyAngle) {
  const simulation::EvaluatedDesign design = finger();
  const auto motion = simulation::step_motion(design, shown_duration(design), 400).value();
  const Curve bending = series_of(response_figure(design, motion), "bending angle");
  const double degrees = 180.0 / std::numbers::pi;
  EXPECT_NEAR(bending.y.front(), design.performance.free.motion->rest_angles.sum() * degrees, 1e-9);
  EXPECT_NEAR(bending.y.back(), design.performance.free.motion->steady_angles.sum() * degrees, 1.0);
  EXPECT_NEAR(std::ranges::max(bending.y), design.performance.free.motion->peak_angle * degrees, 0.02);
}

TEST(DesignFigures, ShowEveryPartWarmingUp) {
  const simulation::EvaluatedDesign design = finger();
  const Figure figure = temperature_figure(design, simulation::heating(design, 40));
  const double coil = design.performance.free.heat.coil_temperature.value();
  EXPECT_NEAR(std::max(series_of(figure, "coil at place 1").y.back(), series_of(figure, "coil at place 3").y.back()),
              coil, 0.02 * (coil - 25.0));
  EXPECT_LT(series_of(figure, "magnet at place 2").y.back(), coil);
}

TEST(DesignFigures, ShowThreePoses) {
  const simulation::EvaluatedDesign design = finger();
  const auto motion = simulation::step_motion(design, shown_duration(design), 400);
  const std::vector<Figure> poses = pose_figures_of(design, motion);
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_EQ(poses[0].id, "pose-rest");
  EXPECT_EQ(poses[2].id, "pose-peak");
  EXPECT_EQ(pose_figures_of(design, std::nullopt).size(), 2U);
}

}  // namespace
}  // namespace coilwright::page
