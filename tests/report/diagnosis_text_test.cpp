#include "coilwright/report/diagnosis/diagnosis_text.hpp"

#include <gmock/gmock.h>

#include "report/text_of_diagnosis.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(DiagnosisText, SaysInAMinuteWhatWasAssumedAndFoundAndHowSureThatIs) {
  Diagnosis diagnosis = example();
  diagnosis.next_experiment = {.kind = "hot_hold",
                               .input = "1.05 A for 60 s",
                               .why = "they part when hot",
                               .open_bits = 1.5,
                               .remaining_bits = 0.25,
                               .experiment = {}};
  diagnosis.nominal = {
      {.estimate = {.key = "force_curve", .value = -0.015, .lower = -0.045, .upper = 0.015},
       .declared = 0.0,
       .tolerance = 0.03},
      {.estimate = {.key = "/measured/tip_segment_mass_g", .value = 0.0205, .lower = 0.02, .upper = 0.021},
       .declared = 0.02,
       .tolerance = 0.0005,
       .named = true}};
  diagnosis.probability_of_declared = 0.25;
  diagnosis.held_exact = {"/magnet/remanence_T"};
  diagnosis.noise = {
      {.run = "a.csv", .channel = "bending_angle_deg", .sigma = 0.3 * degree, .given = true, .source = "given"}};
  diagnosis.noise.push_back({.run = "b.csv", .channel = "torque_Nmm", .sigma = 2e-5, .from_the_run = true});
  diagnosis.noise.push_back({.run = "c.csv", .channel = "torque_Nmm", .sigma = 1e-5, .colour = "white, as at rest"});
  diagnosis.outliers = {{.run = "a.csv", .channel = "bending_angle_deg", .times = {0.5, 0.75, 1.0, 1.25, 1.5, 1.75}},
                        {.run = "b.csv", .channel = "bending_angle_deg", .validate = true, .times = {0.25}}};
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.warnings = {{.run = "a.csv", .text = "saturated"}};
  diagnosis.replays = {{.run = "a.csv", .validate = false}, {.run = "b.csv", .validate = true}};
  EXPECT_EQ(text_of(diagnosis), R"(finger-2024-03-11: explained

The declared model lacks dry_friction; with it, what is left over is noise.

Warnings
  a.csv: saturated

What was assumed
  Runs fitted: a.csv
  Runs kept from the fit, for the errors only: b.csv
  Numbers fitted freely:
    joint_stiffness_Nmm_rad  12.4  12.3 to 12.5 (95 %)
    Their intervals, and those of the declared numbers, contain what each of the effects that these data cannot tell apart makes of them; the values are those with the effects reported.
  2 declared numbers could move, each at the price of its tolerance (one standard deviation); in the fit with the effects found:
                                  declared  tolerance       moved to  tolerances moved  95 % interval
    /measured/tip_segment_mass_g        20  0.5                 20.5              +1.0  20 to 21 (95 %)
    force_curve                          0  0.03 (default)    -0.015              -0.5  -0.045 to 0.015 (95 %)
    The numbers of force_curve are a smooth error of the shape of the torque over the angle.
    A name with slashes is a place in the actuator file; its lists count from 0, links from the base.
  Taken as exact (if one of them is wrong, the numbers found have taken its error up):
    /magnet/remanence_T
  Noise, one standard deviation:
    bending_angle_deg: 0.3 deg, given in 1 run
    torque_Nmm: 0.01 to 0.02 Nmm, measured at rest for 1 run, estimated in 1 run
      white, as at rest
  Taken as outliers and left out, because they stand apart from their neighbours as no motion does (all of them in diagnosis.json):
    a.csv, bending_angle_deg: 6 samples at 0.5, 0.75, 1, 1.25, 1.5, ... s
    b.csv, bending_angle_deg: 1 sample at 0.25 s (left out of the errors)

What was found
  dry_friction: Coulomb friction at the hinges
    torque_Nmm  0.61  0.58 to 0.64 (95 %)
    there with a probability of 0.938
  Left over: 1 times the noise, 2.082 without effects (rms, fit runs). It is noise with a probability of 0.875.
  Without any effect the declared numbers would have to be so far off, all together, that 25 % of the rigs built to their tolerances are as far off or further (above 1 %: that may be chance).

Errors on the runs that no fit has seen
  angle, deg  as declared  fitted anew  with effects
    mean              2.9          1.1          0.24
    rmse              3.5          1.4           0.3  noise alone: 0.3
    largest           9.1            5           1.2

How sure, and what else it could be
  One of these is there: less than 0.001 (coil_heating less than 0.001, magnet_heating less than 0.001). These data cannot tell which; the first is reported.
  Not to be ruled out:
    end_stop, with a probability of 0.062
  Compared, most probable first
                      probability  residual     leaves noise
    dry_friction            0.938         1            0.875  reported
    end_stop                0.062     1.041  less than 0.001
    no effect     less than 0.001     2.082  less than 0.001
  probability: given that one of those that were fitted is true. residual: rms on the fit runs over the noise, 1 is noise alone. leaves noise: the probability that what is lacking is less than a tenth of the noise.

What to do next
  Record this run (hot_hold): 1.05 A for 60 s: they part when hot; of 1.5 bits that are open between the explanations it leaves 0.25 on average, or less.
  Once that is done, go on with actuator.json: evaluate and simulate take it.
)");
}

