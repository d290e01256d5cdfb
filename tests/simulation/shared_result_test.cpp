#include "coilwright/simulation/shared_result.hpp"

#include <gtest/gtest.h>

#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::simulation {
namespace {

TEST(SharedResult, IsMadeOnceForADesignAndAnewForAnother) {
  int made = 0;
  const SharedResult<double> current([&made](const DesignView& design) {
    ++made;
    return design.point.current;
  });
  const SharedResult<double> twice([current](const DesignView& design) { return 2.0 * *current.of(design); });
  const EvaluatedDesign one = evaluate(actuator::Design{}, {.current = 0.7});
  const EvaluatedDesign other = evaluate(actuator::Design{}, {.current = 1.1});
  EXPECT_EQ(made, 0);
  EXPECT_EQ(*current.of(one.view()), 0.7);
  EXPECT_EQ(*twice.of(one.view()), 1.4);  // asks for the first while it is made
  const SharedResult<double> copy = current;
  EXPECT_EQ(*copy.of(one.view()), 0.7);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(*current.of(other.view()), 1.1);
  EXPECT_EQ(made, 2);
}

// The second one may stand where the first one stood.
TEST(SharedResult, OfAMakerThatIsGoneIsNotAnother) {
  const EvaluatedDesign design = evaluate(actuator::Design{}, {.current = 0.7});
  for (int i = 0; i < 8; ++i) EXPECT_EQ(*SharedResult<int>([i](const DesignView&) { return i; }).of(design.view()), i);
}

TEST(SharedResult, IsMadeAgainWhereNothingIsKept) {
  int made = 0;
  const SharedResult<double> current([&made](const DesignView& design) {
    ++made;
    return design.point.current;
  });
  const EvaluatedDesign design = evaluate(actuator::Design{}, {.current = 0.7});
  DesignView view = design.view();
  view.shared = nullptr;
  EXPECT_EQ(*current.of(view), *current.of(view));
  EXPECT_EQ(made, 2);
}

}  // namespace
}  // namespace coilwright::simulation
