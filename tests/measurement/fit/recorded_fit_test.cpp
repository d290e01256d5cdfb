// Fits that an earlier run recorded: the same to the last bit, not made again, only of the same question, and believed
// only where they come out again.
#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/fit/fit.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::fit {
namespace {

class RecordedFit : public ::testing::Test {
 protected:
  RecordedFit() {
    const Hypothesis plain(declared_, {});
    runs_.push_back(replay::prepare_run(run_, declared_, plain.model_at(plain.start())));
    runs_.back().simulations = std::make_shared<std::atomic<long>>();
    runs_.back().known_fits = std::make_shared<const replay::KnownFits>(
        replay::KnownFits{.recall = [this](const std::string& asked) -> std::optional<std::string> {
                            const auto found = known_.find(asked);
                            return found == known_.end() ? std::nullopt : std::optional(found->second);
                          },
                          .keep =
                              [this](const std::string& asked, const std::string& found) {
                                ++made_;
                                known_.insert_or_assign(asked, found);
                              },
                          .differs = [this] { ++differing_; }});
  }

  [[nodiscard]] FitRequest request() const {
    return {.hypothesis = &hypothesis_, .runs = runs_, .start = hypothesis_.start()};
  }
  // Whether a fit is answered from the record.
  bool is_known(const FitRequest& asked) {
    const int before = made_;
    (void)fit(asked);
    return made_ == before;
  }

  std::map<std::string, std::string> known_;
  int made_ = 0, differing_ = 0;
  replay::DeclaredModel declared_ = slide(3.0, 1.0);
  data::Run run_ = slide_run(120, {}, [normal = Normal(5)]() mutable { return noise_sigma * normal(); });
  Hypothesis hypothesis_{declared_, {{.kind = actuator::standard_effects().find("angle_offset"), .values = {0.01}}}};
  std::vector<replay::PreparedRun> runs_;
};

TEST_F(RecordedFit, IsTheSameToTheLastBitForTheSimulationsOfOneStep) {
  const auto made = fit(request());
  ASSERT_TRUE(made);
  const long simulations = runs_.front().simulations->exchange(0);
  const auto recalled = fit(request());
  ASSERT_TRUE(recalled);
  EXPECT_EQ(made_, 1);
  EXPECT_EQ(differing_, 0);
  EXPECT_LT(2 * runs_.front().simulations->load(), simulations);
  EXPECT_EQ(recalled->values, made->values);
  EXPECT_EQ(recalled->stacked_residuals, made->stacked_residuals);
  EXPECT_EQ(recalled->jacobian, made->jacobian);
  EXPECT_EQ(recalled->normal_matrix, made->normal_matrix);
  EXPECT_EQ(recalled->local_columns, made->local_columns);
  EXPECT_EQ(recalled->runs.front().predictions, made->runs.front().predictions);
  EXPECT_EQ(recalled->runs.front().local_numbers, made->runs.front().local_numbers);
  EXPECT_EQ(recalled->objective(), made->objective());
}

TEST_F(RecordedFit, IsNoAnswerToAnotherQuestion) {
  EXPECT_FALSE(is_known(request()));
  EXPECT_TRUE(is_known(request()));

  FitRequest other = request();
  other.start[0] *= 1.0 + 1e-15;
  EXPECT_FALSE(is_known(other));
  other = request();
  other.effort.iterations = 3;
  EXPECT_FALSE(is_known(other));
  other = request();
  other.held_parameter = 1;
  EXPECT_FALSE(is_known(other));
  const Hypothesis plain(declared_, {});
  EXPECT_FALSE(is_known({.hypothesis = &plain, .runs = runs_, .start = plain.start()}));
  const auto before = fit({.hypothesis = &hypothesis_, .runs = runs_, .start = hypothesis_.start()});
  other = request();
  other.local_numbers_from = &*before;
  EXPECT_FALSE(is_known(other));
}

// Whatever number of a record is another one, as in a record that somebody made: it is no answer.
TEST_F(RecordedFit, IsMadeAnewWhereAnyOfItsNumbersDoesNotComeOutAgain) {
  const auto made = fit(request());
  ASSERT_TRUE(made);
  ASSERT_EQ(known_.size(), 1U);
  const std::string whole = known_.begin()->second;
  constexpr std::size_t size = sizeof(double);
  for (std::size_t at = 0; at < whole.size(); at += size * (1 + whole.size() / size / 60)) {
    std::string& record = known_.begin()->second = whole;
    double number = 0;
    std::memcpy(&number, &record[at], size);
    number = number == 0 ? 1e-9 : std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) ^ 1U);
    std::memcpy(&record[at], &number, size);
    differing_ = 0;
    const auto again = fit(request());
    ASSERT_TRUE(again);
    EXPECT_EQ(differing_, 1) << "number " << at / size << " of " << whole.size() / size;
    EXPECT_EQ(again->values, made->values);
    EXPECT_EQ(again->normal_matrix, made->normal_matrix);
    EXPECT_EQ(record, whole);
  }
  for (const std::string& damaged :
       {std::string(), whole.substr(0, whole.size() - size), whole + std::string(size, 0)}) {
    known_.begin()->second = damaged;
    differing_ = 0;
    EXPECT_FALSE(is_known(request()));
    EXPECT_EQ(differing_, 1);
  }
}

// What a diagnosis changes of its runs between two fits of one hypothesis from one start.
TEST_F(RecordedFit, IsNoAnswerOnceTheRunsAreWeighedOtherwise) {
  EXPECT_FALSE(is_known(request()));
  runs_.front().noise.front().sigma *= 1.01;
  EXPECT_FALSE(is_known(request()));
  runs_.front().model_error = 2.0;
  EXPECT_FALSE(is_known(request()));
  runs_.front().set_aside.assign(1, std::vector<char>(run_.samples(), 0));
  runs_.front().set_aside.front()[40] = 1;
  EXPECT_FALSE(is_known(request()));
  runs_.front().windows.front().range.last -= 1;
  EXPECT_FALSE(is_known(request()));
  EXPECT_TRUE(is_known(request()));
}

}  // namespace
}  // namespace coilwright::measurement::fit
