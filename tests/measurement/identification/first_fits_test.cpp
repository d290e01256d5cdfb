#include "measurement/identification/first_fits.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/identification/slide_fits.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

std::vector<actuator::Effect> effect(std::string_view id, std::vector<double> values) {
  return {{.kind = actuator::standard_effects().find(id), .values = std::move(values)}};
}

// First fits of a lag of the camera, and of the drag that moves the slide if `with_answer`, where the screening of
// the lag has predicted this fall of chi-square. Returns the number of simulated runs.
long simulated_runs(bool with_answer, double predicted_fall) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const data::Run run = dragged_run(400, 0.5, 0.5 * noise_sigma, 5);
  std::vector runs{replay::prepare_run(run, declared, model_of(declared))};
  const FittedHypothesis base = fitted_to(runs, declared, {});
  EXPECT_FALSE(base.whiteness.is_white());  // or nothing gets other starts
  runs.front().simulations = std::make_shared<std::atomic<long>>(0);
  std::vector<PlannedExtension> planned{{.base = &base,
                                         .starts = {effect("tracking_lag", {0.02})},
                                         .further_starts = {effect("tracking_lag", {0.02})},
                                         .predicted_fall = predicted_fall}};
  if (with_answer) planned.push_back({.base = &base, .starts = {effect("quadratic_drag", {0.3})}});
  const FirstFits found = first_fits(runs, planned, [](std::size_t) {});
  EXPECT_EQ(found.fits.size(), planned.size());
  return *runs.front().simulations;
}

TEST(FirstFits, KeepOtherStartsForEffectsThatMayExplainAsMuchAsAnAnswer) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_LT(simulated_runs(true, 0.0), simulated_runs(true, infinity));
  EXPECT_EQ(simulated_runs(false, 0.0), simulated_runs(false, infinity));
}

}  // namespace
}  // namespace coilwright::measurement::identification
