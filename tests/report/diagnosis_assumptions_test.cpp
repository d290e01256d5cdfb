#include "coilwright/report/diagnosis/diagnosis_text.hpp"

#include <gmock/gmock.h>

#include "report/text_of_diagnosis.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(DiagnosisAssumptions, SaysWhatTolerancesWereWeighedAgainst) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {
      {.estimate = {.key = "/links/0/mass_kg", .value = 0.0202}, .declared = 0.02, .tolerance = 0.0005}};
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("were weighed against it")));
  diagnosis.model_error = 751.3;
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("    What is missing in the model is far larger than the noise: tolerances were weighed against it, "
                "as if the noise were 751 times as large. Otherwise these numbers would take up what they can "
                "of it.\n"));
}

TEST(DiagnosisAssumptions, SaysOfFacesThatTouchNowhereHowFarTheyAreOffAtLeast) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {{.estimate = {.key = "face_closing_deg", .value = -41.0 * degree},
                        .declared = 4.0 * degree,
                        .tolerance = 1.0 * degree,
                        .idle_from = -7.85 * degree}};
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(
      text, HasSubstr("declared  tolerance       moved to  tolerances moved  95 % interval\n"
                      "    face_closing_deg         4  1 (default)  below -7.85             -11.9\n"
                      "    below, above: there the number changes nothing in these records (faces that touch "
                      "nowhere). It has moved "
                      "that far at least; the records cannot say how much further. actuator.json has it at -41, as if "
                      "there were no faces.\n"));
  EXPECT_THAT(text, HasSubstr("declared numbers had to move far, in tolerances: face_closing_deg by 11.9."));
  EXPECT_THAT(text, HasSubstr("What to do next\n"
                              "  Close a joint of the rig by hand, and see where its faces touch: face_closing_deg is "
                              "declared as 4, and these records show no contact down to -7.85. If there are no faces, "
                              "remove \"contact\" from the joints of the actuator file.\n"));
  EXPECT_THAT(text, Not(HasSubstr("Weigh or measure")));
  formats::DiagnosisReport of_a_design = report_of(diagnosis);
  of_a_design.is_design = true;
  EXPECT_THAT(to_text(document_of(of_a_design)), HasSubstr("no contact down to -7.85.\n"));
}

TEST(DiagnosisAssumptions, ExplainsTheNamesOfDifferences) {
  Diagnosis diagnosis = example();
  diagnosis.nominal = {{.estimate = {.key = "joint_damping_ratio", .value = 0.1}, .declared = 0.0, .tolerance = 0.1},
                       {.estimate = {.key = "force_curve_1", .value = 0.01}, .declared = 0.0, .tolerance = 0.05}};
  EXPECT_THAT(
      text_of(diagnosis),
      HasSubstr("    A ratio of the joints is how much more the second has than the first, over their mean.\n"
                "    The numbers of force_curve are a smooth error of the shape of the torque over the angle.\n"));
}

TEST(DiagnosisAssumptions, NamesTheRunsThatTheToolHeldOut) {
  const Diagnosis diagnosis = example();
  formats::DiagnosisReport report = report_of(diagnosis);
  report.held_out = {"b.csv", "f.csv"};
  EXPECT_THAT(to_text(document_of(report)),
              HasSubstr("Chosen for that by the tool, because the set names none: b.csv, f.csv\n"));
}

}  // namespace
}  // namespace coilwright::report
