#include <gmock/gmock.h>

#include "coilwright/report/diagnosis/diagnosis_text.hpp"
#include "report/text_of_diagnosis.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;

// Free, with what the interval is of.
identification::NumberOff off(const char* name, double value, double half_width, double gain) {
  return {.name = name,
          .estimate =
              identification::Estimate{
                  .key = name, .value = value, .lower = value - half_width, .upper = value + half_width},
          .gain = gain};
}

// A tip that is nine tolerances off, of which the fit that holds it shows two and a half, and its neighbour three.
Diagnosis with_a_heavy_tip() {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.odds.hypotheses = {weighed({}, 12000.0, 1.0, 0.875)};
  diagnosis.indistinguishable.clear();
  diagnosis.verdict = Verdict::declared_numbers_off;
  diagnosis.probability_of_declared = 0.024;
  diagnosis.nominal = {
      {.estimate = {.key = "/links/1/com_offset_m", .value = 0.0108}, .declared = 0.0115, .tolerance = 0.00025},
      {.estimate = {.key = "/links/1/mass_kg", .value = 0.0218}, .declared = 0.0225, .tolerance = 0.00028}};
  diagnosis.numbers_off = {off("/links/1/mass_kg", 0.02, 0.0004, 12.5)};
  return diagnosis;
}

TEST(DiagnosisNumbersOff, SayWhichOneIsOffAndToWeighIt) {
  const std::string text = text_of(with_a_heavy_tip());
  EXPECT_THAT(text,
              HasSubstr("A declared number is off: free from its tolerance, /links/1/mass_kg explains these data "
                        "far better than within it, and decisively better than any missing effect that was tried.\n"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "  /links/1/mass_kg is off: free, it is 0.02, 0.0196 to 0.0204 (95 %); declared 0.0225, 8.9 "
          "tolerances away;\n"
          "    the model gains 12.5 by that\n"
          "  A gain of 6 is odds of 20 to 1. The numbers that moved, above, are those of a fit that holds each by "
          "its tolerance: there the one that is off passes what it lacks to those beside it.\n"));
  EXPECT_THAT(text, HasSubstr("(above 1 %: taken together that may be chance, though the one that is off is none).\n"));
  EXPECT_THAT(text, HasSubstr("What to do next\n"
                              "  Weigh or measure /links/1/mass_kg (declared 0.0225, these data say 0.02), correct the "
                              "actuator file and diagnose again.\n"
                              "  Do not build on actuator.json: there its tolerance holds back the number that is off, "
                              "and others carry what it lacks. Go on with that of the new diagnosis.\n"));
}

TEST(DiagnosisNumbersOff, SayBetweenWhichTheDataDoNotTell) {
  Diagnosis diagnosis = with_a_heavy_tip();
  diagnosis.probability_of_declared = 1e-3;
  diagnosis.numbers_off.push_back(off("/links/1/com_offset_m", 0.01, 0.0005, 9.0));
  diagnosis.numbers_off.push_back({.name = "force_curve", .gain = 8.0});
  const std::string text = text_of(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("free from its tolerance, /links/1/mass_kg or /links/1/com_offset_m or force_curve (these "
                        "data do not tell which) explains these data far better than within it, and decisively "
                        "better than any missing effect that was tried. Others may be off, too.\n"));
  EXPECT_THAT(text,
              HasSubstr("  /links/1/com_offset_m may be the one that is off: free, it is 0.01, 0.0095 to 0.0105 (95 "
                        "%); declared 0.0115, 6.0 tolerances away;\n    the model gains 9 by that\n"
                        "  force_curve may be the one that is off: the torque has another shape over the angle "
                        "than was declared;\n    the model gains 8 by that\n"));
  EXPECT_THAT(text, HasSubstr("Weigh or measure /links/1/mass_kg (declared 0.0225, these data say 0.02), "
                              "/links/1/com_offset_m (declared 0.0115, these data say 0.01), the torque over the angle "
                              "at one current (a static_torque bench), whose shape is off, correct"));
}

// What is less probable than one in twenty is not named.
TEST(DiagnosisNumbersOff, SayWhichMissingEffectWouldDoAsWell) {
  Diagnosis diagnosis = with_a_heavy_tip();
  diagnosis.odds.hypotheses = {weighed({}, 12010.0, 0.5, 0.875), weighed({&coil_heating}, 12000.0, 0.4375),
                               weighed({&dry_friction}, 12005.0, 0.03125)};
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("far better than within it. Or coil_heating is missing, which explains them about as "
                        "well: measure that number to know.\n"));
}

}  // namespace
}  // namespace coilwright::report
