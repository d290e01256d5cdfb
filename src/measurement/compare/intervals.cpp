#include "measurement/compare/intervals.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {
namespace {

// Chi-square with one degree of freedom at 95 %, and its root.
constexpr double chi_square_95 = 3.8414588206941254;
constexpr double normal_95 = 1.959963984540054;
constexpr double infinity = std::numeric_limits<double>::infinity();
// A profile that meets a chi^2 so much smaller, in pieces of evidence, has found an optimum that the fit had missed;
// less is where fits end.
constexpr double worth_moving = 0.2;
constexpr int most_moves = 8;

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

// A number whose physical range has a zero at its end at most, and that is not there, is profiled in its logarithm: the
// data may leave decades of it open.
bool is_magnitude(const fit::FitParameter& parameter, double value) {
  return parameter.lower >= 0.0 && value > 0.0;
}

// Chi^2 over its least value at held values of one parameter, everything else fitted anew.
class Profile {
 public:
  Profile(std::span<const replay::Record> records, const Scored& s, Eigen::Index index, double unit)
      : records_(records), s_(s), index_(index), unit_(unit), last_(s.fit.values), best_(s.fit.values) {
    const fit::FitParameter& parameter = s.hypothesis.parameters()[static_cast<std::size_t>(index)];
    lower_ = parameter.lower;
    upper_ = parameter.upper;
    scale_ = parameter.scale;
    logarithmic_ = is_magnitude(parameter, s.fit.values[index]);
  }

  // Where the 95 % limit is passed on the way down (-1) or up (1) from the estimate, at most to the physical bound; an
  // infinity where it never is. `deviation` of the estimate from the curvature; may be infinite.
  double crossing(double way, double deviation) {
    last_ = s_.fit.values;
    const double estimate = s_.fit.values[index_];
    const double centre = coordinate(estimate);
    const double bound = coordinate(way > 0.0 ? upper_ : lower_);
    const double step = way * first_step(estimate, deviation);
    double inside = centre;
    double inside_value = -chi_square_95;
    for (int i = 0; i < most_doublings; ++i) {
      const double wanted = centre + step * std::pow(2.0, i);
      const double at = way > 0.0 ? std::min(wanted, bound) : std::max(wanted, bound);
      const double value = above_limit(at);
      if (value >= 0.0) return value_at(root(inside, inside_value, at, value, 0.01 * std::abs(at - centre)));
      if (at == bound) break;
      inside = at;
      inside_value = value;
    }
    return std::copysign(infinity, way);
  }

  // The smallest chi^2 that was met, and where: that of the estimate if nothing better was.
  [[nodiscard]] double best_chi_square() const { return best_chi_square_; }
  [[nodiscard]] const Eigen::VectorXd& best() const { return best_; }

 private:
  static constexpr int most_doublings = 8;

  [[nodiscard]] double coordinate(double value) const { return logarithmic_ ? std::log(value) : value; }
  [[nodiscard]] double value_at(double coordinate) const { return logarithmic_ ? std::exp(coordinate) : coordinate; }

  [[nodiscard]] double first_step(double estimate, double deviation) const {
    double step = 1.05 * normal_95 * deviation;
    if (!std::isfinite(step)) step = scale_;
    return logarithmic_ ? std::min(step / estimate, std::numbers::ln2) : step;
  }

  // How far above the 95 % limit; positive outside the interval.
  double above_limit(double coordinate) {
    Eigen::VectorXd start = last_;
    start[index_] = value_at(coordinate);
    const auto fitted = fit::fit({.hypothesis = &s_.hypothesis,
                                  .records = records_,
                                  .start = start,
                                  .starts_from = &s_.fit,
                                  .held = index_,
                                  .effort = {.iterations = 8, .tolerance = 1e-6}});
    if (!fitted) return chi_square_95;  // a model that cannot move is no explanation
    last_ = fitted->values;
    if (fitted->chi_square < best_chi_square_) {
      best_chi_square_ = fitted->chi_square;
      best_ = fitted->values;
    }
    return (fitted->chi_square - s_.fit.chi_square) / unit_ - chi_square_95;
  }