TEST(DiagnosisText, NamesWhatTheEffectMayBeAsWellInItsFirstSentence) {
  Diagnosis diagnosis = example();
  const actuator::EffectCatalogue& effects = actuator::standard_effects();
  diagnosis.indistinguishable = {{diagnosis.effects.front().kind, effects.find("viscoelastic_creep")}};
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("lacks either dry_friction or viscoelastic_creep (these data cannot tell which); with"));
  diagnosis.indistinguishable.front().push_back(effects.find("backlash"));
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("lacks either dry_friction, viscoelastic_creep or backlash (these data cannot tell"));
}

TEST(DiagnosisText, NamesSeveralEffectsInItsFirstSentence) {
  Diagnosis diagnosis = example();
  diagnosis.effects.push_back(stopped());
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("The declared model lacks dry_friction and end_stop; with them, what is left over is noise."));
}

TEST(DiagnosisText, SaysFirstThatTheErrorRisesOnRunsThatNoFitHasSeen) {
  Diagnosis diagnosis = example();
  diagnosis.validate_errors.front().after = degrees(1.3, 1.6, 5.5);
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("noise.\n\nOn the runs that no fit has seen the error of the angle rises from 1.4 without the "
                        "effects to 1.6 deg with them (rmse).\n"));
  EXPECT_THAT(text_of(diagnosis), HasSubstr("What to do next\n  Fit a run of the kind that was kept from the fit"));
  // Less than without them, and more than as declared.
  diagnosis.validate_errors.front().before = degrees(1.5, 1.7, 5.5);
  diagnosis.validate_errors.front().declared = degrees(1.0, 1.2, 4.0);
  EXPECT_THAT(text_of(diagnosis), HasSubstr("rises from 1.2 as declared to 1.6 deg with the effects (rmse).\n"));
  diagnosis.validate_errors = example().validate_errors;
  // A tenth of the noise is no rise.
  diagnosis.validate_errors.front().after = degrees(1.1, 1.42, 5.0);
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("rises")));
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::declared_numbers_off;
  diagnosis.validate_errors.front().declared = degrees(1.0, 1.2, 4.0);
  EXPECT_THAT(text_of(diagnosis), HasSubstr("rises from 1.2 as declared to 1.42 deg fitted anew (rmse).\n"));
}

TEST(DiagnosisText, SaysFirstThatRunsThatNoFitHasSeenAreNotAtTheNoise) {
  Diagnosis diagnosis = example();
  diagnosis.validate_errors.front().after = degrees(0.3, 0.4, 1.5);
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("noise.\n\nBut on the runs that no fit has seen the error of the angle is 0.4 deg (rmse), where "
                "noise alone makes 0.3 deg: they show something that the fitted runs do not.\n"));
  EXPECT_THAT(text_of(diagnosis), HasSubstr("What to do next\n  Fit a run of the kind that was kept from the fit"));
  // Where structure remains, the verdict says it.
  diagnosis.verdict = Verdict::partly_explained;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("where noise alone makes")));
}

TEST(DiagnosisText, SaysHowProbableEachEffectIsAndWhatTheyLeaveTogether) {
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.effects.push_back(stopped());
  diagnosis.odds.hypotheses = {weighed({&end_stop, &dry_friction}, 12000.0, 0.5, 0.9995),
                               weighed({&dry_friction}, 13000.0, 0.25), weighed({}, 48000.0, 0.25)};
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(text, HasSubstr("0.58 to 0.64 (95 %)\n    there with a probability of 0.750\n  end_stop: a stop\n"));
  EXPECT_THAT(
      text,
      HasSubstr("(chosen)\n    there with a probability of 0.500\n"
                "  Left over: 1 times the noise, 2 without effects (rms, fit runs). It is noise with a probability of "
                "more than 0.999.\n"));
}

