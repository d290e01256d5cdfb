#include "measurement/compare/cross_validation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::compare {
namespace {

// Two slides, the second one `factor` times as heavy and as damped: the same forces move it by so much less.
std::vector<data::Run> two_slides(double factor) {
  Normal normal(5);
  const auto noise = [&] { return noise_sigma * normal(); };
  std::vector<data::Run> out{slide_run(300, {}, noise), slide_run(300, {}, no_error)};
  out.back().name = "second.csv";
  for (double& value : out.back().channels.front().values) value = value / factor + noise();
  return out;
}

struct Slides {
  explicit Slides(double factor) : Slides(two_slides(factor)) {}
  explicit Slides(std::vector<data::Run> recorded)
      : data(std::move(recorded)), declared(slide(true_mass, true_damping)) {
    const fit::Hypothesis none(declared, {});
    for (const data::Run& run : data) runs.push_back(replay::prepare_run(run, declared, none.model_at(none.start())));
  }
  [[nodiscard]] FittedHypothesis fitted(const fit::Hypothesis& hypothesis) const {
    auto found = fit::fit({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
    EXPECT_TRUE(found.has_value());
    return score(runs, hypothesis, std::move(*found));
  }
  // Chi-square of both runs, each at the fit of the other one alone.
  [[nodiscard]] double each_by_the_other(const fit::Hypothesis& hypothesis) const {
    double sum = 0.0;
    for (std::size_t r = 0; r < 2; ++r) {
      const std::span<const replay::PreparedRun> all(runs);
      const auto other =
          fit::fit({.hypothesis = &hypothesis, .runs = all.subspan(1 - r, 1), .start = hypothesis.start()});
      EXPECT_TRUE(other.has_value());
      const auto here =
          fit::evaluate_at({.hypothesis = &hypothesis, .runs = all.subspan(r, 1), .start = other->values});
      EXPECT_TRUE(here.has_value());
      sum += here->chi_square;
    }
    return sum;
  }

  std::vector<data::Run> data;
  replay::DeclaredModel declared;
  std::vector<replay::PreparedRun> runs{};
};

// With and without an effect, by fits that are taken to their end.
void expect_gain_of_whole_fits(double factor) {
  const Slides slides(factor);
  const fit::Hypothesis without(slides.declared, {});
  const actuator::Effect friction{.kind = actuator::standard_effects().find("dry_friction"), .values = {0.05}};
  const fit::Hypothesis with(slides.declared, {friction});
  const double left_without = slides.each_by_the_other(without);
  const double gain = (left_without - slides.each_by_the_other(with)) / (left_without - 600.0);
  const double found = cross_validated(slides.runs, slides.fitted(without), slides.fitted(with), 1.0).gain;
  EXPECT_NEAR(found, gain, 0.05) << "for slides whose masses differ by a factor of " << factor;
}

TEST(CrossValidation, IsThatOfWholeFitsWhereRunsDisagreeALittle) {
  expect_gain_of_whole_fits(1.03);
}

// From the fit to both runs it is far to that of either: a step by derivatives of there ends anywhere.
TEST(CrossValidation, IsThatOfWholeFitsWhereRunsDisagreeMuch) {
  expect_gain_of_whole_fits(1.3);
  expect_gain_of_whole_fits(3.0);
}

// A wall that one of three slides touches: nothing but its own run tells how stiff it is, and what the others predict
// of it is no evidence against the wall.
TEST(CrossValidation, DoesNotCountARunThatTheOthersCannotPredict) {
  constexpr double wall = 0.2;
  constexpr double stiffness = 50.0;
  const double damping = 0.6 * std::sqrt(stiffness * true_mass);  // as the effect has it
  Normal normal(8);
  std::vector<data::Run> data;
  for (const double force : {0.1, 1.0, 0.08}) {
    data::Run run = slide_run(300, {}, no_error);
    Place place;
    for (std::size_t i = 0; i < run.times.size(); ++i) {
      run.inputs[i] = {i == 0 ? 0.0 : force * force_at(i)};  // at rest away from the wall
      run.channels.front().values[i] = place.position + noise_sigma * normal();
      constexpr int parts = 100;
      for (int part = 0; part < parts; ++part) {  // the semi-implicit rule in steps of 0.1 ms
        const double step = interval / parts;
        const double press = place.position < wall ? 0.0 : stiffness * (place.position - wall) + damping * place.speed;
        place.speed += step * (run.inputs[i].front() - true_damping * place.speed - std::max(0.0, press)) / true_mass;
        place.position += step * place.speed;
      }
    }
    data.push_back(std::move(run));
  }
  const Slides slides(std::move(data));
  const fit::Hypothesis without(slides.declared, {});
  const actuator::Effect stop{.kind = actuator::standard_effects().find("end_stop"), .values = {wall, stiffness, 1.0}};
  const fit::Hypothesis with(slides.declared, {stop});
  const CrossValidation found = cross_validated(slides.runs, slides.fitted(without), slides.fitted(with), 1.0);
  EXPECT_EQ(found.unpredictable_runs, std::vector<std::size_t>{1});
  EXPECT_GT(found.gain, 0.0);
}

}  // namespace
}  // namespace coilwright::measurement::compare
