#include "coilwright/report/diagnosis_text.hpp"

#include <gmock/gmock.h>

#include "formats/data/diagnosis_by_hand.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;
using ::testing::Not;

std::string text_of(const Diagnosis& diagnosis) {
  return to_text(report_of(diagnosis));
}

TEST(DiagnosisText, SaysInAMinuteWhatWasAssumedAndFoundAndHowSureThatIs) {
  Diagnosis diagnosis = example();
  diagnosis.next_experiment = {
      .kind = "hot_hold", .input = "1.05 A for 60 s", .why = "they part when hot", .separation = 8.5, .experiment = {}};
  diagnosis.nominal = {
      {.estimate = {.key = "force_curve", .value = -0.015}, .declared = 0.0, .tolerance = 0.03},
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
    Their intervals, and those of the declared numbers, contain what each of the effects that these data cannot
    tell apart makes of them; the values are those with the effects reported.
  2 declared numbers could move, each at the price of its tolerance (one standard deviation); in the fit with the effects found:
                                  declared  tolerance       moved to  tolerances moved
    /measured/tip_segment_mass_g        20  0.5                 20.5              +1.0
    force_curve                          0  0.03 (default)    -0.015              -0.5
    The numbers of force_curve are a smooth error of the shape of the torque over the angle.
    A name with slashes is a place in the actuator file; its lists count from 0, links from the base.
  Taken as exact (if one of them is wrong, the numbers found have taken its error up):
    /magnet/remanence_T
  Noise, one standard deviation:
    bending_angle_deg: 0.3 deg, given in 1 run
    torque_Nmm: 0.01 to 0.02 Nmm, measured at rest for 1 run, estimated in 1 run
      white, as at rest
  Taken as outliers and left out, because they stand apart from their neighbours as no motion does
  (all of them in diagnosis.json):
    a.csv, bending_angle_deg: 6 samples at 0.5, 0.75, 1, 1.25, 1.5, ... s
    b.csv, bending_angle_deg: 1 sample at 0.25 s (left out of the errors)

What was found
  dry_friction: Coulomb friction at the hinges
    torque_Nmm  0.61  0.58 to 0.64 (95 %)
    residual on the fit runs: 2.082 times the noise without it, 1 with it (rms)
    on runs left out in turn: takes away 97 % of the squared error above the noise
    not tested on hold.csv: the other runs leave the effect's numbers too open to predict it; record it again
  Without any effect the declared numbers would have to be so far off, all together, that 25 % of the
  rigs built to their tolerances are as far off or further (above 1 %: that may be chance).

Errors on the runs that no fit has seen
  angle, deg  as declared  fitted anew  with effects
    mean              2.9          1.1          0.24
    rmse              3.5          1.4           0.3  noise alone: 0.3
    largest           9.1            5           1.2

How sure, and what else it could be
  These data cannot tell apart: coil_heating, magnet_heating. The simplest of them is reported.

What to do next
  Record this run (hot_hold): 1.05 A for 60 s: they part when hot; the explanations that are left differ there by 8.5 times the noise.
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

TEST(DiagnosisText, SaysWhatATorqueWithoutANameIsAndWhereItHolds) {
  const Diagnosis diagnosis = corrected_example();
  formats::DiagnosisReport report = report_of(diagnosis);
  report.corrected_actuator = "corrected_actuator.json";
  const std::string text = to_text(report);
  EXPECT_THAT(text, HasSubstr(R"(
  angle, deg  as declared  fitted anew  with effects  corrected
    mean              2.9          1.1          0.24        0.2
    rmse              3.5          1.4           0.3       0.25  noise alone: 0.3
    largest           9.1            5           1.2          1
)"));
  EXPECT_THAT(text, HasSubstr(R"(
A torque without a name
  A smooth joint torque over angle and rate takes away 71 % of the squared error above the noise on runs that
  were left out in turn. Nobody knows what it is: it serves until somebody can name it.
  It holds for angle from -5 deg to 40 deg, rate from -90 deg/s to 90 deg/s, and fades beyond.
  It is largest, 0.3 Nmm at angle 40 deg, rate -90 deg/s, and smallest, -0.25 Nmm at angle 40 deg, rate 90 deg/s.
  It is a function of angle times a function of rate (to 97 %).
  It does better without the effects above, and its file leaves them out.
  corrected_actuator.json has it: evaluate and simulate take it, and size where the geometry stays.
)"));
}

TEST(DiagnosisText, AdvisesAgainstATorqueThatMakesWhatNoFitHasSeenWorse) {
  Diagnosis diagnosis = corrected_example();
  diagnosis.validate_errors.front().corrected = degrees(0.3, 0.4, 1.5);
  formats::DiagnosisReport report = report_of(diagnosis);
  report.corrected_actuator = "corrected_actuator.json";
  const std::string text = to_text(report);
  EXPECT_THAT(text, HasSubstr("  But on the runs that no fit has seen the error of the angle rises with it from 0.3 to "
                              "0.4 deg (rmse).\n"
                              "  Do not use corrected_actuator.json, which has it, before a run of that kind is among "
                              "those fitted.\n"));
  EXPECT_THAT(text, Not(HasSubstr("evaluate and simulate take it, and size")));
}

TEST(DiagnosisText, AdvisesAgainstATorqueThatIsWorseThanWhatWasDeclared) {
  Diagnosis diagnosis = corrected_example();
  diagnosis.validate_errors.front().declared = degrees(0.15, 0.2, 0.8);
  EXPECT_THAT(text_of(diagnosis), HasSubstr("the error of the angle rises with it from 0.2 as declared to 0.25 deg "
                                            "(rmse).\n  Do not use "));
}

TEST(DiagnosisText, SaysWhyThereIsNoTorqueWithoutAName) {
  Diagnosis diagnosis = example();
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("without a name")));
  diagnosis.verdict = Verdict::unexplained;
  diagnosis.correction.reason = "With a single motion nothing could show that a correction holds elsewhere.";
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("\nA torque without a name\n  None is offered. With a single motion nothing "
                        "could show that a correction holds elsewhere.\n"));
}

TEST(DiagnosisText, SaysFirstThatTheErrorRisesOnRunsThatNoFitHasSeen) {
  Diagnosis diagnosis = example();
  diagnosis.validate_errors.front().after = degrees(1.3, 1.6, 5.5);
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("noise.\nOn the runs that no fit has seen the error of the angle rises from 1.4 without the "
                        "effects to 1.6 deg with them (rmse).\n"));
  EXPECT_THAT(text_of(diagnosis), HasSubstr("What to do next\n  Fit a run of the kind that was kept from the fit"));
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
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("noise.\nBut on the runs that no fit has seen the error of the angle is 0.4 deg (rmse), where "
                        "noise alone makes 0.3 deg: they show something that the fitted runs do not.\n"));
  EXPECT_THAT(text_of(diagnosis), HasSubstr("What to do next\n  Fit a run of the kind that was kept from the fit"));
  // Where structure remains, the verdict says it.
  diagnosis.verdict = Verdict::partly_explained;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("where noise alone makes")));
}

