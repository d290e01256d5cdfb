#include "coilwright/sizing/study/spread.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stop_token>
#include <string>
#include <tuple>
#include <vector>

#include "coilwright/actuator/design/value_limits.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/modelling_choices.hpp"
#include "coilwright/sizing/study/usual_scatters.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "error_text.hpp"
#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

// Of a figure of a build, whose curves are made to 1e-4 of their largest value: a tenth of that.
constexpr double error_of_builds = 1e-5;

Scatter normal(const char* name, double sd, bool relative = false) {
  return {.name = name, .about = NormalDeviation{sd}, .relative = relative};
}

Scatter uniform(const char* name, double low, double high, bool relative = false) {
  return {.name = name, .about = UniformDeviation{.low = low, .high = high}, .relative = relative};
}

Spread spread_of(std::vector<Scatter> scatters, std::size_t draws = 32) {
  return {.scatters = std::move(scatters), .draws = draws};
}

EvaluatedDesign paper_like(double current = 1.0) {
  return simulation::evaluate(actuator::Design{}, {.current = current});
}

double value(const char* name, const EvaluatedDesign& design) {
  return simulation::standard_quantities().at(name).value(design.view()).value();
}

// The middles of 32 equal shares: their 95 % is at 0.95 itself, so that a limit on it is kept by 95 % of what fills the
// line evenly. By type 7 it would be 0.936.
TEST(Percentile, HasNoBiasForEvenPlaces) {
  std::vector<std::optional<double>> even;
  for (int i = 0; i < 32; ++i) even.emplace_back((i + 0.5) / 32.0);
  EXPECT_NEAR(percentile(even, 95.0).value(), 0.95, 1e-12);
  EXPECT_NEAR(percentile(even, 5.0).value(), 0.05, 1e-12);
}

// Quantiles of the normal law from tables, to their digits; the cut at 4 standard deviations moves them by less.
TEST(Scatter, DeviatesByItsLaw) {
  const Scatter gap = normal("gap_mm", 0.1);
  EXPECT_NEAR(gap.deviation(0.5), 0.0, 1e-12);
  EXPECT_NEAR(gap.deviation(0.975), 0.195996, 2e-4);
  EXPECT_NEAR(gap.deviation(0.025), -gap.deviation(0.975), 1e-12);
  EXPECT_NEAR(gap.deviation(0.0), -0.4, 1e-3);
  EXPECT_NEAR(gap.deviation(1.0), 0.4, 1e-3);
  EXPECT_NEAR(uniform("gap_mm", -0.1, 0.3).deviation(0.75), 0.2, 1e-15);
}

// As R's quantile(c(1, 2, 3, 4, 10), p), type 5.
TEST(Percentile, InterpolatesBetweenOrderStatistics) {
  const std::vector<std::optional<double>> values{4.0, 1.0, 10.0, 2.0, 3.0};
  EXPECT_NEAR(percentile(values, 25.0).value(), 1.75, 1e-12);
  EXPECT_NEAR(percentile(values, 50.0).value(), 3.0, 1e-12);
  EXPECT_NEAR(percentile(values, 85.0).value(), 8.5, 1e-12);
  EXPECT_EQ(percentile(values, 95.0), 10.0);
}

// What could not be built is worse than all that could.
TEST(Percentile, CountsWhatIsMissingAtTheBadEnd) {
  std::vector<std::optional<double>> values(40, 1.0);
  values[7].reset();
  EXPECT_EQ(percentile(values, 5.0), 1.0);  // between the second and the third of 40
  EXPECT_EQ(percentile(values, 95.0), 1.0);
  values[8].reset();
  values[9].reset();
  EXPECT_EQ(percentile(values, 5.0), std::nullopt);
  EXPECT_EQ(percentile(values, 95.0), std::nullopt);
  EXPECT_EQ(percentile(values, 50.0), 1.0);
}

TEST(StatisticName, IsAPrefixOfAQuantity) {
  const auto parts = statistic_named("p05_grasp_force_N");
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->statistic.kind, Statistic::Kind::percentile);
  EXPECT_EQ(parts->statistic.percent, 5);
  EXPECT_EQ(parts->quantity, "grasp_force_N");
  EXPECT_EQ(statistic_named("sd_mass_g")->statistic.kind, Statistic::Kind::deviation);
  EXPECT_EQ(statistic_named("mean_mass_g")->quantity, "mass_g");
  for (const char* name : {"peak_angle_deg", "p00_mass_g", "p5_mass_g", "p105_mass_g", "p+5_mass_g", "power_W", "p05"})
    EXPECT_EQ(statistic_named(name), std::nullopt) << name;
}

