// Numbers that make no model are steps that a fit does not take: a diagnosis goes on beside them, to the right name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement {
namespace {

// A number from 0 to 1 that is another one for each point.
double drawn_for(std::span<const double> point, std::uint64_t seed) {
  std::uint64_t bits = seed;
  for (const double each : point) {
    std::uint64_t of_value = 0;
    std::memcpy(&of_value, &each, sizeof each);
    bits = (bits ^ of_value) * 0x9E3779B97F4A7C15ULL;
    bits ^= bits >> 29;
  }
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

// The slide, of which no model can be built at that share of all points but the declared one.
replay::DeclaredModel patchy_slide(double share, std::uint64_t seed) {
  replay::DeclaredModel declared = slide(2.2, 2.7);
  declared.build = [whole = declared.build, share, seed](std::span<const double> values) {
    const bool is_declared = values[0] == 2.2 && values[1] == 2.7;
    if (!is_declared && drawn_for(values, seed) < share) throw std::domain_error("curve: tolerance not reached");
    return whole(values);
  };
  return declared;
}

// An effect that no number from any start makes a model of.
const actuator::DescribedEffect brittle(
    {.id = "brittle",
     .stage = actuator::Stage::hinge,
     .description = "nothing",
     .equation = "q += 0",
     .source = "this test",
     .parameters = {{.key = "brittle_Nmm", .text = "nothing", .lower = 0.0, .upper = 1.0, .absent = 0.0}},
     .starts =
         [](const actuator::RigScale&) {
           return std::vector<std::vector<double>>{{0.5}, {1.0}};
         },
     .build = [](std::span<const double> values, actuator::ModelSpec&) -> std::unique_ptr<actuator::EffectTerm> {
       if (values[0] != 0.0) throw std::domain_error("curve of a brittle one: tolerance not reached");
       return nullptr;
     }});

class ImpossiblePoints : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(ImpossiblePoints, AreNotGoneTo) {
  data::Dataset data;
  data.fit.push_back(dragged_run(200, 1.0, 0.1 * noise_sigma, 4));
  for (const double share : {0.05, 0.2}) {
    const Diagnosis found = diagnose(data, patchy_slide(share, GetParam()),
                                     {.threads = 2, .effects = actuator::standard_effects().with(brittle)});
    // Among so many holes a fit may end at the edge of one: then nothing is named, and nothing else ever.
    const bool may_end_at_a_hole = share > 0.1;
    EXPECT_TRUE(may_end_at_a_hole || found.effects.size() == 1) << share;
    EXPECT_EQ(found.verdict == Verdict::explained, !found.effects.empty()) << share;
    for (const AddedEffect& each : found.effects) {
      EXPECT_EQ(each.kind->id(), "quadratic_drag") << share;
      EXPECT_NEAR(each.parameters.front().value, 1.0, 0.1) << share;
    }
    const auto none = std::ranges::find_if(found.odds.ruled_out, [](const identification::RuledOut& each) {
      return each.effects == std::vector<const actuator::EffectKind*>{&brittle};
    });
    ASSERT_NE(none, found.odds.ruled_out.end()) << share;
    EXPECT_EQ(none->remark,
              "leaves the model from every start that was tried: curve of a brittle one: tolerance not reached");
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ImpossiblePoints, ::testing::Range<std::uint64_t>(1, 5));

}  // namespace
}  // namespace coilwright::measurement
