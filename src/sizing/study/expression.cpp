#include "coilwright/sizing/study/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace coilwright::sizing {
namespace {

using simulation::DesignView;
using simulation::QuantityTable;
using simulation::ResultQuantity;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// One parser with the values of its variables; used by one thread at a time.
class Calculator {
 public:
  Calculator(const std::string& text, const std::vector<std::string>& symbols) : values_(symbols.size(), 1.0) {
    for (std::size_t i = 0; i < symbols.size(); ++i) parser_.DefineVar(symbols[i], &values_[i]);
    parser_.SetExpr(text);
  }

  double operator()(const std::vector<double>& values) {
    std::ranges::copy(values, values_.begin());
    return parser_.Eval();
  }

 private:
  std::vector<double> values_;
  mu::Parser parser_;
};

// An expression that several threads evaluate: each takes a calculator of its own, and leaves it to the next.
class SharedExpression {
 public:
  SharedExpression(std::string text, std::vector<ResultQuantity> operands)
      : text_{std::move(text)}, operands_{std::move(operands)} {
    for (const ResultQuantity& operand : operands_) symbols_.push_back(operand.name);
  }

  [[nodiscard]] std::optional<double> value(const DesignView& design) const {
    std::vector<double> values;
    for (const ResultQuantity& operand : operands_) {
      const std::optional<double> value = operand.value(design);
      if (!value || !std::isfinite(*value)) return std::nullopt;
      values.push_back(*value);
    }
    const double result = calculate(values);
    return std::isfinite(result) ? std::optional(result) : std::nullopt;
  }

  [[nodiscard]] double calculate(const std::vector<double>& values) const {
    std::unique_ptr<Calculator> calculator = taken();
    const double result = (*calculator)(values);
    const std::scoped_lock lock{guard_};
    idle_.push_back(std::move(calculator));
    return result;
  }

  // Of the first quantity in it without a value.
  [[nodiscard]] simulation::NoValue why_absent(const DesignView& design, const std::string& otherwise) const {
    for (const ResultQuantity& operand : operands_) {
      const std::optional<double> value = operand.value(design);
      if (value && std::isfinite(*value)) continue;
      simulation::NoValue why = operand.why_absent ? operand.why_absent(design) : simulation::NoValue{operand.absence};
      why.reason = fmt::format("{} has no value ({})", operand.name, why.reason);
      return why;
    }
    return {.reason = otherwise};
  }

  [[nodiscard]] bool tells_why() const {
    return std::ranges::any_of(operands_,
                               [](const ResultQuantity& each) { return static_cast<bool>(each.why_absent); });
  }

  [[nodiscard]] const std::vector<ResultQuantity>& operands() const { return operands_; }

 private:
  [[nodiscard]] std::unique_ptr<Calculator> taken() const {
    {
      const std::scoped_lock lock{guard_};
      if (!idle_.empty()) {
        std::unique_ptr<Calculator> calculator = std::move(idle_.back());
        idle_.pop_back();
        return calculator;
      }
    }
    return std::make_unique<Calculator>(text_, symbols_);
  }

  std::string text_;
  std::vector<ResultQuantity> operands_;
  std::vector<std::string> symbols_;
  mutable std::mutex guard_;
  mutable std::vector<std::unique_ptr<Calculator>> idle_;
};

std::string message_of(const mu::Parser::exception_type& mistake) {
  std::string text = mistake.GetMsg();
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return fmt::format("must be an expression of quantities: {}", text);
}

// "=" alone assigns, which would change a quantity.
void refuse_assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || (text[i - 1] != '<' && text[i - 1] != '>' && text[i - 1] != '!')) {
      throw std::invalid_argument("must not assign: \"=\" (a comparison is \"==\")");
    }
  }
}

std::vector<ResultQuantity> operands_of(const std::string& text, const QuantityTable& quantities) {
  mu::Parser parser;
  parser.SetExpr(text);
  std::vector<ResultQuantity> operands;
  for (const auto& [symbol, place] : parser.GetUsedVar()) {
    const ResultQuantity* quantity = quantities.find(symbol);
    if (quantity == nullptr) throw UnknownSymbol(symbol);
    operands.push_back(*quantity);
  }
  if (operands.empty())
    throw std::invalid_argument("must contain a quantity: this is the same number for every design");
  return operands;
}