// Of 64 places moved as one, each sixteenth of every side holds four; their mean of a smooth function beats dice by
// far.
TEST(SobolShares, FillTheCubeEvenly) {
  const auto places = sobol_shares(5, 64, 3);
  double mean = 0.0;
  for (std::size_t side = 0; side < 5; ++side) {
    std::vector<int> count(16, 0);
    for (const auto& place : places) ++count.at(static_cast<std::size_t>(place[side] * 16.0));
    for (const int each : count) EXPECT_NEAR(each, 4, 1) << side;
  }
  for (const auto& place : places) mean += std::exp(place[0] + place[1]) * place[2] / 64.0;
  const double exact = (std::numbers::e - 1.0) * (std::numbers::e - 1.0) / 2.0;
  EXPECT_NEAR(mean, exact, 0.069);  // half of what dice err by, sqrt(((e^2 - 1) / 2)^2 / 3 - exact^2) / 8
  EXPECT_EQ(places, sobol_shares(5, 64, 3));
  EXPECT_NE(places, sobol_shares(5, 64, 4));
}

TEST(Built, IsTheDesignWithItsNumbersDisplaced) {
  const EvaluatedDesign design = paper_like();
  const Spread spread = spread_of({uniform("gap_mm", -0.2, 0.2), uniform("current_A", -0.1, 0.1, true),
                                   uniform("joint_stiffness_factor", -0.5, 0.5, true)});
  const DesignResult result = built(spread, design.view(), std::vector<double>{0.75, 0.75, 0.25});
  const auto& one = std::get<EvaluatedDesign>(result);
  EXPECT_NEAR(one.design.body.gap, design.design.body.gap + 0.1e-3, 1e-15);
  EXPECT_NEAR(one.point.current, 1.05, 1e-12);
  EXPECT_NEAR(value("joint_stiffness_Nmm_rad", one), 0.75 * value("joint_stiffness_Nmm_rad", design), 1e-9);
  // In the middle it is the design itself.
  const DesignResult middle = built(spread, design.view(), std::vector<double>{0.5, 0.5, 0.5});
  EXPECT_NEAR(value("peak_bending_speed_deg_s", std::get<EvaluatedDesign>(middle)),
              value("peak_bending_speed_deg_s", design), error_of_builds * value("peak_bending_speed_deg_s", design));
}

// A Gaussian copula: 1000 builds of two numbers have the correlation that was asked, within four of its standard
// errors, (1 - r^2) / sqrt(1000), and each keeps its own law.
TEST(Built, CorrelatesWhatScattersTogether) {
  Spread spread = spread_of({normal("current_A", 0.01), normal("gap_mm", 0.02)});
  Eigen::MatrixXd correlation(2, 2);
  correlation << 1.0, -0.8, -0.8, 1.0;
  spread.correlated.push_back({.name = "both", .scatters = {0, 1}, .root = correlation_root(correlation)});
  const EvaluatedDesign design = paper_like(1.0);
  double products = 0.0;
  double squares_of_gap = 0.0;
  double squares_of_current = 0.0;
  for (const std::vector<double>& shares : random_shares(2, 1000, 5)) {
    const DesignResult result = built(spread, design.view(), shares);
    const auto& one = std::get<EvaluatedDesign>(result);
    const double current = (one.point.current - 1.0) / 0.01;
    const double gap = (one.design.body.gap - design.design.body.gap) / 0.02e-3;
    products += current * gap / 1000.0;
    squares_of_gap += gap * gap / 1000.0;
    squares_of_current += current * current / 1000.0;
  }
  EXPECT_NEAR(products, -0.8, 4.0 * (1.0 + 0.64) / std::sqrt(1000.0));
  EXPECT_NEAR(products / std::sqrt(squares_of_gap * squares_of_current), -0.8, 4.0 * 0.36 / std::sqrt(1000.0));
  EXPECT_NEAR(squares_of_gap, 1.0, 4.0 * std::sqrt(2.0 / 1000.0));
}