TEST(DiagnosisText, SaysWhetherWhatIsLeftIsNoiseWhereNoEffectIsReported) {
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::unexplained;
  diagnosis.odds.hypotheses = {weighed({&coil_heating}, 47000.0, 0.625), weighed({}, 48000.0, 0.375, 0.25)};
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("  No effect that the data support.\n  Left over: 2 times the noise (rms, fit runs). It is noise with "
                "a probability of 0.250.\n"));
}

TEST(DiagnosisText, DoubtsNoiseThatIsLargerThanItWasTakenToBe) {
  const std::string doubt =
      "  That is more than the noise is taken to be (above): it is noise only where that level is too low. A still "
      "run "
      "would tell.\n";
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.odds.hypotheses = {weighed({&dry_friction}, 48000.0, 1.0, 0.75), weighed({}, 96000.0, 0.0)};
  EXPECT_THAT(text_of(diagnosis), HasSubstr("It is noise with a probability of 0.750.\n" + doubt));
  diagnosis.odds.hypotheses.front().probability_of_noise = 0.25;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr(doubt)));
  diagnosis.odds.hypotheses.front() = weighed({&dry_friction}, 16000.0, 1.0, 0.75);
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr(doubt)));
}

TEST(DiagnosisText, DoesNotDenyWhatIsThereAndNotSeen) {
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::no_missing_effect;
  diagnosis.odds.hypotheses = {weighed({&coil_heating}, 12000.0, 1.0, 0.75), weighed({}, 12100.0, 1e-9, 0.75)};
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("The declared model lacks nothing that moves it by a tenth of the noise: fitted anew, what "
                        "it leaves is noise with a probability of 0.75.\n"));
  EXPECT_THAT(text, HasSubstr("  No effect that moves anything by a tenth of the noise.\n"));
}

TEST(DiagnosisText, SaysWithTheVerdictThatItIsUncertain) {
  Diagnosis diagnosis = example();
  diagnosis.validate_errors.clear();
  const auto text_with = [&](Verdict verdict, double probability_of_noise) {
    diagnosis.verdict = verdict;
    for (identification::WeighedHypothesis& each : diagnosis.odds.hypotheses)
      each.probability_of_noise = probability_of_noise;
    return text_of(diagnosis);
  };
  EXPECT_THAT(text_with(Verdict::explained, 0.6),
              HasSubstr("lacks dry_friction; with it, what is left over is noise with a probability of 0.60.\n"));
  EXPECT_THAT(text_with(Verdict::partly_explained, 0.4),
              HasSubstr("lacks dry_friction, and perhaps something else: what is left over is noise with a probability "
                        "of 0.40.\n"));
  EXPECT_THAT(text_with(Verdict::partly_explained, 0.1), HasSubstr("structure remains that no effect explains.\n"));
  diagnosis.effects.clear();
  EXPECT_THAT(text_with(Verdict::unexplained, 0.425),
              HasSubstr("may lack something that none of the known effects explains: what is left over is noise with a "
                        "probability of 0.42.\n"));
}

TEST(DiagnosisText, SaysWithTheVerdictWhatTheEffectsAreWorthWhereNothingWasFitted) {
  Diagnosis diagnosis = example();
  diagnosis.verdict = Verdict::partly_explained;
  diagnosis.validate_errors = {comparison(data::ChannelKind::bending_angle, 1000, 0.25 * degree)};
  diagnosis.validate_errors.front().declared.rmse = diagnosis.validate_errors.front().before.rmse = 38.0 * degree;
  diagnosis.validate_errors.front().after.rmse = 3.9 * degree;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("On the runs that no fit has seen it takes the error of the angle from 38 "
                                            "to 3.9 deg (rmse; noise alone: 0.25).\n"));
  // Of noise that is not known nothing is said.
  diagnosis.validate_errors.front().noise_floor_rmse = 0.0;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("from 38 to 3.9 deg (rmse).\n"));
  diagnosis.validate_errors.clear();
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("it takes the error")));
}

TEST(DiagnosisText, MarksEvidenceThatIsALowerBound) {
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.odds.hypotheses = {weighed({&dry_friction}, 12000.0, 0.75, 0.75), weighed({}, 48000.0, 0.25)};
  const std::string footnote = "at least: its fit is not shown to be at its best, and its evidence is a lower bound.";
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr(footnote)));
  diagnosis.odds.hypotheses.back().at_optimum = false;
  EXPECT_THAT(text_of(diagnosis), AllOf(HasSubstr("less than 0.001  at least\n"), HasSubstr(footnote)));
  diagnosis.odds.hypotheses.front().at_optimum = false;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("reported, at least\n"));
}

