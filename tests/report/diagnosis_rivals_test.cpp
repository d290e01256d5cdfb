#include "report/diagnosis_parts.hpp"

#include <gmock/gmock.h>

#include <string>

#include "formats/data/diagnosis_by_hand.hpp"

namespace coilwright::report {
namespace {

using namespace coilwright::testing;
using namespace measurement;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(DiagnosisRivals, PutsTheHypothesesComparedIntoColumns) {
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  const auto evidence = [](double chi_square, double gain) {
    return compare::Evidence{.chi_square_after = chi_square, .criterion_gain = gain, .correlation_time = 4.0};
  };
  diagnosis.compared_hypotheses = {
      {.effects = {&coil_heating, &magnet_heating}, .evidence = evidence(11900.0, 803.0), .remark = ""},
      {.effects = {&dry_friction}, .evidence = evidence(12345.0, 700.0), .remark = ""},
      {.effects = {&magnet_heating}, .evidence = evidence(52000.0, -8.5), .remark = "interval includes absent"},
      {.effects = {&coil_heating}, .evidence = {}, .remark = "no coils"}};
  // Of the reported one the numbers of the report, not those of the search.
  EXPECT_THAT(compared_text(diagnosis),
              HasSubstr("  Compared, best first\n"
                        "                                   residual   gain\n"
                        "    coil_heating + magnet_heating    0.9958  803.0\n"
                        "    dry_friction                          1  800.0  reported\n"
                        "    magnet_heating                    2.082   -8.5  interval includes "
                        "absent\n"
                        "    coil_heating                       none   none  no coils\n"
                        "  residual: rms on the fit runs over the noise, 1 is noise alone."));
}

TEST(DiagnosisRivals, SaysWhyANeighbourOfWhatWasDroppedIsNotTheAnswerEither) {
  Diagnosis diagnosis = example();
  diagnosis.effects.clear();
  diagnosis.indistinguishable.clear();
  diagnosis.verdict = Verdict::declared_numbers_off;
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  const auto evidence = [](double gain) {
    return compare::Evidence{.chi_square_after = 12000.0, .criterion_gain = gain, .correlation_time = 1.0};
  };
  diagnosis.compared_hypotheses = {
      {.effects = {&coil_heating}, .evidence = evidence(51.7), .remark = "makes runs that are left out worse"},
      {.effects = {&magnet_heating}, .evidence = evidence(50.7), .remark = ""},
      {.effects = {&dry_friction}, .evidence = evidence(7.6), .remark = ""}};
  EXPECT_THAT(compared_text(diagnosis),
              HasSubstr("    coil_heating           1  51.7  makes runs that are left out worse\n"
                        "    magnet_heating         1  50.7  these data do not tell it from the first of this list\n"
                        "    dry_friction           1   7.6\n"));
}

TEST(DiagnosisRivals, SaysWhatIsHintedAtAndWhatThatWouldDo) {
  Diagnosis diagnosis = example();
  EXPECT_THAT(rivals_text(diagnosis), Not(HasSubstr("hint")));
  diagnosis.hinted = {{.kind = &dry_friction, .gain = -1.52, .number = "joint_stiffness_Nmm_rad", .wider = 2.46}};
  EXPECT_THAT(rivals_text(diagnosis),
              HasSubstr("  One more effect may be there that these data hint at, too weakly to be reported. All "
                        "intervals have in them\n  what it would do:\n"
                        "    dry_friction (gain -1.5): the interval of joint_stiffness_Nmm_rad is 2.5 times wider for "
                        "its sake\n"));
}

// 12,000 samples at the noise; a rival that leaves 1 % more of it.
TEST(DiagnosisRivals, SaysOfThoseThatAreWorseByLittleHowToSeeThem) {
  const actuator::EffectCatalogue& effects = actuator::standard_effects();
  const actuator::EffectKind* creep = effects.find("viscoelastic_creep");
  Diagnosis diagnosis = example();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  const auto evidence = [](double chi_square) { return compare::Evidence{.chi_square_after = chi_square}; };
  diagnosis.compared_hypotheses = {
      {.effects = {&dry_friction}, .evidence = evidence(12000.0), .remark = ""},
      {.effects = {creep}, .evidence = evidence(12240.0), .remark = ""},
      {.effects = {effects.find("backlash")}, .evidence = evidence(14000.0), .remark = ""}};
  const std::string text = rivals_text(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("  Worse by little, so that a small error of the model may have decided; how to see each "
                        "at the rig:\n    viscoelastic_creep (residual 1.01, where what is reported leaves 1)\n      " +
                        std::string(creep->check()) + "\n"));
  EXPECT_THAT(text, Not(HasSubstr("backlash (residual")));
  EXPECT_THAT(text, Not(HasSubstr("Nothing else that was tried")));
  // What these data cannot tell apart is said once.
  diagnosis.indistinguishable = {{&dry_friction, creep}};
  EXPECT_THAT(rivals_text(diagnosis), Not(HasSubstr("Worse by little")));
}

TEST(DiagnosisRivals, AreNoneWithMoreEffectsThanTheAnswer) {
  Diagnosis diagnosis = example();
  diagnosis.indistinguishable.clear();
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.compared_hypotheses = {
      {.effects = {&dry_friction}, .evidence = compare::Evidence{.chi_square_after = 12000.0}, .remark = ""},
      {.effects = {&dry_friction, &coil_heating},
       .evidence = compare::Evidence{.chi_square_after = 11990.0},
       .remark = ""}};
  EXPECT_THAT(rivals_text(diagnosis), HasSubstr("  Nothing else that was tried explains these data as well.\n"));
  diagnosis.compared_hypotheses.back().evidence->criterion_gain = 810.0;  // that of the reported one is 800
  EXPECT_THAT(rivals_text(diagnosis),
              HasSubstr("  Nothing else that was tried explains these data as well with as few effects.\n"));
}

// A friction and a drag do what a friction that falls with the speed does: the names alone would not tell them apart.
TEST(DiagnosisRivals, SayWithHowManyNumbersAnEffectIsMeant) {
  const actuator::EffectCatalogue& effects = actuator::standard_effects();
  const actuator::EffectKind* friction = effects.find("dry_friction");
  const actuator::EffectKind* drag = effects.find("quadratic_drag");
  Diagnosis diagnosis = example();
  diagnosis.indistinguishable.clear();
  diagnosis.effects = {{.kind = friction, .parameters = {}, .evidence = {}},
                       {.kind = drag, .parameters = {}, .evidence = {.chi_square_after = 12000.0}}};
  diagnosis.fit_errors = {comparison(data::ChannelKind::bending_angle, 12000, 0.3 * degree)};
  diagnosis.compared_hypotheses = {
      {.effects = {friction, drag}, .evidence = compare::Evidence{.chi_square_after = 12000.0}, .remark = ""},
      {.effects = {friction->with_further_numbers()},
       .evidence = compare::Evidence{.chi_square_after = 12200.0},
       .remark = ""}};
  const std::string text = rivals_text(diagnosis);
  EXPECT_THAT(text,
              HasSubstr("\n    dry_friction (3 numbers) (residual 1.008, where what is reported leaves 1)\n      " +
                        std::string(friction->with_further_numbers()->description()) + "\n"));
  EXPECT_THAT(compared_text(diagnosis), HasSubstr("\n    dry_friction (1 number) + quadratic_drag "));
}

}  // namespace
}  // namespace coilwright::report