TEST(CorrelationRoot, IsOneOfSingularMatricesToo) {
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(3, 3);
  const Eigen::MatrixXd root = correlation_root(ones);
  EXPECT_TRUE((root * root.transpose()).isApprox(ones, 1e-12));
  Eigen::MatrixXd contradictory = Eigen::MatrixXd::Constant(3, 3, -0.9);
  contradictory.diagonal().setOnes();
  EXPECT_EQ(error_text([&] { (void)correlation_root(contradictory); }),
            "no numbers can be correlated so: what some of them imply contradicts others");
}

// Below its probability the design is as it was; above, each other choice has an equal part of what is left.
TEST(Built, MakesModellingChoicesOtherwise) {
  const Spread spread = spread_of({{.name = "assumptions", .about = OtherChoices{0.6}}});
  const EvaluatedDesign design = paper_like(1.0);
  const std::vector<actuator::OtherChoice> others = actuator::other_choices(design.design);
  const auto speed_at = [&](double share) {
    return value("peak_bending_speed_deg_s",
                 std::get<EvaluatedDesign>(built(spread, design.view(), std::vector<double>{share})));
  };
  const auto expect_speed_of = [&](const EvaluatedDesign& other, double share) {
    const double speed = value("peak_bending_speed_deg_s", other);
    EXPECT_NEAR(speed_at(share), speed, error_of_builds * speed);
  };
  expect_speed_of(design, 0.59);
  for (std::size_t i = 0; i < others.size(); ++i) {
    const double middle = 0.6 + 0.4 * (static_cast<double>(i) + 0.5) / static_cast<double>(others.size());
    const EvaluatedDesign other = simulation::evaluate(others[i].design, {.current = 1.0});
    SCOPED_TRACE(others[i].otherwise);
    expect_speed_of(other, middle);
  }
}

// The number of an effect moves, and stays inside its bounds.
TEST(Built, DisplacesNumbersOfEffects) {
  const actuator::EffectKind* drag = actuator::standard_effects().find("quadratic_drag");
  ASSERT_NE(drag, nullptr);
  actuator::Design dragged;
  dragged.effects.push_back({.kind = drag, .values = {1e-5}});
  const EvaluatedDesign design = simulation::evaluate(dragged, {.current = 1.0});
  const Spread spread = spread_of({uniform("quadratic_drag.drag_Nmms2_rad2", -0.1, 0.1)});
  const auto drag_at = [&](double share) {
    return std::get<EvaluatedDesign>(built(spread, design.view(), std::vector<double>{share}))
        .design.effects[0]
        .values[0];
  };
  EXPECT_NEAR(drag_at(0.52), 1e-5 + 4e-6, 1e-12);
  EXPECT_EQ(drag_at(0.1), drag->parameters()[0].lower);
}

std::vector<Scatter> of_each(const char* name, double half) {
  std::vector<Scatter> out(most_parts(name), uniform(name, -half, half, true));
  for (std::size_t part = 0; part < out.size(); ++part) out[part].part = part;
  return out;
}

constexpr const char* each_joint = "each_joint_stiffness_factor";
constexpr const char* each_magnet = "each_remanence_factor";

const std::vector<actuator::Hinge>& hinges_of(const DesignResult& build) {
  return std::get<EvaluatedDesign>(build).assembly.model.hinges();
}

TEST(Built, GivesEachJointAndMagnetItsOwn) {
  const EvaluatedDesign design = paper_like();
  const double stiffness = design.assembly.model.hinges()[0].stiffness;
  Spread spread = spread_of(of_each(each_joint, 0.2));
  const std::size_t joints = spread.scatters.size();
  std::ranges::move(of_each(each_magnet, 0.1), std::back_inserter(spread.scatters));
  std::vector<double> shares(spread.scatters.size(), 0.5);
  const DesignResult middle = built(spread, design.view(), shares);
  shares[0] = 0.75;
  shares[1] = 0.25;
  shares[2] = 0.99;  // of a joint that the finger does not have
  shares[joints] = 0.75;
  const DesignResult apart = built(spread, design.view(), shares);
  EXPECT_NEAR(hinges_of(apart)[0].stiffness, 1.1 * stiffness, 1e-12 * stiffness);
  EXPECT_NEAR(hinges_of(apart)[1].stiffness, 0.9 * stiffness, 1e-12 * stiffness);
  EXPECT_NEAR(value("axial_force_N", std::get<EvaluatedDesign>(apart)), 1.05 * value("axial_force_N", design), 1e-9);
  // In the middle all are alike: the very build without them.
  const DesignResult plain = built(spread_of({uniform("current_A", -0.1, 0.1)}), design.view(), std::vector{0.5});
  for (const char* name : {"steady_angle_deg", "peak_bending_speed_deg_s", "grasp_force_N"})
    EXPECT_EQ(value(name, std::get<EvaluatedDesign>(middle)), value(name, std::get<EvaluatedDesign>(plain))) << name;
}