  double root(double inside, double inside_value, double outside, double outside_value, double tolerance) {
    std::uintmax_t evaluations = 6;
    const auto function = [this](double coordinate) { return above_limit(coordinate); };
    const auto close = [&](double a, double b) { return std::abs(a - b) <= tolerance; };
    const auto [a, b] = inside < outside ? boost::math::tools::toms748_solve(function, inside, outside, inside_value,
                                                                             outside_value, close, evaluations)
                                         : boost::math::tools::toms748_solve(function, outside, inside, outside_value,
                                                                             inside_value, close, evaluations);
    return 0.5 * (a + b);
  }

  std::span<const replay::Record> records_;
  const Scored& s_;
  Eigen::Index index_;
  double unit_;
  double lower_{}, upper_{}, scale_{};
  bool logarithmic_{};
  Eigen::VectorXd last_;
  Eigen::VectorXd best_;
  double best_chi_square_ = s_.fit.chi_square;
};

Estimate local_estimate(const fit::FitParameter& parameter, double value, double deviation) {
  Estimate out{.key = parameter.key, .denominator = parameter.denominator, .value = value};
  out.lower = value - normal_95 * deviation;
  out.upper = value + normal_95 * deviation;
  if (out.lower < parameter.lower) out.lower = -infinity;
  if (out.upper > parameter.upper) out.upper = infinity;
  out.determined = std::isfinite(out.lower) || std::isfinite(out.upper);
  return out;
}

// Estimates about the fit of `s`, and the best values that a profile met.
struct Look {
  std::vector<Estimate> all{};
  double chi_square{};
  Eigen::VectorXd values{};
};

Look look_around(std::span<const replay::Record> records, const Scored& s, double unit) {
  const Eigen::VectorXd deviations = standard_deviations(s, unit);
  Look out{.all = {}, .chi_square = s.fit.chi_square, .values = s.fit.values};
  for (Eigen::Index i = 0; i < s.hypothesis.size(); ++i)
    out.all.push_back(
        local_estimate(s.hypothesis.parameters()[static_cast<std::size_t>(i)], s.fit.values[i], deviations[i]));
  const std::size_t calibrated = s.hypothesis.declared().calibration.size();
  std::vector<Profile> sides;
  for (std::size_t i = calibrated; i < out.all.size(); ++i)
    for (int side = 0; side < 2; ++side) sides.emplace_back(records, s, static_cast<Eigen::Index>(i), unit);
  tbb::parallel_for(std::size_t{0}, sides.size(), [&](std::size_t side) {
    const std::size_t i = calibrated + side / 2;
    Estimate& estimate = out.all[i];
    const double deviation = deviations[static_cast<Eigen::Index>(i)];
    (side % 2 == 0 ? estimate.lower : estimate.upper) = sides[side].crossing(side % 2 == 0 ? -1.0 : 1.0, deviation);
  });
  for (const Profile& profile : sides) {
    if (profile.best_chi_square() >= out.chi_square) continue;
    out.chi_square = profile.best_chi_square();
    out.values = profile.best();
  }
  for (std::size_t i = calibrated; i < out.all.size(); ++i)
    out.all[i].determined = std::isfinite(out.all[i].lower) || std::isfinite(out.all[i].upper);
  return out;
}

}  // namespace

std::vector<Estimate> estimates(std::span<const replay::Record> records, Scored& s, double unit) {
  for (int moves = 0;; ++moves) {
    Look look = look_around(records, s, unit);
    if (moves == most_moves || s.fit.chi_square - look.chi_square < worth_moving * unit) return look.all;
    const auto there =
        fitted_to_end(records, {.hypothesis = s.hypothesis, .start = look.values, .starts_from = &s.fit});
    if (!there || there->fit.chi_square >= s.fit.chi_square) return look.all;
    s = *there;
  }
}

std::vector<Estimate> estimates_of_effect(const Scored& s, const std::vector<Estimate>& all, std::size_t i) {
  const actuator::Effect effect = s.hypothesis.effects_at(s.fit.values)[i];
  const fit::Hypothesis::Share& share = s.hypothesis.share(i);
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
                     .upper = effect.values[k],
                     .chosen = true});
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

}  // namespace coilwright::measurement::compare
