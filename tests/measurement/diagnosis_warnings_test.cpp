#include "measurement/diagnosis_warnings.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/identification/slide_fits.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A mass of 2 kg on a spring: it rings at `frequency` Hz.
replay::DeclaredModel spring(double frequency) {
  replay::DeclaredModel out = slide(true_mass, 0.1);
  const double turn = 2.0 * std::numbers::pi * frequency;
  out.build = [stiffness = true_mass * turn * turn](std::span<const double> values) {
    actuator::ModelSpec spec = slide(true_mass, 0.1).build(values);
    spec.hinges.front().stiffness = stiffness;
    return spec;
  };
  return out;
}

// A set of 100 pictures a second, with what a diagnosis says of its noise and its residual.
struct Found {
  data::Run run = slide_run(100, {}, no_error);
  std::vector<replay::PreparedRun> runs{{.run = &run, .noise = {{.colour = "white, as the still run"}}}};
  Diagnosis diagnosis{.verdict = Verdict::no_missing_effect,
                      .calibration = {{.key = "mass", .value = true_mass}, {.key = "damping", .value = 0.1}}};
  Found() = default;
  Found(const Found&) = delete;
  Found& operator=(const Found&) = delete;

  [[nodiscard]] std::vector<std::string> texts(const replay::DeclaredModel& declared) const {
    std::vector<std::string> out;
    for (const data::Warning& each : warnings_of(diagnosis, runs, declared)) out.push_back(each.text);
    return out;
  }
};

TEST(DiagnosisWarnings, SayFromWhichRateOnRingingShows) {
  Found found;
  found.diagnosis.after = {.level = 1.0};
  EXPECT_THAT(found.texts(spring(12.0)), IsEmpty());  // 8.3 pictures a period
  const auto texts = found.texts(spring(20.0));
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(
      texts.front(),
      "100 samples a second are 5 a period of the slowest ringing (20 Hz): damping, friction and lags look alike; "
      "from 160 a second they show apart");
  EXPECT_THAT(found.texts(slide(true_mass, 0.1)), IsEmpty());  // does not ring
}

TEST(DiagnosisWarnings, DoNotTakeAClockThatJumpsForASlowCamera) {
  Found found;
  found.diagnosis.after = {.level = 1.0};
  for (std::size_t i = 50; i < found.run.times.size(); ++i) found.run.times[i] += 30.0;
  EXPECT_THAT(found.texts(spring(12.0)), IsEmpty());
}

TEST(DiagnosisWarnings, SayThatAnExposureBlursRinging) {
  Found found;
  found.diagnosis.after = {.level = 1.0};
  found.run.clock.exposure = 0.02;
  EXPECT_THAT(found.texts(spring(12.0)), IsEmpty());
  found.run.clock.exposure = 0.025;
  const auto texts = found.texts(spring(12.0));
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts.front(), "an exposure of 25 ms blurs ringing at 12 Hz; at most 21 ms show it");
}

TEST(DiagnosisWarnings, SayThatALagIsTooShortForThePictures) {
  const actuator::EffectCatalogue catalogue = actuator::standard_effects();
  Found found;
  found.diagnosis.verdict = Verdict::explained;
  found.diagnosis.after = {.level = 1.0};
  for (const actuator::EffectKind* kind : catalogue.kinds())
    if (kind->id() == "measurement_delay")
      found.diagnosis.effects = {{.kind = kind, .parameters = {{.key = "delay_ms", .value = -0.0015}}}};
  const auto texts = found.texts(slide(true_mass, 0.1));
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts.front(),
            "measurement_delay of 1.5 ms is less than a fifth of the 10 ms between samples, which do not show it; 134 "
            "samples a second would");
  found.diagnosis.effects.front().parameters.front().value = 0.0025;
  EXPECT_THAT(found.texts(slide(true_mass, 0.1)), IsEmpty());
}

TEST(DiagnosisWarnings, SayWhenColouredNoiseMayBeTakenForStructure) {
  Found found;
  found.diagnosis.verdict = Verdict::unexplained;
  found.diagnosis.after = {.level = 1.2, .structure = 3.0};
  EXPECT_THAT(found.texts(slide(true_mass, 0.1)), IsEmpty());  // a still run tells
  found.runs.front().noise.front().colour_unknown = true;
  const auto texts = found.texts(slide(true_mass, 0.1));
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_THAT(texts.front(), HasSubstr("cannot be told from a missing effect; ten seconds of a still finger"));
  found.diagnosis.verdict = Verdict::no_missing_effect;
  found.diagnosis.after.level = 1.0;
  EXPECT_THAT(found.texts(slide(true_mass, 0.1)), IsEmpty());  // no size was given that it could have
  found.runs.front().noise.front().given = true;
  EXPECT_THAT(found.texts(slide(true_mass, 0.1)), ElementsAre(HasSubstr("it is taken for that noise")));
  found.diagnosis.after.structure = 0.9;
  EXPECT_THAT(found.texts(slide(true_mass, 0.1)), IsEmpty());
}

// A zero that is off by ten deviations of the noise, in as many of three runs as asked for.
std::optional<data::Warning> support_of_a_zero_in(int runs_with_it) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  std::vector<data::Run> recorded;
  for (int i = 0; i < 3; ++i) {
    recorded.push_back(slide_run(100, {}, [&] { return i < runs_with_it ? 10.0 * noise_sigma : 0.0; }));
    recorded.back().name = std::string(1, static_cast<char>('a' + i)) + ".csv";
  }
  std::vector<replay::PreparedRun> runs;
  for (const data::Run& run : recorded)
    runs.push_back(replay::prepare_run(run, declared, identification::model_of(declared)));
  const actuator::EffectKind* zero = actuator::standard_effects().find("angle_offset");
  return support_in_one_run(
      runs, identification::fitted_to(runs, declared, {}).fit,
      identification::fitted_to(runs, declared, {{.kind = zero, .values = {10.0 * noise_sigma}}}).fit);
}

TEST(SupportInOneRun, NamesTheRunThatAloneSpeaksForAnEffect) {
  const auto alone = support_of_a_zero_in(1);
  ASSERT_TRUE(alone.has_value());
  EXPECT_EQ(alone->run, "a.csv");
  EXPECT_THAT(alone->text, HasSubstr("100 % of what the effects explain is in this run alone"));
  EXPECT_FALSE(support_of_a_zero_in(2).has_value());
  EXPECT_FALSE(support_of_a_zero_in(3).has_value());
}

}  // namespace
}  // namespace coilwright::measurement
