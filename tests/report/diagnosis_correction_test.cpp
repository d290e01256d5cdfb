#include "coilwright/report/diagnosis/diagnosis_text.hpp"

#include <gmock/gmock.h>

#include "report/text_of_diagnosis.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(DiagnosisCorrection, SaysWhatATorqueWithoutANameIsAndWhereItHolds) {
  const Diagnosis diagnosis = corrected_example();
  formats::DiagnosisReport report = report_of(diagnosis);
  report.corrected_actuator = "corrected_actuator.json";
  const std::string text = to_text(document_of(report));
  EXPECT_THAT(text, HasSubstr(R"(
  angle, deg  as declared  fitted anew  with effects  corrected
    mean              2.9          1.1          0.24        0.2
    rmse              3.5          1.4           0.3       0.25  noise alone: 0.3
    largest           9.1            5           1.2          1
)"));
  EXPECT_THAT(text, HasSubstr(R"(
A torque without a name
  A smooth joint torque over angle and rate takes away 71 % of the squared error above the noise on runs that were left out in turn. Nobody knows what it is: it serves until somebody can name it.
  It holds for angle from -5 deg to 40 deg, rate from -90 deg/s to 90 deg/s, and fades beyond.
  It is largest, 0.3 Nmm at angle 40 deg, rate -90 deg/s, and smallest, -0.25 Nmm at angle 40 deg, rate 90 deg/s.
  It is a function of angle times a function of rate (to 97 %).
  It does better without the effects above, and its file leaves them out.
  corrected_actuator.json has it: evaluate and simulate take it, and size where the geometry stays.
)"));
}

TEST(DiagnosisCorrection, AdvisesAgainstATorqueThatMakesWhatNoFitHasSeenWorse) {
  Diagnosis diagnosis = corrected_example();
  diagnosis.validate_errors.front().corrected = degrees(0.3, 0.4, 1.5);
  formats::DiagnosisReport report = report_of(diagnosis);
  report.corrected_actuator = "corrected_actuator.json";
  const std::string text = to_text(document_of(report));
  EXPECT_THAT(text, HasSubstr("  But on the runs that no fit has seen the error of the angle rises with it from 0.3 to "
                              "0.4 deg (rmse).\n"
                              "  Do not use corrected_actuator.json, which has it, before a run of that kind is among "
                              "those fitted.\n"));
  EXPECT_THAT(text, Not(HasSubstr("evaluate and simulate take it, and size")));
}

TEST(DiagnosisCorrection, AdvisesAgainstATorqueThatIsWorseThanWhatWasDeclared) {
  Diagnosis diagnosis = corrected_example();
  diagnosis.validate_errors.front().declared = degrees(0.15, 0.2, 0.8);
  EXPECT_THAT(text_of(diagnosis), HasSubstr("the error of the angle rises with it from 0.2 as declared to 0.25 deg "
                                            "(rmse).\n  Do not use "));
}

TEST(DiagnosisCorrection, SaysWhyThereIsNoTorqueWithoutAName) {
  Diagnosis diagnosis = example();
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("without a name")));
  diagnosis.verdict = Verdict::unexplained;
  diagnosis.correction.reason = "With a single motion nothing could show that a correction holds elsewhere.";
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("\nA torque without a name\n  None is offered. With a single motion nothing "
                        "could show that a correction holds elsewhere.\n"));
}

}  // namespace
}  // namespace coilwright::report
