#pragma once

#include <gtest/gtest.h>

#include <span>
#include <utility>
#include <vector>

#include "measurement/identification/staged_fit.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {

// A slide as it is declared.
inline actuator::Model model_of(const replay::DeclaredModel& declared) {
  const fit::Hypothesis plain(declared, {});
  return plain.model_at(plain.start());
}

// It with effects, fitted from where these and the declared numbers are.
inline FittedHypothesis fitted_to(std::span<const replay::PreparedRun> runs, const replay::DeclaredModel& declared,
                                  std::vector<actuator::Effect> effects) {
  PlannedFit plan{.hypothesis = fit::Hypothesis(declared, std::move(effects))};
  plan.start = plan.hypothesis.start();
  auto found = fit_exactly(runs, plan);
  EXPECT_TRUE(found.has_value());
  return std::move(*found);
}

}  // namespace coilwright::measurement::identification
