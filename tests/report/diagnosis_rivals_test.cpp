#include "report/diagnosis/diagnosis_parts.hpp"

#include <gmock/gmock.h>

#include <string>

#include "formats/data/diagnosis_by_hand.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;
using ::testing::Not;

// Beyond the five most probable only the reported one and that of no effect.
std::string compared_text(const Diagnosis& diagnosis) {
  Section section{.id = "rivals", .title = "Rivals"};
  add_compared(section, diagnosis);
  return section.blocks.empty() ? "" : to_text(section);
}

TEST(DiagnosisRivals, PutsTheHypothesesComparedIntoColumns) {
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.odds.hypotheses = {weighed({&coil_heating, &magnet_heating}, 11900.0, 0.5, 0.9375),
                               weighed({&coil_heating, &end_stop}, 13000.0, 0.25, 0.125),
                               weighed({&magnet_heating}, 13000.0, 0.125, 0.0625),
                               weighed({&end_stop}, 13000.0, 0.0625),
                               weighed({&magnet_heating, &end_stop}, 13000.0, 0.03125),
                               weighed({&coil_heating}, 13000.0, 0.03125),
                               weighed({&dry_friction}, 12000.0, 1e-5, 0.9375),
                               weighed({}, 48000.0, 0.0)};
  EXPECT_THAT(compared_text(diagnosis),
              HasSubstr("  Compared, most probable first\n"
                        "                                       probability  residual     leaves noise\n"
                        "    coil_heating + magnet_heating            0.500    0.9958            0.938\n"
                        "    coil_heating + end_stop                  0.250     1.041            0.125\n"
                        "    magnet_heating                           0.125     1.041            0.062\n"
                        "    end_stop                                 0.062     1.041  less than 0.001\n"
                        "    magnet_heating + end_stop                0.031     1.041  less than 0.001\n"
                        "    dry_friction                   less than 0.001         1            0.938  reported\n"
                        "    no effect                      less than 0.001         2  less than 0.001\n"
                        "  probability: given that one of those that were fitted is true."));
}

TEST(DiagnosisRivals, AreNoTableWhereNothingWasCompared) {
  EXPECT_EQ(compared_text({}), "");
}

TEST(DiagnosisRivals, MarkThatOfNoEffectWhereItIsTheAnswer) {
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.effects.clear();
  diagnosis.verdict = Verdict::no_missing_effect;
  diagnosis.odds.hypotheses = {weighed({}, 12000.0, 0.75, 0.9375), weighed({&coil_heating}, 11990.0, 0.25, 0.9375)};
  EXPECT_THAT(compared_text(diagnosis), HasSubstr("    no effect           0.750         1         0.938  reported\n"
                                                  "    coil_heating        0.250    0.9996         0.938\n"));
}

TEST(DiagnosisRivals, SayWhatTheRecordsDoNotTest) {
  const std::string not_tested(identification::not_tested_remark);
  Diagnosis diagnosis = example();
  diagnosis.odds.ruled_out = {{.effects = {&coil_heating}, .remark = not_tested},
                              {.effects = {&end_stop}, .remark = not_tested}};
  EXPECT_THAT(rivals_text(diagnosis),
              HasSubstr("  Not tested by these records, in which they would change nothing, and "
                        "not ruled out:\n    coil_heating, end_stop\n"));
  EXPECT_THAT(rivals_text(diagnosis), Not(HasSubstr("Without a probability")));
  diagnosis.odds.ruled_out.back().remark = "no coils";
  EXPECT_THAT(rivals_text(diagnosis), HasSubstr("  Without a probability: 1 effect, for reasons"));
  EXPECT_THAT(rivals_text(diagnosis), HasSubstr("not ruled out:\n    coil_heating\n"));
}

TEST(DiagnosisRivals, SaysWhatIsHintedAtAndWhatThatWouldDo) {
  Diagnosis diagnosis = example();
  EXPECT_THAT(rivals_text(diagnosis), Not(HasSubstr("hint")));
  diagnosis.hinted = {{.kind = &dry_friction, .gain = -1.52, .number = "joint_stiffness_Nmm_rad", .wider = 2.46}};
  EXPECT_THAT(rivals_text(diagnosis),
              HasSubstr("  One more effect may be there that these data hint at, too weakly to be reported. All "
                        "intervals have in them what it would do:\n"
                        "    dry_friction: the interval of joint_stiffness_Nmm_rad is 2.5 times wider for "
                        "its sake\n"));
}

