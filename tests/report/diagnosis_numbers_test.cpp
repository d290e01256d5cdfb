#include "coilwright/report/diagnosis/diagnosis_text.hpp"

#include <gmock/gmock.h>

#include "report/text_of_diagnosis.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(DiagnosisNumbers, SaysWhichSideOfAnIntervalIsOpen) {
  Diagnosis diagnosis = example();
  identification::Estimate& estimate = diagnosis.effects[0].parameters[0];
  estimate.upper = infinity;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("0.61  at least 0.58 (95 %)"));
  estimate = {.key = estimate.key, .value = 0.61e-3, .lower = -infinity, .upper = 0.64e-3};
  EXPECT_THAT(text_of(diagnosis), HasSubstr("0.61  at most 0.64 (95 %)"));
  estimate.determined = false;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("0.61  not determined by these data"));
}

TEST(DiagnosisNumbers, SaysOfAChoiceThatItIsOne) {
  Diagnosis diagnosis = example();
  diagnosis.effects = {stopped()};
  EXPECT_THAT(text_of(diagnosis), HasSubstr("  end_stop: a stop\n"
                                            "    angle_deg  40  39 to 41 (95 %)\n"
                                            "    side       -1  (chosen)\n"));
}

TEST(DiagnosisNumbers, SaysOfOneWithManyOptimaThatItsIntervalIsCoarse) {
  Diagnosis diagnosis = example();
  EXPECT_THAT(text_of(diagnosis), Not(HasSubstr("apart from each other")));
  diagnosis.effects[0].parameters[0].has_many_optima = true;
  EXPECT_THAT(text_of(diagnosis),
              HasSubstr("    torque_Nmm  0.61  0.58 to 0.64 (95 %)\n"
                        "    torque_Nmm fits about as well at other values, apart from each other: its interval is "
                        "coarse. Measure it at the rig if a design rests on it.\n"));
}

TEST(DiagnosisNumbers, HasAsManyDigitsAsAnIntervalBears) {
  Diagnosis diagnosis = example();
  identification::Estimate& estimate = diagnosis.effects[0].parameters[0];
  estimate.value = 12.50034e-3;
  estimate.lower = 12.49921e-3;
  estimate.upper = 12.50147e-3;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("torque_Nmm  12.5003  12.4992 to 12.5015 (95 %)"));
  estimate.lower = 3.456e-3;
  estimate.upper = 25.0e-3;
  EXPECT_THAT(text_of(diagnosis), HasSubstr("torque_Nmm  12.5  3.46 to 25 (95 %)"));
}

}  // namespace
}  // namespace coilwright::report