// Where there is no answer yet, nothing is reported, and nothing is known of what is missing.
TEST(DiagnosisText, ListsWhatWasComparedBeforeADiagnosisWasInterrupted) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::incomplete;
  diagnosis.before = diagnosis.after = {.level = 2.0};
  diagnosis.odds.hypotheses = {weighed({&coil_heating}, 12000.0, 0.75, nan), weighed({}, 48000.0, 0.25, nan)};
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(text, HasSubstr("                  probability  residual  leaves noise\n"
                              "    coil_heating        0.750         1       unknown\n"
                              "    no effect           0.250         2       unknown\n"));
  EXPECT_THAT(text, HasSubstr("  probability: among those that were compared so far, by brief fits. residual:"));
  EXPECT_THAT(text, Not(HasSubstr("What was found")));
}

TEST(DiagnosisText, SaysInItsFirstLinesThatDeclaredNumbersMovedFar) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {
      {.estimate = {.key = "face_closing_deg", .value = -3.4 * degree}, .declared = 4.0 * degree, .tolerance = degree}};
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("with it, what is left over is noise.\n\nEven so declared numbers had to move far, in tolerances: "
                "face_closing_deg by 7.4. Measure them before you rely on this model.\n"));
  diagnosis.nominal.front().estimate.value = 1.5 * degree;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("had to move far")));
}

TEST(DiagnosisText, HasNoColumnWithEffectsWhereThereAreNone) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::no_missing_effect;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("\n  angle, deg  as declared  fitted anew\n"
                                            "    mean              2.9          1.1\n"
                                            "    rmse              3.5          1.4  noise alone: 0.3\n"));
}

TEST(DiagnosisText, BlamesNothingWhereTheCameraMayHaveMadeWhatIsLeft) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::unexplained;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("lacks something, and none of the known effects explains it.\n"));
  diagnosis.noise = {
      {.channel = "bending_angle_deg", .colour = "taken as white: there is no still run", .colour_unknown = true}};
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("unexplained\n\nSomething is left over that none of the known effects explains. Whether the "
                        "finger or the camera makes it, these records cannot tell: none shows the noise of the camera "
                        "by itself.\n"));
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("lacks something")));
  // More than colour makes, or a channel whose own noise is known.
  diagnosis.after.level = 20.0;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("lacks something, and none of the known effects explains it.\n"));
  diagnosis.after.level = 2.0;
  diagnosis.noise.push_back({.channel = "bending_angle_deg", .colour = "white, as the still run"});
  EXPECT_THAT(text_of(diagnosis), HasSubstr("lacks something, and none of the known effects explains it.\n"));
}

TEST(DiagnosisText, AsksForAStillRunWhereNoiseIsTakenForColoured) {
  Diagnosis diagnosis = example();
  diagnosis.noise = {{.channel = "bending_angle_deg", .colour = "taken as white: x", .colour_unknown = true}};
  diagnosis.after.structure = 0.9;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("ten seconds")));
  diagnosis.after.structure = 2.0;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("Record ten seconds of the finger at rest (kind still)"));
}

TEST(DiagnosisText, SaysOnWhatTheRestDependsOnlyWhereStructureRemains) {
  Diagnosis diagnosis = example();
  diagnosis.residual = localise::ResidualTorque{.rms = 0.2e-3,
                                                .noise_floor = 0.05e-3,
                                                .dependences = {{.variable = "sign of rate", .explained = 0.5}},
                                                .frequency = 5.0};
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("What is left over, as a joint torque")));
  diagnosis.verdict = Verdict::partly_explained;
  diagnosis.after.structure = 3.0;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("ten seconds")));
  diagnosis.noise = {{.run = "a.csv",
                      .channel = "bending_angle_deg",
                      .sigma = 0.3 * degree,
                      .colour = "taken as white: x",
                      .colour_unknown = true}};
  EXPECT_THAT(text_of(diagnosis), HasSubstr("Record ten seconds of the finger at rest (kind still)"));
  EXPECT_THAT(text_of(diagnosis), HasSubstr("What is left over, as a joint torque\n"
                                            "  rms 0.2 Nmm, where noise alone gives 0.05 Nmm\n"
                                            "  of its square goes with one variable alone\n"
                                            "    sign of rate  50 %\n"
                                            "  strongest line at 5 Hz\n"
                                            "  worst in step_1.4A.csv, 20 ms: 3 times what noise may show\n"));
  EXPECT_THAT(text_of(diagnosis), HasSubstr("only if nothing is missing; here something is left over.\n"));
  for (localise::Dependence& each : diagnosis.residual->dependences) each.explained = 0.06;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("\n  No single variable explains even a tenth of its square.\n"));
}

}  // namespace
}  // namespace coilwright::report