// 12,000 samples at the noise; a rival that leaves 1 % more of it.
TEST(DiagnosisRivals, SaysOfThoseThatAreWorseByLittleHowToSeeThem) {
  const actuator::EffectCatalogue& effects = actuator::standard_effects();
  const actuator::EffectKind* creep = effects.find("viscoelastic_creep");
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.odds.hypotheses = {weighed({&dry_friction}, 12000.0, 0.96), weighed({creep}, 12240.0, 0.04),
                               weighed({effects.find("backlash")}, 14000.0, 0.0), weighed({}, 52000.0, 0.0)};
  const std::string text = rivals_text(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("  Nearly as good, so that a small error of the model may have decided; how to see each "
                        "at the rig:\n    viscoelastic_creep (residual 1.01, where what is reported leaves 1)\n      " +
                        std::string(creep->check()) + "\n"));
  EXPECT_THAT(text, Not(HasSubstr("backlash (residual")));
  EXPECT_THAT(text, Not(HasSubstr("Nothing else that was tried")));
  // What these data cannot tell apart is said once.
  diagnosis.indistinguishable = {{&dry_friction, creep}};
  EXPECT_THAT(rivals_text(diagnosis), Not(HasSubstr("Nearly as good")));
}

// A heating that is too uncertain to be named, and that nothing is missing.
TEST(DiagnosisRivals, SayWhatIsNotToBeRuledOut) {
  Diagnosis diagnosis = example();
  diagnosis.indistinguishable.clear();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.odds.hypotheses = {weighed({&dry_friction, &coil_heating}, 11990.0, 0.80),
                               weighed({&dry_friction}, 12000.0, 0.14), weighed({}, 52000.0, 0.06)};
  EXPECT_THAT(rivals_text(diagnosis), HasSubstr("  Not to be ruled out:\n"
                                                "    dry_friction + coil_heating, with a probability of 0.800\n"
                                                "    no effect, with a probability of 0.060\n"));
  diagnosis.odds.hypotheses = {weighed({&dry_friction}, 12000.0, 1.0), weighed({}, 52000.0, 0.0)};
  EXPECT_THAT(rivals_text(diagnosis), HasSubstr("  Nothing else that was tried explains these data as well.\n"));
}

TEST(DiagnosisRivals, SayWhyWhatIsCertainIsNotReported) {
  const std::string sentence =
      "  More than what is reported is there, most probably, but moves nothing by more than a tenth of the noise.\n";
  Diagnosis diagnosis = example();
  diagnosis.indistinguishable.clear();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.odds.hypotheses = {weighed({&dry_friction, &coil_heating}, 11960.0, 1.0),
                               weighed({&dry_friction}, 12000.0, 1e-8), weighed({}, 52000.0, 0.0)};
  EXPECT_THAT(rivals_text(diagnosis),
              HasSubstr("    dry_friction + coil_heating, with a probability of more than 0.999\n" + sentence));
  diagnosis.verdict = Verdict::incomplete;
  EXPECT_THAT(rivals_text(diagnosis), Not(HasSubstr(sentence)));
  diagnosis.verdict = Verdict::explained;
  diagnosis.odds.hypotheses = {weighed({&dry_friction, &coil_heating}, 11990.0, 0.85),
                               weighed({&dry_friction}, 12000.0, 0.15)};
  EXPECT_THAT(rivals_text(diagnosis), Not(HasSubstr(sentence)));
}

// A friction and a drag do what a friction that falls with the speed does: the names alone would not tell them apart.
TEST(DiagnosisRivals, SayWithHowManyNumbersAnEffectIsMeant) {
  const actuator::EffectCatalogue& effects = actuator::standard_effects();
  const actuator::EffectKind* friction = effects.find("dry_friction");
  const actuator::EffectKind* drag = effects.find("quadratic_drag");
  Diagnosis diagnosis = example();
  diagnosis.indistinguishable.clear();
  diagnosis.effects = {{.kind = friction, .parameters = {}}, {.kind = drag, .parameters = {}}};
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.odds.hypotheses = {weighed({friction, drag}, 12000.0, 0.9),
                               weighed({friction->with_further_numbers()}, 12200.0, 0.1)};
  const std::string text = rivals_text(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("\n    dry_friction (3 numbers) (residual 1.008, where what is reported leaves 1)\n      " +
                        std::string(friction->with_further_numbers()->description()) + "\n"));
  EXPECT_THAT(compared_text(diagnosis), HasSubstr("\n    dry_friction (1 number) + quadratic_drag "));
  EXPECT_THAT(compared_text(diagnosis), HasSubstr("  (n numbers): the effect with so many of its numbers fitted"));
}

}  // namespace
}  // namespace coilwright::report
