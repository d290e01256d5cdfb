#include "measurement/replay/prediction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/initial_state.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::Model;

constexpr double loss = 0.15;          // of the force, per square ampere
constexpr double time_constant = 0.2;  // s

// The finger whose magnets warm up, cold (0) or warm (1) at the start of a run.
Model warming_finger(double warm_start) {
  actuator::ModelSpec spec = actuator::assemble_or_throw(actuator::paper_finger()).model.nominal_spec();
  spec.effects = {
      {.kind = actuator::standard_effects().find("magnet_heating"), .values = {loss, time_constant, warm_start}}};
  return Model(spec);
}

// One second at 1 A, with its bending angle.
data::Run held(data::Start start) {
  data::Run run{.name = "held.csv",
                .kind = data::RunKind::transient,
                .drive = data::Drive::current,
                .start = start,
                .sigma = 1e-3};
  for (int i = 0; i < 500; ++i) {
    run.times.push_back(0.002 * i);
    run.inputs.push_back({1.0});
  }
  run.channels = {{.name = "bending_angle_deg",
                   .kind = data::ChannelKind::bending_angle,
                   .values = std::vector(run.times.size(), 0.0)}};
  return run;
}

struct Ends {
  double first{}, last{};
};

// Simulated from the equilibrium at the start of the run, rad.
Ends ends_of(const Model& model, data::Start how) {
  const DeclaredModel declared{};
  const data::Run run = held(how);
  const PreparedRun record = prepare_run(run, declared, model);
  const Window& window = record.windows.front();
  const auto start = simulation::equilibrium_at_first_input(model, window.input);
  EXPECT_TRUE(start);
  const auto predicted = predict_window(model, record, window, *start);
  EXPECT_TRUE(predicted);
  return {.first = predicted->values[0], .last = predicted->values[predicted->values.size() - 1]};
}

// The force falls by 15 % with a time constant of a fifth of the run. With the heat settled at the start there would be
// no motion, whatever the choice.
TEST(Prediction, FallsAfterAColdStartAndRestsAfterAWarmOne) {
  for (const data::Start how : {data::Start::at_rest, data::Start::measured, data::Start::free}) {
    const Ends cold = ends_of(warming_finger(0.0), how);
    EXPECT_LT(cold.last, 0.95 * cold.first);
    const Ends warm = ends_of(warming_finger(1.0), how);
    EXPECT_NEAR(warm.last, warm.first, 1e-6);
    EXPECT_NEAR(cold.last, warm.first, 0.01 * warm.first);  // both end where the heat is in balance
  }
}

// What is shown first is where a free motion is fitted to start: a late camera shows the same one, from its first
// picture on. The start moves, so that a motion that began there would stand still in the pictures before.
TEST(Prediction, OfAFreeMotionIsTheSameHoweverLateTheCamera) {
  actuator::ModelSpec spec = actuator::assemble_or_throw(actuator::paper_finger()).model.nominal_spec();
  data::Run run = held(data::Start::free);
  for (std::vector<double>& row : run.inputs) row = {0.0};
  const auto shown_after = [&](double delay) {
    spec.effects = {{.kind = actuator::standard_effects().find("measurement_delay"), .values = {delay}}};
    const Model model(spec);
    const DeclaredModel declared{};
    const PreparedRun record = prepare_run(run, declared, model);
    const LocalNumbers numbers(record, record.windows.front());
    std::vector<double> start(numbers.size(), 0.0);
    for (int j = 0; j < model.joints(); ++j) {
      start[static_cast<std::size_t>(j)] = 0.1;
      start[static_cast<std::size_t>(model.joints() + j)] = 3.0;
    }
    const LocalValues local{.numbers = &numbers, .values = start};
    const auto motion = simulate_window(model, record.windows.front(), local, {});
    return observed_values(model, record, record.windows.front(), motion.value(), local);
  };
  // The integrator's error, and that of a cubic between rows of 2 ms.
  constexpr double error = 1e-5;  // rad
  const Eigen::VectorXd in_time = shown_after(0.0);
  EXPECT_GT((in_time.array() - in_time[0]).abs().maxCoeff(), 0.1);
  for (const double delay : {0.001, 0.05})
    EXPECT_LT((shown_after(delay) - in_time).lpNorm<Eigen::Infinity>(), error) << delay;
}

