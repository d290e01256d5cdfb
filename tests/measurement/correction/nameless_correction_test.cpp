// Whole diagnoses of sets of the independent simulation with a torque that no effect of the catalogue is: the search
// is given no effect at all, which leaves the correction the whole of what is missing.

#include "coilwright/measurement/correction/nameless_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "attribution/temporary_set_folder.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/formats/data/diagnosis_json.hpp"
#include "coilwright/measurement/corrected_model.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "truth/data_set.hpp"

namespace coilwright::measurement {
namespace {

Diagnosis diagnosed(const std::vector<std::string>& hidden, int threads = 2) {
  const attribution::TemporarySetFolder folder("correction", 1);
  truth::DataSetRequest request{.hidden = hidden, .seed = 4};
  request.programme = truth::Programme::brief;
  request.weakest = 8.0;
  truth::write_data_set(truth::make_data_set(request), folder.path());
  const formats::DatasetFile set = formats::read_dataset(folder.path());
  const formats::DeclaredActuator declared = formats::read_declared_actuator(
      set.actuator.value(), {.names = set.calibrate, .file = set.file, .tolerances = set.tolerances});
  return diagnose(set.data, declared.model, {.threads = threads, .effects = actuator::EffectCatalogue()});
}

double excess(const Errors& errors, double noise) {
  return errors.rmse * errors.rmse - noise * noise;
}

// Friction in proportion to the angle, a current that iron saturates, and one that leaks away where coils touch.
class HiddenTorque : public testing::TestWithParam<const char*> {};

TEST_P(HiddenTorque, OfTheStateLosesHalfOfItsExcessOnRunsThatNoFitHasSeen) {
  const Diagnosis found = diagnosed({GetParam()});
  EXPECT_EQ(found.verdict, Verdict::unexplained);
  ASSERT_TRUE(found.correction.found.has_value()) << found.correction.reason;
  ASSERT_FALSE(found.validate_errors.empty());
  const ErrorComparison& errors = found.validate_errors.front();
  ASSERT_TRUE(errors.corrected.has_value());
  EXPECT_LT(excess(*errors.corrected, errors.noise_floor_rmse), 0.5 * excess(errors.before, errors.noise_floor_rmse));
  const correction::NamelessCorrection& correction = *found.correction.found;
  EXPECT_GT(correction.cross_validated_gain, 0.35);
  EXPECT_GT(correction.degrees_of_freedom, 1.0);
  EXPECT_GT(correction.rms, 0.0);
  EXPECT_LT(correction.smallest.torque, correction.largest.torque);
  EXPECT_NO_THROW(validate(correction.torque));
}

INSTANTIATE_TEST_SUITE_P(NamelessCorrection, HiddenTorque,
                         testing::Values("friction_of_bent_hinge", "saturating_iron", "contact_between_coils"));

TEST(NamelessCorrection, IsNotOfferedWhereNothingIsMissing) {
  const Diagnosis found = diagnosed({});
  EXPECT_EQ(found.verdict, Verdict::no_missing_effect);
  EXPECT_FALSE(found.correction.found.has_value());
  EXPECT_EQ(found.correction.reason, "");
  for (const ErrorComparison& errors : found.validate_errors) EXPECT_FALSE(errors.corrected.has_value());
}

TEST(NamelessCorrection, IsTheSameOnAnyNumberOfThreads) {
  const auto one = diagnosed({"friction_of_bent_hinge"}, 1);
  const auto two = diagnosed({"friction_of_bent_hinge"}, 2);
  ASSERT_TRUE(one.correction.found && two.correction.found);
  EXPECT_EQ(one.correction.found->torque, two.correction.found->torque);
  EXPECT_EQ(one.correction.found->calibration, two.correction.found->calibration);
}

}  // namespace
}  // namespace coilwright::measurement
