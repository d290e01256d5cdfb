#include "coilwright/sizing/study/assumption_effects.hpp"

#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

using testing::quantity;
using testing::small_study;

Study with_one_objective() {
  Study study = small_study();
  study.objectives.resize(1);
  return study;
}

Record answer_of(const DesignProblem& problem) {
  return search(problem.problem(), {.max_evaluations = 36, .threads = 1, .afterwards = Afterwards::nothing})
      .best.value();
}

TEST(WorstMargin, IsThatOfTheLimitWithTheLeastToSpare) {
  const Study study = with_one_objective();  // mass_g <= 66, steady_angle_deg >= 20
  EXPECT_EQ(worst_margin(study, {.objectives = {1.0}, .constraints = {-0.25, -0.5}})->limit, "mass_g <= 66");
  EXPECT_DOUBLE_EQ(worst_margin(study, {.objectives = {1.0}, .constraints = {-0.25, 0.125}})->margin, -0.125);
  EXPECT_FALSE(worst_margin(study, {.failure = "it folds"}));
}

TEST(AssumptionEffects, AreThoseOfTheAnswerItself) {
  const DesignProblem problem(with_one_objective());
  const Record best = answer_of(problem);
  const auto effects = assumption_effects(problem, best, {.evaluations = 0});
  ASSERT_EQ(effects.size(), actuator::other_choices(problem.study().base).size() +
                                actuator::other_numbers(problem.design_at(best.point)).size());
  ASSERT_EQ(effects.size(), assumption_count(problem, best));
  for (const AssumptionEffect& effect : effects) {
    if (!effect.choice.number.empty()) continue;
    Study other = problem.study();
    other.base = effect.choice.design;
    // The design of the effect is the answer's, so a study that starts there evaluates it as its own actuator.
    const DesignProblem reference(other);
    const Evaluation expected = reference.assess(reference.evaluate(best.point));
    EXPECT_EQ(effect.evaluation.objectives, expected.objectives);
    EXPECT_EQ(effect.evaluation.constraints, expected.constraints);
    EXPECT_FALSE(effect.other_best);
    EXPECT_FALSE(effect.changes_design);
  }
}

TEST(AssumptionEffects, AskForEveryDesignByTheOneWhoRecordsThem) {
  const DesignProblem problem(with_one_objective());
  const Record best = answer_of(problem);
  std::map<std::string, std::size_t> asked;
  std::mutex guard;
  AssumptionOptions options{.evaluations = 10, .search = {.threads = 2}};
  const auto direct = assumption_effects(problem, best, options);
  options.evaluate = [&](const DesignProblem& other, const actuator::OtherChoice& choice,
                         std::span<const double> point) {
    const std::scoped_lock lock(guard);
    ++asked[name_of(choice)];
    return other.assess(other.evaluate(point));
  };
  const auto effects = assumption_effects(problem, best, options);
  ASSERT_EQ(effects.size(), direct.size());
  EXPECT_EQ(asked.size(), actuator::other_choices(problem.study().base).size()) << "each has a name of its own";
  for (std::size_t i = 0; i < effects.size(); ++i) {
    EXPECT_EQ(effects[i].evaluation, direct[i].evaluation);
    if (!effects[i].choice.number.empty()) continue;  // evaluated on the spot
    EXPECT_EQ(effects[i].evaluations, asked.at(name_of(effects[i].choice)));
  }
}

// 36 designs: a search with as many evaluations finds the best under the other choice, which cannot be worse than the
// answer there.
TEST(AssumptionEffects, SearchUnderTheOtherChoice) {
  const DesignProblem problem(with_one_objective());
  const Record best = answer_of(problem);
  for (const AssumptionEffect& effect : assumption_effects(problem, best, {.evaluations = 36})) {
    if (!effect.choice.number.empty()) continue;
    ASSERT_TRUE(effect.other_best) << effect.choice.subject;
    EXPECT_TRUE(is_feasible(effect.other_best->evaluation));
    if (is_feasible(effect.evaluation)) {
      EXPECT_GE(effect.other_best->evaluation.objectives[0], effect.evaluation.objectives[0]);
      const bool gains = effect.other_best->evaluation.objectives[0] >
                         (1.0 + gain_of_another_design) * effect.evaluation.objectives[0];
      EXPECT_EQ(effect.changes_design, gains && effect.other_best->point != best.point);
    } else {
      EXPECT_TRUE(effect.changes_design);
    }
  }
}

