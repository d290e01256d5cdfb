#include "coilwright/sizing/problem/options.hpp"

#include <stdexcept>

#include "sizing/expect_error.hpp"

namespace coilwright::sizing {
namespace {

TEST(AlgorithmName, LeadsBackToTheAlgorithm) {
  for (const Algorithm algorithm : algorithms()) EXPECT_EQ(algorithm_named(name_of(algorithm)), algorithm);
}

TEST(AlgorithmName, ThatDoesNotExistIsAnsweredWithThoseThatDo) {
  testing::expect_error<std::invalid_argument>(
      [] { (void)algorithm_named("simplex"); },
      "algorithm: must be one of automatic, cobyla, bobyqa, sbplx, neldermead, slsqp, mma, isres, crs2, esch, "
      "direct_l; got \"simplex\"");
}

TEST(StopReasonName, IsWhatResultsPrint) {
  EXPECT_EQ(name_of(StopReason::evaluation_limit), "evaluation_limit");
  EXPECT_EQ(name_of(StopReason::space_exhausted), "space_exhausted");
  EXPECT_EQ(name_of(StopReason::converged), "converged");
  EXPECT_EQ(name_of(StopReason::interrupted), "interrupted");
}

}  // namespace
}  // namespace coilwright::sizing