// All of them by one share are the number of the whole: to what poses are found for the joints, whose damping alone
// follows another mode, and to the error of two builds' curves for magnets.
TEST(Built, GivesAllOfThemWhatTheWholeHas) {
  const EvaluatedDesign design = paper_like();
  for (const auto& [each, whole, error] :
       {std::tuple{each_joint, "joint_stiffness_factor", 1e-7}, std::tuple{each_magnet, "remanence_T", 2e-5}}) {
    const Spread one_by_one = spread_of(of_each(each, 0.2));
    const std::vector<double> shares(one_by_one.scatters.size(), 0.9);
    const DesignResult apart = built(one_by_one, design.view(), shares);
    const DesignResult together = built(spread_of({uniform(whole, -0.2, 0.2, true)}), design.view(), std::vector{0.9});
    for (const char* name : {"steady_angle_deg", "grasp_force_N"}) {
      const double expected = value(name, std::get<EvaluatedDesign>(together));
      EXPECT_NEAR(value(name, std::get<EvaluatedDesign>(apart)), expected, error * expected) << each << ' ' << name;
    }
  }
}

// The sum of two independent stiffnesses varies by twice what one does, where two alike vary by four times; within four
// standard errors of 200 dice, sqrt(2 / 200).
TEST(Built, DrawsJointsIndependently) {
  const EvaluatedDesign design = paper_like();
  const double stiffness = design.assembly.model.hinges()[0].stiffness;
  const Spread spread = spread_of(of_each(each_joint, 0.1));
  double sums = 0.0;
  double differences = 0.0;
  for (const std::vector<double>& shares : random_shares(spread.scatters.size(), 200, 5)) {
    const DesignResult one = built(spread, design.view(), shares);
    const double first = hinges_of(one)[0].stiffness / stiffness - 1.0;
    const double second = hinges_of(one)[1].stiffness / stiffness - 1.0;
    sums += (first + second) * (first + second) / 200.0;
    differences += (first - second) * (first - second) / 200.0;
  }
  const double of_one = 0.1 * 0.1 / 3.0;
  EXPECT_NEAR(sums / of_one, 2.0, 4.0 * 2.0 * 0.1);
  EXPECT_NEAR(differences / of_one, 2.0, 4.0 * 2.0 * 0.1);
}

TEST(Built, SaysWhyItCannotBe) {
  const Spread wide = spread_of({uniform("magnet_radius_mm", -100.0, 100.0)});
  const EvaluatedDesign design = paper_like();
  const DesignResult thin = built(wide, design.view(), std::vector<double>{0.1});
  const auto* none = std::get_if<NotEvaluated>(&thin);
  const auto* some = std::get_if<EvaluatedDesign>(&thin);
  ASSERT_TRUE(none != nullptr || some != nullptr);
  if (some != nullptr) {
    EXPECT_EQ(some->design.magnet.radius, actuator::shortest_length);
  }
  const Spread shares = spread_of({uniform("coil_inner_radius_mm", -100.0, 1000.0)});
  const DesignResult huge = built(shares, design.view(), std::vector<double>{0.9999});
  if (const auto* why = std::get_if<NotEvaluated>(&huge)) {
    EXPECT_FALSE(why->reason.empty());
  }
}

