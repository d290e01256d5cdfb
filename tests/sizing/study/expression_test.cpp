#include "coilwright/sizing/study/expression.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <optional>
#include <thread>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"
#include "sizing/expect_error.hpp"
#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

using simulation::DesignView;
using simulation::QuantityTable;
using simulation::ResultQuantity;
using testing::expect_error;

ResultQuantity constant(const char* name, std::optional<double> value, double scale = 1.0, const char* absence = "") {
  return {.name = name,
          .meaning = "of a test",
          .scale = scale,
          .value = [value](const DesignView&) { return value; },
          .absence = absence};
}

const QuantityTable table({constant("force_N", 6.0, 2.0), constant("mass_g", 4.0, 50.0), constant("nothing_N", 0.0),
                           constant("hidden_degC", std::nullopt, 80.0, "the coil burns")});

// A view is passed through and never looked at by the constants above.
std::optional<double> value_of(const ResultQuantity& quantity) {
  static const DesignProblem problem(testing::small_study());
  static const DesignResult result = problem.evaluate(std::vector{0.0, 0.9, 13.0, 1.0});
  return quantity.value(std::get<EvaluatedDesign>(result).view());
}

std::optional<double> value_of(const std::string& text) {
  return value_of(expression_quantity({.text = text, .name = "x", .unit = "1"}, table));
}

TEST(Expression, GivesItsValueUnderItsNameAndUnit) {
  const ResultQuantity quantity =
      expression_quantity({.text = "force_N / mass_g", .name = "grip_per_mass", .unit = "N/g"}, table);
  EXPECT_EQ(quantity.name, "grip_per_mass_N_g");
  EXPECT_EQ(quantity.unit, "N_g");
  EXPECT_EQ(quantity.meaning, "of the study: force_N / mass_g");
  EXPECT_EQ(value_of(quantity), 1.5);
  EXPECT_EQ(quantity.scale, 2.0 / 50.0);  // what the scales of both give
  EXPECT_EQ(expression_quantity({.text = "force_N", .name = "x", .unit = "1", .scale = 7}, table).scale, 7.0);
  EXPECT_EQ(expression_quantity({.text = "force_N - 2", .name = "x", .unit = "%"}, table).scale, 1.0);
  EXPECT_EQ(expression_quantity({.text = "force_N", .name = "x", .unit = "%"}, table).name, "x_pct");
}

TEST(Expression, KnowsArithmeticComparisonsAndFunctions) {
  EXPECT_EQ(value_of("(force_N - 1.5) * 2 ^ 3"), 36.0);
  EXPECT_EQ(value_of("max(force_N, mass_g, 5) + sqrt(mass_g) + abs(-force_N)"), 14.0);
  EXPECT_EQ(value_of("force_N >= mass_g && force_N != 5 ? 1 : 2"), 1.0);
  EXPECT_EQ(value_of("force_N == 5 || mass_g <= 3 ? 1 : 2"), 2.0);
}

TEST(Expression, HasNoValueWhereItIsNotFiniteOrAQuantityHasNone) {
  const ResultQuantity divided = expression_quantity({.text = "force_N / nothing_N", .name = "x", .unit = "1"}, table);
  EXPECT_EQ(value_of(divided), std::nullopt);
  EXPECT_EQ(divided.absence, "the expression is not finite there");
  EXPECT_EQ(value_of("ln(0 * force_N)"), std::nullopt);
  const ResultQuantity hot = expression_quantity({.text = "force_N * hidden_degC", .name = "x", .unit = "1"}, table);
  EXPECT_EQ(value_of(hot), std::nullopt);
  EXPECT_EQ(hot.absence, "the expression is not finite there, or hidden_degC has no value (the coil burns)");
}

TEST(Expression, SaysWhatIsWrong) {
  const auto refuse = [](const Expression& expression, const std::string& message) {
    expect_error<std::invalid_argument>([&] { (void)expression_quantity(expression, table); }, message);
  };
  const auto refuse_text = [&](const std::string& text, const std::string& message) {
    refuse({.text = text, .name = "x", .unit = "1"}, message);
  };
  refuse_text("force_N / weight_g", "names \"weight_g\", which is no quantity");
  refuse_text("force_N +", "must be an expression of quantities: Unexpected end of expression at position 10");
  refuse_text("(force_N", "must be an expression of quantities: Missing parenthesis");
  refuse_text("", "must be an expression of quantities: Expression is empty");
  refuse_text("2 * 3", "must contain a quantity: this is the same number for every design");
  refuse_text("force_N = 3", "must not assign: \"=\" (a comparison is \"==\")");
  refuse_text("1,5 * force_N", "must give one number; this gives 2");
  refuse({.text = "force_N", .name = "", .unit = "1"},
         "name: must be letters, digits and \"_\", a letter first; got \"\"");
  refuse({.text = "force_N", .name = "a b", .unit = "1"},
         "name: must be letters, digits and \"_\", a letter first; got \"a b\"");
  for (const char* unit : {"", "N/", "N//g", "N g", "µm"})
    refuse(
        {.text = "force_N", .name = "x", .unit = unit},
        std::string("unit: must be written in letters, digits and \"/\", \"N/g\", or be 1 for a plain number; got \"") +
            unit + "\"");
  refuse({.text = "force_N", .name = "x", .unit = "1", .scale = -1}, "scale: must be finite and > 0; got -1");
}

TEST(Expression, ReadsItsDecimalPointInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "de_DE.utf8", "C.UTF-8"}) (void)std::setlocale(LC_ALL, locale);
  EXPECT_EQ(value_of("1.5 * force_N"), 9.0);
  (void)std::setlocale(LC_ALL, before.c_str());
}

TEST(Expression, IsTheSameOnManyThreads) {
  const ResultQuantity quantity =
      expression_quantity({.text = "peak_bending_speed_deg_s / mass_g", .name = "speed_per_mass", .unit = "1"},
                          simulation::standard_quantities());
  const DesignProblem problem(testing::small_study());
  std::vector<EvaluatedDesign> designs;
  std::vector<double> expected;
  for (std::size_t i = 0; i < 4; ++i) {
    designs.push_back(std::get<EvaluatedDesign>(problem.evaluate(problem.point(i))));
    const DesignView view = designs.back().view();
    const QuantityTable& all = simulation::standard_quantities();
    expected.push_back(*all.at("peak_bending_speed_deg_s").value(view) / *all.at("mass_g").value(view));
  }
  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int repeat = 0; repeat < 500; ++repeat)
        if (quantity.value(designs[t].view()) != expected[t]) ++wrong[t];
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

}  // namespace
}  // namespace coilwright::sizing
