#include "truth/laboratory/noise.hpp"

#include <cmath>
#include <numbers>

namespace truth::laboratory {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double mains = 50.0;  // Hz

// A first-order filter of white noise, exactly, at any times (Ornstein and Uhlenbeck).
std::vector<double> filtered(Random& random, double corner, const std::vector<double>& times) {
  std::vector<double> out;
  double value = random.normal();
  double before = times.empty() ? 0.0 : times.front();
  for (const double time : times) {
    const double kept = std::exp(-two_pi * corner * (time - before));
    before = time;
    value = kept * value + std::sqrt(1.0 - kept * kept) * random.normal();
    out.push_back(value);
  }
  return out;
}

}  // namespace

Noise::Noise(Colour colour, Random& random) : colour_(colour), random_(random) {}

std::vector<double> Noise::at(const std::vector<double>& times) {
  std::vector<double> out;
  switch (colour_) {
    case Colour::white:
      for (std::size_t i = 0; i < times.size(); ++i) out.push_back(random_.normal());
      break;
    case Colour::low_passed:
      out = filtered(random_, 10.0, times);
      break;
    case Colour::pink: {
      constexpr int filters = 8;
      out.assign(times.size(), 0.0);
      for (int i = 0; i < filters; ++i) {
        const double corner = 0.03 * std::pow(100.0 / 0.03, i / (filters - 1.0));
        const std::vector<double> part = filtered(random_, corner, times);
        for (std::size_t k = 0; k < out.size(); ++k) out[k] += part[k] / std::sqrt(static_cast<double>(filters));
      }
      break;
    }
    case Colour::hum: {
      const double phase = two_pi * random_.uniform();
      for (const double time : times)  // a sine of amplitude 1 has a variance of a half
        out.push_back(std::sin(two_pi * mains * time + phase) + std::sqrt(0.5) * random_.normal());
      break;
    }
  }
  return out;
}

}  // namespace truth::laboratory