// Each number is set in the design found, also where the study varies it, at the current of the answer.
TEST(AssumptionEffects, OfNumbersAreThoseOfTheAnswerWithThatNumberSet) {
  const DesignProblem problem(with_one_objective());
  const Record best = answer_of(problem);
  const simulation::EvaluatedDesign answer = std::get<EvaluatedDesign>(problem.evaluate(best.point));
  std::size_t numbers = 0;
  for (const AssumptionEffect& effect : assumption_effects(problem, best, {.evaluations = 0})) {
    if (effect.choice.number.empty() || !effect.evaluation.failure.empty()) continue;
    ++numbers;
    const double gap = 1e3 * effect.choice.design.body.gap;
    if (effect.choice.number != "gap_mm") {
      EXPECT_DOUBLE_EQ(gap, 1e3 * answer.design.body.gap);
    }
    simulation::OperatingPoint point = answer.point;
    point.current = 0.9 * actuator::operating_current_limit(effect.choice.design);
    const simulation::EvaluatedDesign expected = simulation::evaluate(effect.choice.design, point);
    const double speed = quantity("peak_bending_speed_deg_s").value(expected.view()).value();
    // Curves to 1e-4 of themselves move a figure by up to 5e-6, and one of a step in time by some of its steps.
    EXPECT_NEAR(effect.evaluation.objectives.front(), speed, 1e-4 * speed) << effect.choice.otherwise;
    EXPECT_NEAR(effect.gain, speed / best.evaluation.objectives.front() - 1.0, 1e-3) << effect.choice.otherwise;
  }
  EXPECT_GT(numbers, 30U);
}

TEST(AssumptionEffects, LeaveOutWhatScattersInTheSpread) {
  Study study = with_one_objective();
  study.spread = Spread{.scatters = {{.name = "gap_mm", .about = NormalDeviation{0.05}},
                                     {.name = "remanence_T", .about = NormalDeviation{0.015}, .relative = true}}};
  const DesignProblem problem(study);
  const Record best = answer_of(DesignProblem(with_one_objective()));
  std::set<std::string_view> numbers;
  for (const AssumptionEffect& effect : assumption_effects(problem, best, {.evaluations = 0}))
    numbers.insert(effect.choice.number);
  EXPECT_FALSE(numbers.contains("gap_mm"));
  EXPECT_FALSE(numbers.contains("remanence_T"));
  EXPECT_TRUE(numbers.contains("filler"));
  EXPECT_TRUE(numbers.contains("base_tilt_deg"));
}

TEST(Decisive, IsNothingThatItsBuilderDecides) {
  const Study study = with_one_objective();
  const Record best{.point = {}, .evaluation = {.objectives = {1000.0}, .constraints = {-0.1, -1.0}}};
  AssumptionEffect mounting;
  mounting.choice.subject = "mounting";
  mounting.choice.decided = true;
  mounting.evaluation = {.objectives = {500.0}, .constraints = {0.3, -1.0}};
  EXPECT_EQ(decisive(study, best, {mounting}), nullptr);
  EXPECT_TRUE(mounting.matters());
}

AssumptionEffect with_outcome(std::string_view subject, double objective, double constraint) {
  AssumptionEffect effect;
  effect.choice.subject = subject;
  effect.evaluation = {.objectives = {objective}, .constraints = {constraint, -1.0}};
  return effect;
}

TEST(Decisive, IsABrokenLimitBeforeALargeChangeBeforeASmallOne) {
  const Study study = with_one_objective();
  const Record best{.point = {}, .evaluation = {.objectives = {1000.0}, .constraints = {-0.1, -1.0}}};
  const std::vector<AssumptionEffect> effects = {with_outcome("small", 990.0, -0.1), with_outcome("large", 600.0, -0.1),
                                                 with_outcome("broken", 999.0, 0.05)};
  EXPECT_EQ(decisive(study, best, effects)->choice.subject, "broken");
  const std::vector<AssumptionEffect> kept(effects.begin(), effects.begin() + 2);
  EXPECT_EQ(decisive(study, best, kept)->choice.subject, "large");
  EXPECT_EQ(decisive(study, best, {with_outcome("nothing", 995.0, -0.1)}), nullptr);
  EXPECT_EQ(decisive(study, best, {}), nullptr);
}

TEST(Decisive, OfBrokenLimitsIsTheFarthestWhereNoOtherDesignWasLookedFor) {
  const Study study = with_one_objective();
  const Record best{.point = {}, .evaluation = {.objectives = {1000.0}, .constraints = {-0.1, -1.0}}};
  std::vector<AssumptionEffect> effects = {with_outcome("a little", 999.0, 0.05), with_outcome("far", 999.0, 3.0)};
  for (AssumptionEffect& effect : effects) {
    effect.evaluations = 1;
    effect.worst = worst_margin(study, effect.evaluation);
  }
  EXPECT_EQ(decisive(study, best, effects)->choice.subject, "far");
}

TEST(Decisive, IsNoChoiceUnderWhichTheModelCannotBeWorkedOut) {
  const Study study = with_one_objective();
  const Record best{.point = {}, .evaluation = {.objectives = {1000.0}, .constraints = {-0.1, -1.0}}};
  AssumptionEffect extreme = with_outcome("extreme", 0.0, 1.0);
  extreme.evaluation.failure = "shape too extreme to compute";
  extreme.is_built = false;
  EXPECT_EQ(decisive(study, best, {extreme}), nullptr);
  EXPECT_EQ(decisive(study, best, {extreme, with_outcome("small", 900.0, -0.1)})->choice.subject, "small");
}

}  // namespace
}  // namespace coilwright::sizing
