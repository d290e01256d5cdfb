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

TEST(DiagnosisText, SaysInAMinuteWhatIsMissingAndHowSureThatIs) {
  Diagnosis diagnosis = example();
  diagnosis.next_experiment = {
      .kind = "hot_hold", .input = "1.05 A for 60 s", .why = "they part when hot", .separation = 8.5};
  diagnosis.noise = {
      {.run = "a.csv", .channel = "bending_angle_deg", .sigma = 0.3 * degree, .given = true, .source = "given"}};
  diagnosis.noise.push_back({.run = "b.csv", .channel = "torque_Nmm", .sigma = 2e-5, .source = "estimated from x"});
  diagnosis.noise.push_back({.run = "c.csv", .channel = "torque_Nmm", .sigma = 1e-5, .source = "estimated from y"});
  diagnosis.warnings = {{.run = "a.csv", .text = "saturated"}};
  diagnosis.replays = {{.run = "a.csv", .validate = false}, {.run = "b.csv", .validate = true}};
  EXPECT_EQ(text_of(diagnosis),
            "finger-2024-03-11: explained\n"
            "\n"
            "The declared model lacks dry_friction; with it, what is left over is noise.\n"
            "\n"
            "Warnings\n"
            "  a.csv: saturated\n"
            "\n"
            "What it lacks\n"
            "  dry_friction: Coulomb friction at the hinges\n"
            "    torque_Nmm  0.61  0.58 to 0.64 (95 %)\n"
            "    chi^2 on the fit runs 5.2e+04 -> 1.2e+04; takes away 97 % of the error above the noise on runs left "
            "out in turn\n"
            "\n"
            "Errors on the runs that no fit has seen\n"
            "  angle, deg  as declared  fitted anew  with effects\n"
            "    mean              2.9          1.1          0.24\n"
            "    rmse              3.5          1.4           0.3  noise alone: 0.3\n"
            "    largest           9.1            5           1.2\n"
            "\n"
            "What else it could be\n"
            "  these data cannot tell apart: coil_heating, magnet_heating\n"
            "\n"
            "The experiment that would tell\n"
            "  hot_hold: 1.05 A for 60 s\n"
            "  they part when hot (predictions differ by 8.5 times the noise)\n"
            "\n"
            "Declared numbers, fitted anew\n"
            "  joint_stiffness_Nmm_rad  12.4  12.3 to 12.5 (95 %)\n"
            "\n"
            "Noise\n"
            "  bending_angle_deg  0.3 deg in 1 run, given\n"
            "  torque_Nmm         0.01 to 0.02 Nmm in 2 runs, estimated (diagnosis.json says how)\n"
            "\n"
            "Runs\n"
            "  fitted: a.csv\n"
            "  kept from the fit: b.csv\n");
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
  EXPECT_THAT(text_of(diagnosis), HasSubstr("What is left over, as a joint torque\n"
                                            "  rms 0.2 Nmm, where noise alone gives 0.05 Nmm\n"
                                            "  depends\n"
                                            "    on sign of rate  50 %\n"
                                            "  strongest line at 5 Hz\n"
                                            "  worst in step_1.4A.csv, 20 ms (3 times what noise may show)\n"));
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

TEST(DiagnosisText, PutsTheHypothesesComparedIntoColumns) {
  Diagnosis diagnosis = example();
  const auto with_chi_square = [](double value) {
    return compare::Evidence{.chi_square_after = value, .correlation_time = 4.0};
  };
  diagnosis.compared_hypotheses = {
      {.effects = {&coil_heating, &magnet_heating}, .evidence = with_chi_square(444.25), .remark = ""},
      {.effects = {&dry_friction}, .evidence = with_chi_square(12000.0), .remark = "interval includes absent"},
      {.effects = {}, .evidence = with_chi_square(52000.0), .remark = ""},
      {.effects = {&coil_heating}, .evidence = {}, .remark = "no coils"}};
  EXPECT_THAT(text_of(diagnosis), HasSubstr("Compared, best first\n"
                                            "                                   chi^2\n"
                                            "  coil_heating + magnet_heating    444.2\n"
                                            "  dry_friction                   1.2e+04  interval includes absent\n"
                                            "  no effect                      5.2e+04\n"
                                            "  coil_heating                      none  no coils\n"));
}

TEST(DiagnosisText, NamesTheRunsThatTheToolHeldOut) {
  const Diagnosis diagnosis = example();
  formats::DiagnosisReport report = report_of(diagnosis);
  report.held_out = {"b.csv", "f.csv"};
  EXPECT_THAT(to_text(report), HasSubstr("chosen for that by the tool (the set names none): b.csv, f.csv\n"));
}

}  // namespace
}  // namespace coilwright::report
