#include "drive/phase.hpp"

#include <cmath>
#include <limits>

namespace coilwright::drive {
namespace {

// Below it differences of exponentials lose digits; above, series would need more than twenty terms.
constexpr double short_time = 0.5;

// Integral of 1 - exp(-u) over u from 0 to x.
double first_integral(double x) {
  if (x > short_time) return x + std::expm1(-x);
  double power = -x, sum = 0.0;
  for (int k = 2; k < 25; ++k) {
    power *= -x / k;
    sum += power;
  }
  return sum;
}

// Integral of (1 - exp(-u))^2.
double second_integral(double x) {
  if (x > short_time) return x + 2.0 * std::expm1(-x) - 0.5 * std::expm1(-2.0 * x);
  double power = 0.5 * x * x, sum = 0.0, doubling = 2.0;
  for (int k = 3; k < 25; ++k) {
    power *= -x / k;
    doubling *= 2.0;
    sum += power * (2.0 - doubling);
  }
  return sum;
}

}  // namespace

Phase::Phase(const Circuit& circuit, const Path& path) {
  const double resistance = circuit.resistance + path.resistance + path.supply_resistance;
  goal = (path.source - path.diodes) / resistance;
  time_constant = circuit.inductance / resistance;
}

double Phase::current(double start, double time) const {
  return start - (goal - start) * std::expm1(-time / time_constant);
}

double Phase::time_to_zero(double start) const {
  if (goal >= 0.0) return std::numeric_limits<double>::infinity();
  return start > 0.0 ? time_constant * std::log1p(start / -goal) : 0.0;
}

double Phase::time_to_reach(double start, double level) const {
  if (start >= level) return 0.0;
  return goal > level ? -time_constant * std::log1p((start - level) / (goal - start))
                      : std::numeric_limits<double>::infinity();
}

double Phase::charge(double start, double time) const {
  return start * time + (goal - start) * time_constant * first_integral(time / time_constant);
}

double Phase::square(double start, double time) const {
  const double away = goal - start, x = time / time_constant;
  return start * start * time + time_constant * away * (2.0 * start * first_integral(x) + away * second_integral(x));
}

}  // namespace coilwright::drive