TEST(DiagnosisText, SaysWhyTheNearestEffectIsNotTheAnswer) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::unexplained;
  diagnosis.compared_hypotheses = {
      {.effects = {&coil_heating}, .evidence = {}, .remark = "fits best where it is absent"}};
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("  No effect that the data support.\n  coil_heating came nearest and is not "
                        "the answer: fits best where it is absent.\n"));
}

TEST(DiagnosisText, SaysWhichNumbersToMeasure) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.indistinguishable.clear();
  diagnosis.verdict = Verdict::declared_numbers_off;
  diagnosis.probability_of_declared = 2e-5;
  diagnosis.nominal = {
      {.estimate = {.key = "/links/0/mass_kg", .value = 0.0202}, .declared = 0.02, .tolerance = 0.0005},
      {.estimate = {.key = "/links/1/mass_kg", .value = 0.0185}, .declared = 0.02, .tolerance = 0.0005}};
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(text, HasSubstr("The declared numbers are off: moved further than their tolerances make likely, they "
                              "explain these data, and no missing effect does so decisively better.\n"));
  EXPECT_THAT(text,
              HasSubstr("that fewer than 0.01 % of the\n  rigs built to their tolerances are as far off or further "
                        "(below 1 %: they are off, or an effect is missing).\n"));
  EXPECT_THAT(text, HasSubstr("What to do next\n"
                              "  Weigh or measure /links/1/mass_kg (declared 0.02, these data say 0.0185), correct the "
                              "actuator file and diagnose again.\n"
                              "  Once that is done, go on with actuator.json: evaluate and simulate take it.\n"));
  // A shape is measured on a bench, once for all of its numbers.
  for (const char* key : {"force_curve_1", "force_curve_2"})
    diagnosis.nominal.push_back({.estimate = {.key = key, .value = 0.2}, .declared = 0.0, .tolerance = 0.03});
  EXPECT_THAT(text_of(diagnosis), HasSubstr("Weigh or measure the torque over the angle at one current (a "
                                            "static_torque bench), whose shape is off, /links/1/mass_kg (declared"));
  diagnosis.nominal.resize(2);
  // None moved far, but together they did.
  diagnosis.nominal[1].estimate.value = 0.0191;
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("Weigh or measure /links/1/mass_kg (declared 0.02, these data say 0.0191),"));
}

