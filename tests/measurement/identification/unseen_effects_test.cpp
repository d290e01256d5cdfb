#include "measurement/identification/unseen_effects.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/identification/curvature.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/identification/slide_fits.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr double sigma = 0.3 * noise_sigma;

// A slide whose mass and damping are fitted, and a drag that may be there.
struct Slid {
  Slid(double drag, unsigned seed)
      : run(dragged_run(400, drag, sigma, seed)),
        declared(slide(true_mass, true_damping)),
        runs{replay::prepare_run(run, declared, model_of(declared))},
        found{.before = fitted({}),
              .after = fitted({}),
              .kinds = {&drag_kind},
              .scale = rig_scale(runs, model_of(declared))} {}

  [[nodiscard]] FittedHypothesis fitted(std::vector<actuator::Effect> effects) const {
    return fitted_to(runs, declared, std::move(effects));
  }
  [[nodiscard]] FittedHypothesis with_drag() const { return fitted({{.kind = &drag_kind, .values = {0.1}}}); }
  [[nodiscard]] std::vector<Estimate> estimates() const {
    const FittedHypothesis& without = found.after;
    const Eigen::VectorXd deviations = standard_deviations(without, 1.0);
    std::vector<Estimate> out;
    for (Eigen::Index i = 0; i < deviations.size(); ++i)
      out.push_back(local_estimate(without.hypothesis.parameters()[static_cast<std::size_t>(i)], without.fit.values[i],
                                   deviations[i]));
    return out;
  }

  const actuator::EffectKind& drag_kind = *actuator::standard_effects().find("quadratic_drag");
  data::Run run;
  replay::DeclaredModel declared;
  std::vector<replay::PreparedRun> runs;
  Attribution found;
};

double half_width(const Estimate& estimate) {
  return 0.5 * (estimate.upper - estimate.lower);
}

// By a second route: the model with the drag is fitted, and both are averaged by their weights. The widening is to
// first order in a drag that moves the damping by tens of its deviations: within a fifth.
TEST(UnseenEffects, WidenAnIntervalToThatOfTheModelsWithAndWithoutThem) {
  const Slid slid(0.07, 3);
  const FittedHypothesis& without = slid.found.after;
  const FittedHypothesis with = slid.with_drag();
  const double gain = quasi_bic(without, 1.0) - quasi_bic(with, 1.0);
  ASSERT_GT(gain, -2.0);
  ASSERT_LT(gain, 6.0);  // hinted at, and not decided
  const Eigen::VectorXd own = standard_deviations(without, 1.0);
  const Eigen::VectorXd other = standard_deviations(with, 1.0);
  const double weight = std::exp(0.5 * gain);
  constexpr double first_order = 0.2;
  std::vector<Estimate> estimates = slid.estimates();
  const std::vector<Estimate> narrow = estimates;
  const auto hints = widen_by_unseen_effects(estimates, slid.runs, slid.found, 1.0);
  double widest = 0.0;
  for (Eigen::Index i = 0; i < own.size(); ++i) {
    const double moved = with.fit.values[i] - without.fit.values[i];
    const double beyond = weight / (1.0 + weight) * (moved * moved + other[i] * other[i] - own[i] * own[i]);
    const double expected = std::sqrt(1.0 + beyond / (own[i] * own[i]));
    const auto index = static_cast<std::size_t>(i);
    EXPECT_NEAR(half_width(estimates[index]) / half_width(narrow[index]), expected, first_order * expected);
    EXPECT_EQ(estimates[index].value, narrow[index].value);
    widest = std::max(widest, expected);
  }
  ASSERT_EQ(hints.size(), 1u);
  EXPECT_EQ(hints.front().kind, &slid.drag_kind);
  EXPECT_EQ(hints.front().number, "damping");
  EXPECT_NEAR(hints.front().gain, gain, 0.5);
  EXPECT_NEAR(hints.front().wider, widest, first_order * widest);
  EXPECT_GT(hints.front().wider, 1.5);
}

// With and without a drag that most records hint at and few decide: the interval of the damping holds the truth.
TEST(UnseenEffects, MakeIntervalsHoldTheTruthBesideThem) {
  constexpr int draws = 40;
  int narrow_hits = 0;
  int hits = 0;
  for (unsigned seed = 100; seed < 100 + draws; ++seed) {
    const Slid slid(0.08, seed);
    std::vector<Estimate> estimates = slid.estimates();
    const auto holds = [](const Estimate& each) { return each.lower <= true_damping && true_damping <= each.upper; };
    if (holds(estimates[1])) ++narrow_hits;
    (void)widen_by_unseen_effects(estimates, slid.runs, slid.found, 1.0);
    if (holds(estimates[1])) ++hits;
  }
  EXPECT_LT(narrow_hits, draws / 2);
  EXPECT_GE(hits, 9 * draws / 10);
}

TEST(UnseenEffects, ChangeNothingWhereNoneIsHintedAt) {
  const Slid slid(0.0, 5);
  std::vector<Estimate> estimates = slid.estimates();
  const std::vector<Estimate> narrow = estimates;
  EXPECT_TRUE(widen_by_unseen_effects(estimates, slid.runs, slid.found, 1.0).empty());
  for (std::size_t i = 0; i < narrow.size(); ++i) {
    EXPECT_EQ(estimates[i].lower, narrow[i].lower);
    EXPECT_EQ(estimates[i].upper, narrow[i].upper);
  }
}

// An end that the data did not set stays open, and so does one that passes zero.
TEST(UnseenEffects, LeaveOpenWhatIsOpen) {
  const Slid slid(0.07, 3);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Estimate> estimates = slid.estimates();
  estimates[0].upper = infinity;
  estimates[1].lower = 1e-6;
  (void)widen_by_unseen_effects(estimates, slid.runs, slid.found, 1.0);
  EXPECT_EQ(estimates[0].upper, infinity);
  EXPECT_EQ(estimates[1].lower, -infinity);
  EXPECT_TRUE(estimates[1].determined);
}

}  // namespace
}  // namespace coilwright::measurement::identification
