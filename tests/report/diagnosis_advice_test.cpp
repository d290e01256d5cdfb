#include "coilwright/report/diagnosis/diagnosis_text.hpp"

#include <gmock/gmock.h>

#include <optional>

#include "report/text_of_diagnosis.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(DiagnosisAdvice, SaysWhichNumbersToMeasure) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.indistinguishable.clear();
  diagnosis.verdict = Verdict::declared_numbers_off;
  diagnosis.probability_of_declared = 2e-5;
  diagnosis.nominal = {
      {.estimate = {.key = "/links/0/mass_kg", .value = 0.0202}, .declared = 0.02, .tolerance = 0.0005},
      {.estimate = {.key = "/links/1/mass_kg", .value = 0.0185}, .declared = 0.02, .tolerance = 0.0005}};
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("The declared numbers are off, most of all /links/1/mass_kg (3.0 tolerances): moved further "
                        "than their tolerances make likely, they explain these data, and no missing effect does so "
                        "decisively better.\n"));
  EXPECT_THAT(text, HasSubstr("that fewer than 0.01 % of the rigs built to their tolerances are as far off or further "
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
  // Faces that are not there are looked at, and explain it.
  diagnosis.nominal.push_back({.estimate = {.key = "face_closing_deg", .value = -0.7},
                               .declared = 0.07,
                               .tolerance = 0.0175,
                               .idle_from = -0.08});
  EXPECT_THAT(text_of(diagnosis), HasSubstr("are off, most of all face_closing_deg (8.6 tolerances): moved"));
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("Weigh or measure")));
}

TEST(DiagnosisAdvice, SaysHowToSeeAnEffectWithoutTheModel) {
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

TEST(DiagnosisAdvice, NamesTheCommandsThatTakeTheActuator) {
  const Diagnosis diagnosis = example();
  formats::DiagnosisReport report = report_of(diagnosis);
  EXPECT_THAT(to_text(document_of(report)), HasSubstr("with actuator.json: evaluate and simulate take it.\n"));
  report.is_design = true;
  EXPECT_THAT(to_text(document_of(report)),
              HasSubstr("with actuator.json: evaluate, simulate and the studies of size take it.\n"));
}

TEST(DiagnosisAdvice, WarnsOfNumbersFromAFitThatDoesNotReachTheNoise) {
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

TEST(DiagnosisAdvice, SaysWhereNothingIsMissingWhatWouldTellHowSmallThatIs) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::no_missing_effect;
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("What to do next\n  To learn how small an effect these runs could have shown, describe them as an "
                "experiment and run plan: a smaller one may still be there.\n"));
}

TEST(DiagnosisAdvice, BeginsWithPicturesThatStandStill) {
  Diagnosis diagnosis = example();
  diagnosis.verdict = Verdict::partly_explained;
  diagnosis.frozen_runs = {"a.csv", "b.csv"};
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("CHECK THE CAMERA first. The pictures of a.csv, b.csv stand still for a while, and were "
                        "fitted as if the finger had stopped.\n"));
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("What to do next\n  Leave the pictures that stand still out of a.csv, b.csv (the warnings say "
                        "from when on), and diagnose again: "));
}

// A fit is not bound by what a magnet can be.
TEST(DiagnosisAdvice, DoesNotSendOnToCommandsThatRefuseTheActuator) {
  const Diagnosis diagnosis = corrected_example();
  formats::DiagnosisReport report = report_of(diagnosis);
  report.corrected_actuator = "corrected_actuator.json";
  report.refused = {"actuator.json: /magnet: must be less; got more", "corrected_actuator.json: the same"};
  const std::string text = to_text(document_of(report));
  EXPECT_THAT(text, HasSubstr("\nBut it needs a number that no actuator has, and the other commands refuse the file: "
                              "actuator.json: /magnet: must be less; got more.\n"));
  EXPECT_THAT(text,
              HasSubstr("  Do not build on actuator.json. Look at the units of the records and at the declared "));
  EXPECT_THAT(text, HasSubstr("  corrected_actuator.json has it.\n"));
  EXPECT_THAT(text, Not(HasSubstr("take it")));
}

// Effects stand in for what the rig did: that is said before them.
TEST(DiagnosisAdvice, BeginsWithRunsThatDoNotAnswerTheirInput) {
  Diagnosis diagnosis = example();
  diagnosis.unanswered_runs = {{.run = "a.csv", .text = "keeps within little"},
                               {.run = "b.csv", .text = "keeps within less"}};
  diagnosis.warnings = diagnosis.unanswered_runs;
  diagnosis.far_first_pose = std::nullopt;
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("is noise.\n\nCHECK THE RECORDS first. a.csv: keeps within little.\n\nAlike in b.csv.\n"));
  EXPECT_THAT(text, Not(HasSubstr("keeps within less")));  // one text is enough; the others are in diagnosis.json
  EXPECT_THAT(text, HasSubstr("What to do next\n  Look at the film and the wiring of a.csv, b.csv. Where no current "
                              "flowed, leave the run out, or end its record before that, and diagnose again, before "
                              "anything else.\n"));
}

TEST(DiagnosisAdvice, AsksForARunThatJudgesWhereNoneWasKept) {
  Diagnosis diagnosis = example();
  const std::string words = "  Record a further run and give it the role validate";
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr(words)));
  diagnosis.validate_errors.clear();
  EXPECT_THAT(text_of(diagnosis), HasSubstr(words));
}

}  // namespace
}  // namespace coilwright::report