TEST(DiagnosisText, SaysWhatTolerancesWereWeighedAgainst) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {
      {.estimate = {.key = "/links/0/mass_kg", .value = 0.0202}, .declared = 0.02, .tolerance = 0.0005}};
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("were weighed against it")));
  diagnosis.model_error = 751.3;
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("    What is missing in the model is far larger than the noise: tolerances were weighed against it, "
                "as if the\n    noise were 751 times as large. Otherwise these numbers would take up what they can "
                "of it.\n"));
}

TEST(DiagnosisText, SaysOfFacesThatTouchNowhereHowFarTheyAreOffAtLeast) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {{.estimate = {.key = "face_closing_deg", .value = -41.0 * degree},
                        .declared = 4.0 * degree,
                        .tolerance = 1.0 * degree,
                        .idle_from = -7.85 * degree}};
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(
      text,
      HasSubstr("declared  tolerance       moved to  tolerances moved\n"
                "    face_closing_deg         4  1 (default)  below -7.85             -11.9\n"
                "    below, above: there the number changes nothing in these records (faces that touch "
                "nowhere). It has moved\n"
                "    that far at least; the records cannot say how much further. actuator.json has it at -41, as if "
                "there were\n    no faces.\n"));
  EXPECT_THAT(text, HasSubstr("declared numbers had to move far, in tolerances: face_closing_deg by 11.9."));
  EXPECT_THAT(text, HasSubstr("What to do next\n"
                              "  Close a joint of the rig by hand, and see where its faces touch: face_closing_deg is "
                              "declared as 4, and these records show no contact down to -7.85. If there are no faces, "
                              "remove \"contact\" from the joints of the actuator file.\n"));
  EXPECT_THAT(text, Not(HasSubstr("Weigh or measure")));
  formats::DiagnosisReport of_a_design = report_of(diagnosis);
  of_a_design.is_design = true;
  EXPECT_THAT(to_text(of_a_design), HasSubstr("no contact down to -7.85.\n"));
}

TEST(DiagnosisText, SaysHowToSeeAnEffectWithoutTheModel) {
  const testing::NamedEffect heated("coil_heating", "", {}, "log voltage and current");
  const testing::NamedEffect faded("magnet_heating", "", {}, "take the magnet's temperature");
  Diagnosis diagnosis = example();
  diagnosis.effects.front().kind = &heated;
  diagnosis.indistinguishable.clear();
  EXPECT_THAT(text_of(diagnosis), HasSubstr("What to do next\n"
                                            "  Check coil_heating without this model: log voltage and current.\n"
                                            "  Once that is done, go on with actuator.json"));
  diagnosis.indistinguishable = {{&heated, &faded}};
  EXPECT_THAT(text_of(diagnosis), HasSubstr("log voltage and current. If it is not there, check magnet_heating: take "
                                            "the magnet's temperature.\n"));
}

TEST(DiagnosisText, SaysInItsFirstLinesThatDeclaredNumbersMovedFar) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {
      {.estimate = {.key = "face_closing_deg", .value = -3.4 * degree}, .declared = 4.0 * degree, .tolerance = degree}};
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("with it, what is left over is noise.\nEven so declared numbers had to move far, in tolerances: "
                "face_closing_deg by 7.4. Measure them before you rely on this model.\n"));
  diagnosis.nominal.front().estimate.value = 1.5 * degree;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("had to move far")));
}

TEST(DiagnosisText, NamesTheCommandsThatTakeTheActuator) {
  const Diagnosis diagnosis = example();
  formats::DiagnosisReport report = report_of(diagnosis);
  EXPECT_THAT(to_text(report), HasSubstr("with actuator.json: evaluate and simulate take it.\n"));
  report.is_design = true;
  EXPECT_THAT(to_text(report), HasSubstr("with actuator.json: evaluate, simulate and the studies of size take it.\n"));
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
  diagnosis.noise = {{.channel = "bending_angle_deg", .colour = "taken as white: there is no still run"}};
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("unexplained\n\nSomething is left over that none of the known effects explains. Whether the "
                        "finger or the camera makes it,\nthese records cannot tell: none shows the noise of the camera "
                        "by itself.\n"));
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("lacks something")));
  // More than colour makes, or a channel whose own noise is known.
  diagnosis.after.level = 20.0;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("lacks something, and none of the known effects explains it.\n"));
  diagnosis.after.level = 2.0;
  diagnosis.noise.push_back({.channel = "bending_angle_deg", .colour = "white, as the still run"});
  EXPECT_THAT(text_of(diagnosis), HasSubstr("lacks something, and none of the known effects explains it.\n"));
}

TEST(DiagnosisText, ExplainsTheNamesOfDifferences) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {{.estimate = {.key = "joint_damping_ratio", .value = 0.1}, .declared = 0.0, .tolerance = 0.1},
                       {.estimate = {.key = "force_curve_1", .value = 0.01}, .declared = 0.0, .tolerance = 0.05}};
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("    A ratio of the joints is how much more the second has than the first, over their mean.\n"
                "    The numbers of force_curve are a smooth error of the shape of the torque over the angle.\n"));
}