// A quantity that is the number itself has the law's own percentiles, mean and deviation, but for what 512 places may
// be moved by together: 1/512 of the share, 0.02 standard deviations at 5 %.
TEST(SpreadQuantities, AreStatisticsOfTheBuilds) {
  SpreadQuantities statistics(spread_of({normal("current_A", 0.02, true)}, 512));
  const simulation::QuantityTable& known = simulation::standard_quantities();
  const auto p05 = statistics.find("p05_current_A", known);
  const auto p95 = statistics.find("p95_current_A", known);
  const auto mean = statistics.find("mean_current_A", known);
  const auto sd = statistics.find("sd_current_A", known);
  ASSERT_TRUE(p05 && p95 && mean && sd);
  EXPECT_EQ(statistics.find("p05_current", known), std::nullopt);
  EXPECT_EQ(statistics.find("current_A", known), std::nullopt);
  const EvaluatedDesign design = paper_like(1.2);
  EXPECT_NEAR(p05->value(design.view()).value(), 1.2 * (1.0 - 0.02 * 1.644854), 5e-4);
  EXPECT_NEAR(p95->value(design.view()).value(), 1.2 * (1.0 + 0.02 * 1.644854), 5e-4);
  EXPECT_NEAR(mean->value(design.view()).value(), 1.2, 5e-4);
  EXPECT_NEAR(sd->value(design.view()).value(), 1.2 * 0.02, 5e-4);
}

TEST(UsualScatters, AreOfNumbersThatThereAre) {
  for (const Making making : {Making::printed, Making::by_hand})
    for (const UsualScatter& usual : usual_scatters(making)) {
      const actuator::Parameter* parameter = actuator::find_parameter(usual.scatter.name);
      EXPECT_NE(parameter == nullptr, most_parts(usual.scatter.name) == 0) << usual.scatter.name;
      if (parameter != nullptr) {
        EXPECT_FALSE(parameter->whole) << usual.scatter.name;
      }
      EXPECT_GT(usual.scatter.deviation(0.9), 0.0) << usual.scatter.name;
      EXPECT_FALSE(usual.source.empty()) << usual.scatter.name;
    }
}

// The order is that in which builds draw: another one would be other builds of the same study.
TEST(UsualScatters, OfPrintedMouldsAreDrawnInTheirOrder) {
  std::vector<std::string> names;
  for (const UsualScatter& usual : usual_scatters()) names.push_back(usual.scatter.name);
  EXPECT_THAT(names,
              ::testing::ElementsAre("remanence_T", "magnet_radius_mm", "magnet_length_mm", "gap_mm", "bottom_layer_mm",
                                     "joint_stiffness_factor", "joint_damping_factor", "constant_damping_factor",
                                     "coil_resistance_factor", "radial_pitch_factor", "heat_transfer_factor",
                                     "each_joint_stiffness_factor", "each_remanence_factor"));
  EXPECT_DOUBLE_EQ(std::get<NormalDeviation>(usual_scatters()[4].scatter.about).sd, 0.05);
  EXPECT_DOUBLE_EQ(std::get<NormalDeviation>(usual_scatters()[5].scatter.about).sd, 0.08);
}

// Nobody builds closer by hand than in printed moulds.
TEST(UsualScatters, OfHandsAreNoCloser) {
  for (const UsualScatter& printed : usual_scatters(Making::printed)) {
    const auto by_hand = std::ranges::find_if(usual_scatters(Making::by_hand), [&](const UsualScatter& each) {
      return each.scatter.name == printed.scatter.name;
    });
    ASSERT_NE(by_hand, usual_scatters(Making::by_hand).end()) << printed.scatter.name;
    EXPECT_GE(by_hand->scatter.deviation(0.9), printed.scatter.deviation(0.9)) << printed.scatter.name;
  }
}

// A modulus that is known to a factor of two: half to double between the quantiles of one standard deviation, the
// designed value in the middle, and never below nothing.
TEST(Scatter, AboveAQuarterIsOneOfTheLogarithm) {
  const Scatter factor_two{.name = "youngs_modulus_MPa", .about = NormalDeviation{std::log(2.0)}, .relative = true};
  const double one_deviation = 0.841345;
  EXPECT_NEAR(1.0 + factor_two.deviation(one_deviation), 2.0, 1e-3);
  EXPECT_NEAR(1.0 + factor_two.deviation(1.0 - one_deviation), 0.5, 1e-3);
  EXPECT_NEAR(factor_two.deviation(0.5), 0.0, 1e-9);
  EXPECT_GT(factor_two.deviation(1e-9), -1.0);
  const Scatter narrow{.name = "youngs_modulus_MPa", .about = NormalDeviation{0.25}, .relative = true};
  EXPECT_NEAR(narrow.deviation(one_deviation), 0.25, 1e-4);
}