// The heat of what acts before the first picture is in it.
TEST(Prediction, WarmsUpFromTheFirstInputOn) {
  const Model model = warming_finger(0.0);
  const DeclaredModel declared{};
  data::Run late = held(data::Start::at_rest);
  late.input_times = late.times;
  for (double& time : late.times) time += 0.2;
  const PreparedRun record = prepare_run(late, declared, model);
  const Window& window = record.windows.front();
  const auto start = simulation::equilibrium_at_first_input(model, window.input);
  ASSERT_TRUE(start);
  const auto predicted = predict_window(model, record, window, *start);
  ASSERT_TRUE(predicted);
  const data::Run whole = held(data::Start::at_rest);
  const PreparedRun from_start = prepare_run(whole, declared, model);
  const auto expected = predict_window(model, from_start, from_start.windows.front(), *start);
  ASSERT_TRUE(expected);
  EXPECT_LT(expected->values[100], 0.97 * expected->values[0]);
  EXPECT_NEAR(predicted->values[0], expected->values[100], 1e-6);
}

// A prediction of a grasp on the finger without heat.
double grasp(std::vector<double> openings, std::vector<double> heights) {
  const Model model = actuator::assemble_or_throw(actuator::paper_finger()).model;
  const DeclaredModel declared{};
  data::Run run{.name = "wall.csv", .kind = data::RunKind::blocked_force, .sigma = 1e-3};
  run.inputs = {{1.4}};
  run.openings = std::move(openings);
  run.heights = std::move(heights);
  run.channels = {{.name = "force_N", .kind = data::ChannelKind::force, .values = {1.0}}};
  const PreparedRun record = prepare_run(run, declared, model);
  return predict_bench(model, record, declared).value()[0];
}

// The table of docs/theory/simulation.md, three digits; its grasps are checked against the least energy along the wall.
TEST(Prediction, TakesAGraspWhereItWasMeasured) {
  EXPECT_NEAR(grasp({}, {}), 1.123, 6e-4);
  EXPECT_NEAR(grasp({30.0 * 0.017453292519943295}, {}), 0.556, 6e-4);
  EXPECT_NEAR(grasp({}, {20e-3}), 1.178, 6e-4);
  EXPECT_THAT([] { return grasp({}, {25e-3}); },
              testing::ThrowsMessage<std::invalid_argument>(
                  "wall.csv: height_mm must not lie beyond the tip, 21.2 mm from its joint; got 25"));
}

// Only a run begins at rest: a piece of it begins wherever the one before has led.
TEST(Prediction, BeginsLaterPiecesOfARunAtRestAnywhere) {
  const DeclaredModel declared{};
  data::Run run = held(data::Start::at_rest);
  run.window = 0.5;
  const PreparedRun record = prepare_run(run, declared, warming_finger(0.0));
  ASSERT_EQ(record.windows.size(), 2U);
  EXPECT_FALSE(LocalNumbers(record, record.windows[0]).has_initial_state());
  EXPECT_TRUE(LocalNumbers(record, record.windows[1]).has_initial_state());
}

TEST(Prediction, ContinuesTheHeatInTheNextWindow) {
  const Model model = warming_finger(0.0);
  const DeclaredModel declared{};
  data::Run run = held(data::Start::free);
  run.window = 0.5;
  const PreparedRun record = prepare_run(run, declared, model);
  ASSERT_EQ(record.windows.size(), 2U);
  const auto start = simulation::equilibrium_at_first_input(model, record.windows.front().input);
  ASSERT_TRUE(start);
  const auto first = predict_window(model, record, record.windows[0], *start);
  ASSERT_TRUE(first);
  const auto whole = ends_of(model, data::Start::free);
  const auto second = predict_window(model, record, record.windows[1], first->last);
  ASSERT_TRUE(second);
  EXPECT_NEAR(second->values[second->values.size() - 1], whole.last, 1e-4);
}

}  // namespace
}  // namespace coilwright::measurement::replay