TEST(DiagnosisText, WarnsOfNumbersFromAFitThatDoesNotReachTheNoise) {
  Diagnosis diagnosis = example();
  diagnosis.verdict = Verdict::unexplained;
  diagnosis.effects.clear();
  diagnosis.indistinguishable.clear();
  diagnosis.nominal = {
      {.estimate = {.key = "joint_stiffness_ratio", .value = 0.42}, .declared = 0.0, .tolerance = 0.06}};
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("Do not copy the numbers that moved into the actuator file: they may have taken up what "
                        "is missing. Measure by other means joint_stiffness_ratio (declared 0, moved to 0.42).\n"));
  EXPECT_THAT(text, Not(HasSubstr("correct the actuator file")));
}

TEST(DiagnosisText, SaysOnWhatTheRestDependsOnlyWhereStructureRemains) {
  Diagnosis diagnosis = example();
  diagnosis.residual = localise::ResidualTorque{.rms = 0.2e-3,
                                                .noise_floor = 0.05e-3,
                                                .dependences = {{.variable = "sign of rate", .explained = 0.5}},
                                                .frequency = 5.0};
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("What is left over, as a joint torque")));
  diagnosis.verdict = Verdict::partly_explained;
  diagnosis.after.whiteness_ratio = 3.0;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("ten seconds")));
  diagnosis.noise = {
      {.run = "a.csv", .channel = "bending_angle_deg", .sigma = 0.3 * degree, .colour = "taken as white: x"}};
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

TEST(DiagnosisText, SaysWhereNothingIsMissingWhatWouldTellHowSmallThatIs) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::no_missing_effect;
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("What to do next\n  To learn how small an effect these runs could have shown, describe them as an "
                "experiment and run plan: a smaller one may still be there.\n"));
}

TEST(DiagnosisText, SaysWhichSideOfAnIntervalIsOpen) {
  Diagnosis diagnosis = example();
  compare::Estimate& estimate = diagnosis.effects[0].parameters[0];
  estimate.upper = infinity;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("0.61  at least 0.58 (95 %)"));
  estimate = {.key = estimate.key, .value = 0.61e-3, .lower = -infinity, .upper = 0.64e-3};
  EXPECT_THAT(text_of(diagnosis), HasSubstr("0.61  at most 0.64 (95 %)"));
  estimate.determined = false;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("0.61  not determined by these data"));
}

TEST(DiagnosisText, SaysOfAChoiceThatItIsOne) {
  Diagnosis diagnosis = example();
  diagnosis.effects = {stopped()};
  EXPECT_THAT(text_of(diagnosis), HasSubstr("  end_stop: a stop\n"
                                            "    angle_deg  40  39 to 41 (95 %)\n"
                                            "    side       -1  (chosen)\n"));
}

TEST(DiagnosisText, HasAsManyDigitsAsAnIntervalBears) {
  Diagnosis diagnosis = example();
  compare::Estimate& estimate = diagnosis.effects[0].parameters[0];
  estimate.value = 12.50034e-3;
  estimate.lower = 12.49921e-3;
  estimate.upper = 12.50147e-3;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("torque_Nmm  12.5003  12.4992 to 12.5015 (95 %)"));
  estimate.lower = 3.456e-3;
  estimate.upper = 25.0e-3;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("torque_Nmm  12.5  3.46 to 25 (95 %)"));
}

// One run of a kind cannot show whether what explains it is right: the way out is another one.
TEST(DiagnosisText, AsksForRepeatsWhereWhatFitsBestDoesNotHoldOnRunsLeftOut) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.indistinguishable.clear();
  diagnosis.verdict = Verdict::unexplained;
  compare::Evidence evidence{.chi_square_before = 30000.0, .chi_square_after = 12000.0, .quasi_bic_gain = 900.0};
  diagnosis.compared_hypotheses = {
      {.effects = {&coil_heating}, .evidence = evidence, .remark = std::string(compare::worse_on_runs_left_out)}};
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("What to do next\n  Record each motion once more and diagnose again. coil_heating explains most "
                "of the runs that were fitted, and makes runs worse that are left out in turn: "));
  // What explains little would not with more runs either.
  diagnosis.compared_hypotheses.front().evidence->chi_square_after = 29000.0;
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("Record each motion once more")));
}

TEST(DiagnosisText, NamesTheRunsThatTheToolHeldOut) {
  const Diagnosis diagnosis = example();
  formats::DiagnosisReport report = report_of(diagnosis);
  report.held_out = {"b.csv", "f.csv"};
  EXPECT_THAT(to_text(report), HasSubstr("Chosen for that by the tool, because the set names none: b.csv, f.csv\n"));
}

}  // namespace
}  // namespace coilwright::report