Study study_with(Spread spread, double most_current) {
  Study study{.name = "one",
              .base = {},
              .current = FixedCurrent{1.2},
              .variables = {},
              .objectives = {},
              .limits = {},
              .search = {}};
  study.spread = std::move(spread);
  study.limits.push_back({.quantity = simulation::standard_quantities().at("current_A"), .value = most_current});
  return study;
}

// 95.22 % lie below 5/3 standard deviations; by dice, so within the interval that is stated with it.
TEST(YieldOf, IsTheShareThatTheLawKeeps) {
  const Study study = study_with(spread_of({normal("current_A", 0.02, true)}), 1.24);
  const EvaluatedDesign design = paper_like(1.2);
  const auto yield = yield_of(study, design, {.builds = 2000, .seed = 7, .threads = 2});
  ASSERT_TRUE(yield);
  EXPECT_EQ(yield->not_built, 0u);
  EXPECT_LT(yield->keeps_all.low, 0.9522);
  EXPECT_GT(yield->keeps_all.high, 0.9522);
  EXPECT_LT(yield->keeps_all.high - yield->keeps_all.low, 0.025);
  ASSERT_EQ(yield->quantities.size(), 1u);
  EXPECT_EQ(yield->quantities[0].nominal, 1.2);
  EXPECT_NEAR(yield->quantities[0].p50.value(), 1.2, 0.002);
  EXPECT_EQ(yield->quantities[0].limit, "current_A <= 1.24");
  const auto again = yield_of(study, design, {.builds = 2000, .seed = 7, .threads = 1});
  EXPECT_EQ(again->keeps_all.value, yield->keeps_all.value);
  EXPECT_EQ(again->quantities[0].p05, yield->quantities[0].p05);
}

TEST(YieldOf, GivesTheWorthOfEachScatter) {
  const Study study =
      study_with(spread_of({normal("current_A", 0.02, true), normal("magnet_length_mm", 0.05)}), 1.2 * 1.02);
  const auto yield = yield_of(study, paper_like(1.2), {.builds = 100, .worth_builds = 512});
  ASSERT_TRUE(yield);
  ASSERT_EQ(yield->worths.size(), 2u);
  EXPECT_NEAR(yield->worths[0].first[0].value().value, 1.0, 0.02);
  EXPECT_NEAR(yield->worths[1].total[0].value().value, 0.0, 1e-9);
  EXPECT_NEAR(yield->worths[0].keeps_all.value, 0.97725, 0.02);  // two standard deviations
  EXPECT_NEAR(yield->worths[1].keeps_all.value, 0.84134, 0.04);  // one, as it is
}

TEST(YieldOf, GivesTheWorthsWhoseBuildsWereMadeBeforeAStop) {
  const Study study =
      study_with(spread_of({normal("current_A", 0.02, true), normal("magnet_length_mm", 0.05)}), 1.2 * 1.02);
  std::stop_source stop;
  YieldOptions options{.builds = 20, .worth_builds = 50, .threads = 1, .stop = stop.get_token()};
  const auto whole = yield_of(study, paper_like(1.2), {.builds = 20, .worth_builds = 50, .threads = 1});
  // Two sums that all need and two of the first scatter are complete, and the second one's are not.
  options.progress = [&stop](std::size_t done, std::size_t) {
    if (done == 20 + 4 * 50 + 60) stop.request_stop();
  };
  const auto yield = yield_of(study, paper_like(1.2), options);
  ASSERT_EQ(yield->worths.size(), 1u);
  EXPECT_EQ(yield->worths_left, 1u);
  EXPECT_EQ(yield->worths[0].scatter, "current_A");
  EXPECT_EQ(yield->worths[0].keeps_all.value, whole->worths[0].keeps_all.value);
  EXPECT_EQ(yield->worths[0].total[0].value().value, whole->worths[0].total[0].value().value);
}

// Together they are one input: its share is all, whatever each has of it.
TEST(YieldOf, TakesWhatScattersTogetherAsOne) {
  Spread spread =
      spread_of({normal("current_A", 0.02, true), normal("gap_mm", 0.05), normal("magnet_length_mm", 0.05)});
  const Eigen::MatrixXd correlation = Eigen::MatrixXd::Ones(2, 2);
  spread.correlated.push_back({.name = "two", .scatters = {0, 1}, .root = correlation_root(correlation)});
  const auto yield =
      yield_of(study_with(std::move(spread), 1.25), paper_like(1.2), {.builds = 100, .worth_builds = 256});
  ASSERT_TRUE(yield);
  ASSERT_EQ(yield->worths.size(), 2u);
  EXPECT_EQ(yield->worths[0].scatter, "two");
  EXPECT_NEAR(yield->worths[0].first[0].value().value, 1.0, 0.02);
  EXPECT_EQ(yield->worths[1].scatter, "magnet_length_mm");
}