void require_one_result(const std::string& text, const std::vector<ResultQuantity>& operands) {
  mu::Parser parser;
  double any = 1.0;
  for (const ResultQuantity& operand : operands) parser.DefineVar(operand.name, &any);
  parser.SetExpr(text);
  int results = 0;
  (void)parser.Eval(results);
  if (results != 1) throw std::invalid_argument(fmt::format("must give one number; this gives {}", results));
}

// "N/g" as the end of a name: "N_g".
std::string suffix_of(const std::string& unit) {
  if (unit == "1") return {};
  if (unit == "%") return "pct";
  std::string suffix = unit;
  std::ranges::replace(suffix, '/', '_');
  const bool has_empty_part =
      unit.empty() || suffix.front() == '_' || suffix.back() == '_' || suffix.find("__") != std::string::npos;
  if (has_empty_part || !std::ranges::all_of(suffix, [](char c) { return is_letter(c) || is_digit(c) || c == '_'; }))
    throw std::invalid_argument(fmt::format(
        "unit: must be written in letters, digits and \"/\", \"N/g\", or be 1 for a plain number; got \"{}\"", unit));
  return suffix;
}

double scale_of(const Expression& expression, const SharedExpression& shared) {
  if (!(std::isfinite(expression.scale) && expression.scale >= 0))
    throw std::invalid_argument(fmt::format("scale: must be finite and > 0; got {}", expression.scale));
  if (expression.scale > 0) return expression.scale;
  std::vector<double> ordinary;
  for (const ResultQuantity& operand : shared.operands()) ordinary.push_back(operand.scale);
  const double scale = std::abs(shared.calculate(ordinary));
  return std::isfinite(scale) && scale > 0 ? scale : 1.0;
}

std::optional<actuator::HeldCases> pose_of(const SharedExpression& shared) {
  std::optional<actuator::HeldCases> pose;
  for (const ResultQuantity& operand : shared.operands()) pose = simulation::either(pose, operand.pose);
  return pose;
}

std::string absence_of(const SharedExpression& shared) {
  std::string text = "the expression is not finite there";
  for (const ResultQuantity& operand : shared.operands())
    if (!operand.absence.empty()) text += fmt::format(", or {} has no value ({})", operand.name, operand.absence);
  return text;
}

}  // namespace

UnknownSymbol::UnknownSymbol(std::string symbol)
    : std::invalid_argument(fmt::format("names \"{}\", which is no quantity", symbol)), symbol_{std::move(symbol)} {}

bool is_name(const std::string& text) {
  return !text.empty() && is_letter(text.front()) &&
         std::ranges::all_of(text, [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

ResultQuantity expression_quantity(const Expression& expression, const QuantityTable& quantities) {
  refuse_assignment(expression.text);
  try {
    auto shared = std::make_shared<const SharedExpression>(expression.text, operands_of(expression.text, quantities));
    require_one_result(expression.text, shared->operands());
    if (!is_name(expression.name))
      throw std::invalid_argument(
          fmt::format("name: must be letters, digits and \"_\", a letter first; got \"{}\"", expression.name));
    const std::string suffix = suffix_of(expression.unit);
    ResultQuantity out{.name = suffix.empty() ? expression.name : fmt::format("{}_{}", expression.name, suffix),
                       .meaning = fmt::format("of the study: {}", expression.text),
                       .scale = scale_of(expression, *shared),
                       .value = [shared](const DesignView& design) { return shared->value(design); },
                       .absence = absence_of(*shared),
                       .unit = suffix,
                       .pose = pose_of(*shared),
                       .in_every_use = std::ranges::any_of(shared->operands(), &ResultQuantity::in_every_use)};
    if (shared->tells_why())
      out.why_absent = [shared](const DesignView& design) {
        return shared->why_absent(design, "the expression is not finite there");
      };
    return out;
  } catch (const mu::Parser::exception_type& mistake) {
    throw std::invalid_argument(message_of(mistake));
  }
}

}  // namespace coilwright::sizing
