#include "intervals.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <optional>

namespace coilwright::measurement {
namespace {

// Chi-square with one degree of freedom at 95 %, and its root.
constexpr double chi_square_95 = 3.8414588206941254;
constexpr double normal_95 = 1.959963984540054;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Standard deviations from the curvature at the optimum; infinite where the data say nothing.
Eigen::VectorXd standard_deviations(const Scored& s, double unit) {
  const Eigen::Index p = s.hypothesis.size();
  const Eigen::VectorXd scales = s.hypothesis.scales();
  const Eigen::MatrixXd scaled = scales.asDiagonal() * s.fit.normal * scales.asDiagonal();
  Eigen::VectorXd out = Eigen::VectorXd::Constant(p, infinity);
  if (p == 0) return out;
  // A direction that the data do not see leaves undetermined what moves along it, and nothing else.
  constexpr double unseen = 1e-12;    // of the best seen direction
  constexpr double untouched = 1e-6;  // of a parameter's own unit
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaled);
  const double least = unseen * modes.eigenvalues().maxCoeff();
  for (Eigen::Index i = 0; i < p; ++i) {
    double variance = 0.0;
    double hidden = 0.0;
    for (Eigen::Index k = 0; k < p; ++k) {
      const double share = modes.eigenvectors()(i, k) * modes.eigenvectors()(i, k);
      if (modes.eigenvalues()[k] > least)
        variance += share / modes.eigenvalues()[k];
      else
        hidden += share;
    }
    if (hidden <= untouched && variance > 0.0) out[i] = scales[i] * std::sqrt(unit * variance);
  }
  return out;
}

// Chi^2 over its least value at held values of one parameter, everything else fitted anew.
class Profile {
 public:
  Profile(std::span<const Record> records, const Scored& s, Eigen::Index parameter, double unit)
      : records_(records), s_(s), parameter_(parameter), unit_(unit), last_(s.fit.values) {}

  // How far above the 95 % limit; positive outside the interval.
  double operator()(double value) {
    Eigen::VectorXd start = last_;
    start[parameter_] = value;
    const auto fitted = fit({.hypothesis = &s_.hypothesis,
                             .records = records_,
                             .start = start,
                             .starts_from = &s_.fit,
                             .held = parameter_,
                             .effort = {.iterations = 8, .tolerance = 1e-6}});
    if (!fitted) return chi_square_95;  // a model that cannot move is no explanation
    last_ = fitted->values;
    return (fitted->chi_square - s_.fit.chi_square) / unit_ - chi_square_95;
  }

  // Where the limit is passed on the way from the estimate by `step` (signed) and on, at most to `bound`; an infinity
  // where it never is.
  double crossing(double step, double bound) {
    last_ = s_.fit.values;
    const double centre = s_.fit.values[parameter_];
    double inside = centre;
    double inside_value = -chi_square_95;
    for (int i = 0; i < most_doublings; ++i) {
      const double wanted = centre + step * std::pow(2.0, i);
      const double at = step > 0.0 ? std::min(wanted, bound) : std::max(wanted, bound);
      const double value = (*this)(at);
      if (value >= 0.0) {
        std::uintmax_t evaluations = 6;
        const auto close = [&](double a, double b) { return std::abs(a - b) <= 0.01 * std::abs(at - centre); };
        const auto [a, b] = at > inside ? boost::math::tools::toms748_solve(std::ref(*this), inside, at, inside_value,
                                                                            value, close, evaluations)
                                        : boost::math::tools::toms748_solve(std::ref(*this), at, inside, value,
                                                                            inside_value, close, evaluations);
        return 0.5 * (a + b);
      }
      if (at == bound) break;
      inside = at;
      inside_value = value;
    }
    return std::copysign(infinity, step);
  }

 private:
  static constexpr int most_doublings = 8;
  std::span<const Record> records_;
  const Scored& s_;
  Eigen::Index parameter_;
  double unit_;
  Eigen::VectorXd last_;
};

Estimate local_estimate(const FitParameter& parameter, double value, double deviation) {
  Estimate out{.key = parameter.key, .denominator = parameter.denominator, .value = value};
  out.lower = value - normal_95 * deviation;
  out.upper = value + normal_95 * deviation;
  if (out.lower < parameter.lower) out.lower = -infinity;
  if (out.upper > parameter.upper) out.upper = infinity;
  out.determined = std::isfinite(out.lower) || std::isfinite(out.upper);
  return out;
}

}  // namespace

std::vector<Estimate> estimates(std::span<const Record> records, const Scored& s, double unit) {
  const Eigen::VectorXd deviations = standard_deviations(s, unit);
  std::vector<Estimate> out;
  for (Eigen::Index i = 0; i < s.hypothesis.size(); ++i)
    out.push_back(
        local_estimate(s.hypothesis.parameters()[static_cast<std::size_t>(i)], s.fit.values[i], deviations[i]));
  const std::size_t calibrated = s.hypothesis.declared().calibration.size();
  const std::size_t sides = 2 * (out.size() - calibrated);
  tbb::parallel_for(std::size_t{0}, sides, [&](std::size_t side) {
    const std::size_t i = calibrated + side / 2;
    const FitParameter& parameter = s.hypothesis.parameters()[i];
    const auto index = static_cast<Eigen::Index>(i);
    Profile profile(records, s, index, unit);
    double step = 1.05 * normal_95 * deviations[index];
    if (!std::isfinite(step)) step = parameter.scale;
    if (side % 2 == 0)
      out[i].lower = profile.crossing(-step, parameter.lower);
    else
      out[i].upper = profile.crossing(step, parameter.upper);
  });
  for (std::size_t i = calibrated; i < out.size(); ++i)
    out[i].determined = std::isfinite(out[i].lower) || std::isfinite(out[i].upper);
  return out;
}

std::vector<Estimate> estimates_of_effect(const Scored& s, const std::vector<Estimate>& all, std::size_t i) {
  const actuator::Effect effect = s.hypothesis.effects_at(s.fit.values)[i];
  const Hypothesis::Share& share = s.hypothesis.share(i);
  std::vector<Estimate> out;
  for (std::size_t k = 0; k < effect.values.size(); ++k) {
    const actuator::EffectParameter& number = effect.kind->parameters()[k];
    const auto fitted = std::ranges::find(share.numbers, k);
    if (fitted != share.numbers.end()) {
      out.push_back(all[static_cast<std::size_t>(share.first + (fitted - share.numbers.begin()))]);
    } else {
      out.push_back({.key = std::string(number.key),
                     .denominator = number.denominator,
                     .value = effect.values[k],
                     .lower = effect.values[k],
                     .upper = effect.values[k]});
    }
  }
  return out;
}

bool excludes_absent(const Scored& s, const std::vector<Estimate>& of_effect, std::size_t i) {
  const auto numbers = s.hypothesis.effects()[i].kind->parameters();
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (!numbers[k].absent) continue;
    const double absent = *numbers[k].absent;
    if (of_effect[k].lower <= absent && absent <= of_effect[k].upper) return false;
  }
  return true;
}

}  // namespace coilwright::measurement