TEST(YieldOf, TakesTheJointsOfAFingerAsOne) {
  Spread spread = spread_of(of_each(each_joint, 0.05));
  spread.scatters.push_back(normal("current_A", 0.02, true));
  const auto yield = yield_of(study_with(std::move(spread), 1.25), paper_like(1.2), {.builds = 50, .worth_builds = 64});
  ASSERT_TRUE(yield);
  ASSERT_EQ(yield->worths.size(), 2u);
  EXPECT_EQ(yield->worths[0].scatter, each_joint);
  EXPECT_NEAR(yield->worths[0].total[0].value().value, 0.0, 1e-9);  // the current is not theirs
  EXPECT_EQ(yield->worths[1].scatter, "current_A");
}

TEST(YieldOf, IsOfTheBuildsMadeBeforeAStop) {
  const Study study = study_with(spread_of({normal("current_A", 0.02, true)}), 1.24);
  std::stop_source stop;
  YieldOptions options{.builds = 2000, .worth_builds = 100, .threads = 1, .stop = stop.get_token()};
  options.progress = [&stop](std::size_t done, std::size_t) {
    if (done == 12) stop.request_stop();
  };
  const auto yield = yield_of(study, paper_like(1.2), options);
  ASSERT_TRUE(yield);
  EXPECT_EQ(yield->builds, 12u);
  EXPECT_TRUE(yield->worths.empty());
  EXPECT_EQ(yield->worths_left, 1u);
  EXPECT_FALSE(yield_of(study, paper_like(1.2), options));  // now it is asked before the first
}

TEST(YieldOf, NeedsASpread) {
  Study study = study_with({}, 1.0);
  study.spread.reset();
  EXPECT_EQ(error_text([&] { (void)yield_of(study, paper_like(), {}); }), "a yield needs a study with a spread");
}

// Ishigami and Homma's function, a = 7 and b = 0.1, in closed form: first 0.3139, 0.4424, 0; total 0.5576, 0.4424,
// 0.2437.
TEST(SobolIndices, AreThoseOfIshigami) {
  const auto ishigami = [](const std::vector<double>& shares) {
    constexpr double pi = std::numbers::pi;
    const double x = pi * (2.0 * shares[0] - 1.0);
    const double y = pi * (2.0 * shares[1] - 1.0);
    const double z = pi * (2.0 * shares[2] - 1.0);
    return std::sin(x) + 7.0 * std::sin(y) * std::sin(y) + 0.1 * std::pow(z, 4.0) * std::sin(x);
  };
  SaltelliValues values{.a = {}, .b = {}, .mixed = {{}, {}, {}}};
  for (const std::vector<double>& both : sobol_shares(6, 4096, 11)) {
    const std::vector<double> a(both.begin(), both.begin() + 3);
    const std::vector<double> b(both.begin() + 3, both.end());
    values.a.push_back(ishigami(a));
    values.b.push_back(ishigami(b));
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> mixed = a;
      mixed[i] = b[i];
      values.mixed[i].push_back(ishigami(mixed));
    }
  }
  const auto indices = sobol_indices(values, 1);
  ASSERT_TRUE(indices);
  const double first[] = {0.3139, 0.4424, 0.0};
  const double total[] = {0.5576, 0.4424, 0.2437};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(indices->first[i].value, first[i], 0.02) << i;
    EXPECT_NEAR(indices->total[i].value, total[i], 0.02) << i;
    EXPECT_LE(indices->first[i].low, first[i]) << i;  // of a share of 0 it is 0
    EXPECT_GT(indices->first[i].high, first[i]) << i;
    EXPECT_LT(indices->total[i].low, total[i]) << i;
    EXPECT_GT(indices->total[i].high, total[i]) << i;
  }
}

TEST(SobolIndices, AreNoneOfAConstant) {
  EXPECT_EQ(sobol_indices({.a = {1.0, 1.0}, .b = {1.0, 1.0}, .mixed = {{1.0, 1.0}}}, 1), std::nullopt);
}

}  // namespace
}  // namespace coilwright::sizing
