#include "coilwright/sizing/study/exact_sum.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace coilwright::sizing {

using boost::multiprecision::cpp_int;

struct ExactSum::Integer {
  cpp_int value;
};

namespace {

constexpr int mantissa_bits = std::numeric_limits<double>::digits;
// Every double is a whole multiple of 2^-1074.
constexpr int last_bit = mantissa_bits - std::numeric_limits<double>::min_exponent;

// frexp() gives 53 bits also of a number that is so small that it has fewer; those below 2^-1074 are then zeros.
cpp_int units_of(double value) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), mantissa_bits));
  const int shift = exponent - mantissa_bits + last_bit;
  const cpp_int digits = mantissa;
  return shift >= 0 ? cpp_int(digits << shift) : cpp_int(digits / (cpp_int(1) << -shift));
}

}  // namespace

ExactSum::ExactSum() : sum_(std::make_shared<const Integer>()) {}

ExactSum::ExactSum(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789", text[0] == '-' ? 1 : 0) != std::string::npos || text == "-")
    throw std::invalid_argument("must be a decimal integer");
  sum_ = std::make_shared<const Integer>(Integer{cpp_int(text)});
}

void ExactSum::add(double value) {
  sum_ = std::make_shared<const Integer>(Integer{sum_->value + units_of(value)});
}

void ExactSum::add(const ExactSum& other) {
  sum_ = std::make_shared<const Integer>(Integer{sum_->value + other.sum_->value});
}

double ExactSum::value() const {
  if (sum_->value == 0) return 0.0;
  const cpp_int size = abs(sum_->value);
  const int low = std::max(0, static_cast<int>(msb(size)) - mantissa_bits);
  const auto top = static_cast<std::uint64_t>(size >> low);
  return std::copysign(std::ldexp(static_cast<double>(top), low - last_bit), sum_->value < 0 ? -1.0 : 1.0);
}

std::string ExactSum::text() const {
  return sum_->value.str();
}

}  // namespace coilwright::sizing
