#include "measurement/identification/weighed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "coilwright/algebra/definite.hpp"
#include "coilwright/algebra/spectral.hpp"
#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/data/median_interval.hpp"
#include "measurement/identification/prior_of_numbers.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/identification/what_is_left.hpp"

namespace coilwright::measurement::identification {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Where the record itself told the level of the noise, motion and colour enter it, and where another did, light and
// mount were others: it is known to some 10 %.
constexpr double freedom_of_estimate = 50.0;
// Degrees of freedom of the prior of a declared number.
constexpr double heavy_tail = 4.0;
// A number that neither records nor priors tell has a volume of so many of its typical changes.
constexpr double precision_of_nothing = 1e-6;
// Directions in which numbers do the same are told apart no better than to rounding.
constexpr double least_mode = 1e-12;

// The residuals of a window with their derivatives: residual | parameters | local numbers.
struct Block {
  Rows rows;
  std::vector<Series> series;
  Eigen::MatrixXd local_priors;  // the same of the priors of its local numbers, as a normal matrix
};

double freedom_of(const signals::NoiseLevel& noise) {
  return noise.given || noise.pooled ? noise.freedom : std::min(noise.freedom, freedom_of_estimate);
}

// A spectrum that another record told is another one here by what no torque can make: `fastest`.
double longest_colour_of(const signals::NoiseLevel& noise, double fastest) {
  if (noise.given) return noise.colour_unknown ? std::numeric_limits<double>::infinity() : 0.0;
  return noise.from_the_run ? 0.0 : fastest;
}

// Times are in units of the sampling interval of the fastest run, since what is missing knows no clock of its own.
struct Times {
  double interval{};  // s; infinite without motions
  double fastest{};   // over that: nothing that acts on the joints moves them faster than they swing by themselves
};

Series series_of(const replay::PreparedRun& run, replay::SampleRange range, std::size_t channel, Eigen::Index first,
                 const Times& unit) {
  const signals::NoiseLevel& noise = run.noise[channel];
  Series out{.first = first, .freedom = freedom_of(noise), .longest_colour = longest_colour_of(noise, unit.fastest)};
  const std::vector<double>& times = run.run->times;
  if (!times.empty()) out.interval = data::median_interval(*run.run) / unit.interval;
  for (std::size_t i = range.first; i < range.last; ++i) {
    out.set_aside.push_back(run.is_set_aside(channel, i) ? 1 : 0);
    if (i == range.first) continue;
    const double step = times.empty() ? 1.0 : (times[i] - times[i - 1]) / unit.interval;
    // Even times differ by the rounding of their difference, which a filter would take for uneven ones.
    constexpr double rounding = 1e-9;
    out.steps.push_back(std::abs(step - out.interval) <= rounding * out.interval ? out.interval : step);
  }
  return out;
}

Times times_of(std::span<const replay::PreparedRun> runs, const actuator::Model& model) {
  Times out{.interval = std::numeric_limits<double>::infinity()};
  for (const replay::PreparedRun& run : runs)
    if (!run.run->times.empty()) out.interval = std::min(out.interval, data::median_interval(*run.run));
  const double period = shortest_period(model);
  if (std::isfinite(period)) out.fastest = period / (2.0 * std::numbers::pi) / out.interval;
  return out;
}

// `residuals`: as Fit::stacked_residuals, at the fit or near it.
std::vector<Block> blocks_of(std::span<const replay::PreparedRun> runs, const fit::Fit& fit,
                             const Eigen::VectorXd& residuals, const Times& unit) {
  std::vector<Block> out;
  Eigen::Index row = 0;
  for (const replay::PreparedRun& run : runs)
    for (const replay::SampleRange& range : run.sample_ranges()) {
      const Eigen::MatrixXd& parameters = fit.parameter_columns[out.size()];
      const Eigen::MatrixXd& local = fit.local_columns[out.size()];
      Rows all(parameters.rows(), 1 + parameters.cols() + local.cols());
      all << residuals.segment(row, parameters.rows()), parameters, local;
      row += parameters.rows();
      const Eigen::Index samples = run.values_in(range);
      // The fit holds priors the harder the farther from the noise it is.
      const Rows priors = all.bottomRows(all.rows() - samples) / fit.model_error;
      Block block{.rows = all.topRows(samples), .series = {}, .local_priors = priors.transpose() * priors};
      for (std::size_t channel = 0; channel < run.run->channels.size(); ++channel)
        block.series.push_back(
            series_of(run, range, channel, static_cast<Eigen::Index>(channel * range.samples()), unit));
      out.push_back(std::move(block));
    }
  return out;
}

// The logarithm of the likelihood of so many squares, up to a constant.
double log_likelihood(double squares, Eigen::Index samples, double freedom) {
  if (std::isinf(freedom)) return -0.5 * squares;
  return -0.5 * (static_cast<double>(samples) + freedom) * std::log1p(squares / freedom);
}
// What each of them weighs in it: the noise's inverse variance, as the series itself tells it.
double weight(double squares, Eigen::Index samples, double freedom) {
  return std::isinf(freedom) ? 1.0 : (static_cast<double>(samples) + freedom) / (squares + freedom);
}

// How the parameters are known before the records are: each by a coordinate u, slopes dphi/du.
struct Priors {
  Eigen::VectorXd slopes, precisions;
  double log_density{};
};
Priors priors_of(const FittedHypothesis& fitted, const actuator::RigScale& scale) {
  const Eigen::Index size = fitted.hypothesis.size();
  Priors out{.slopes = Eigen::VectorXd::Ones(size), .precisions = Eigen::VectorXd::Zero(size)};
  const auto declared = static_cast<Eigen::Index>(fitted.hypothesis.declared().calibration.size());
  for (Eigen::Index i = 0; i < declared; ++i) {
    const fit::FitParameter& number = fitted.hypothesis.parameters()[static_cast<std::size_t>(i)];
    out.slopes[i] = number.has_prior() ? number.tolerance : number.scale;
  }
  Eigen::Index at = declared;
  for (const actuator::Effect& effect : fitted.hypothesis.effects_at(fitted.fit.values)) {
    const PriorOfNumbers prior = prior_of_numbers(effect, scale);
    out.log_density += prior.log_density;
    for (std::size_t k = 0; k < prior.slopes.size(); ++k, ++at) {
      out.slopes[at] = prior.slopes[k];
      out.precisions[at] = prior.precisions[k];
    }
  }
  return out;
}

// A quadratic form of the parameters: constant + 2 gradient x + x matrix x.
struct Quadratic {
  double constant{};
  Eigen::VectorXd gradient;
  Eigen::MatrixXd matrix;
};

// The posterior of the parameters in their coordinates u, about the fit. Records may know one number a billion times
// better than a prior knows another: the modes are those of the precision over its diagonal, `units` being one over the
// roots of that.
struct Mode {
  Eigen::VectorXd step;
  Eigen::VectorXd units;
  algebra::SymmetricModes modes;
  double objective{};  // -2 log of likelihood and priors there
};

class Weighing {
 public:
  Weighing(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted, const actuator::RigScale& scale)
      : runs_(runs),
        fitted_(fitted),
        unit_(times_of(runs, fitted.hypothesis.model_at(fitted.hypothesis.start()))),
        blocks_(blocks_of(runs, fitted.fit, fitted.fit.stacked_residuals, unit_)),
        priors_(priors_of(fitted, scale)) {}

  WeighedFit run() const {
    const std::vector<WhatIsLeft> grid = all_that_may_be_left(range());
    std::vector<double> log_weights;
    for (const WhatIsLeft& each : grid) log_weights.push_back(each.log_prior + of_residuals(each));
    const auto best = static_cast<std::size_t>(std::ranges::max_element(log_weights) - log_weights.begin());
    double sum = 0.0, small = 0.0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const double share = std::exp(log_weights[i] - log_weights[best]);
      sum += share;
      if (grid[i].missing.deviation < decision_thresholds.least_over_noise) small += share;
    }
    WeighedFit out = at(grid[best]);
    out.log_evidence += grid[best].log_prior + std::log(sum);
    out.probability_of_noise = small / sum;
    return out;
  }

 private:
  double samples() const {
    double out = 0.0;
    for (const Block& block : blocks_) out += static_cast<double>(block.rows.rows());
    return out;
  }

  // Beyond four times what is left over nothing is probable.
  RangeOfWhatIsLeft range() const {
    double squares = 0.0;
    for (const Block& block : blocks_) squares += block.rows.col(0).squaredNorm();
    RangeOfWhatIsLeft out{.shortest = unit_.fastest,
                          .largest_deviation = 4.0 * std::sqrt(1.0 + squares / (1.0 + samples()))};
    for (const Block& block : blocks_)
      for (const Series& series : block.series) {
        out.longest = std::max(out.longest, static_cast<double>(series.samples()) * series.interval);
        out.longest_colour = std::max(out.longest_colour, series.longest_colour);
      }
    return out;
  }

  // Of the residuals as the fit leaves them.
  double of_residuals(const WhatIsLeft& left) const {
    double out = 0.0;
    for (const Block& block : blocks_)
      for (const Series& series : block.series) {
        const DiscrepancyFilter filter(series, left.in(series));
        Rows residual = block.rows.col(0).segment(series.first, series.samples());
        filter.whiten(residual);
        out +=
            log_likelihood(residual.squaredNorm(), series.samples(), series.freedom) - 0.5 * filter.log_determinant();
      }
    return out;
  }

  WeighedFit at(const WhatIsLeft& left) const {
    const Likelihood here = likelihood_of(blocks_, left);
    const Mode mode = mode_of(here.quadratic);
    const Reached reached = reached_by(mode, here, left);
    double log_z = priors_.log_density + reached.log_density;
    for (const double each : mode.modes.values)
      log_z += 0.5 * (std::log(2.0 * std::numbers::pi) - std::log(std::max(each, least_mode)));
    for (const double unit : mode.units) log_z += std::log(unit);
    WeighedFit out{.log_evidence = log_z, .discrepancy = left.missing};
    if (left.missing.deviation > 0.0)
      for (const Block& block : blocks_)
        for (const Series& series : block.series) out.values_of_discrepancy += values_told(series, left.in(series));
    out.values = values_at(reached.step);
    const Eigen::MatrixXd& vectors = mode.modes.vectors;
    const Eigen::VectorXd variances = mode.modes.values.cwiseMax(least_mode).cwiseInverse();
    const Eigen::VectorXd units = priors_.slopes.cwiseProduct(mode.units);
    for (std::size_t e = 0; e < fitted_.hypothesis.effects().size(); ++e)
      out.first_of_effects.push_back(fitted_.hypothesis.parameters_of(e).first);
    out.covariance = units.asDiagonal() * vectors * variances.asDiagonal() * vectors.transpose() * units.asDiagonal();
    return out;
  }

  [[nodiscard]] Eigen::VectorXd values_at(const Eigen::VectorXd& step) const {
    return fitted_.hypothesis.clamped(fitted_.fit.values + priors_.slopes.cwiseProduct(step));
  }

  // What the records say of the parameters about a place; `constant` does not depend on them.
  struct Likelihood {
    double constant{};
    Quadratic quadratic;
  };
  [[nodiscard]] Likelihood likelihood_of(const std::vector<Block>& blocks, const WhatIsLeft& left) const {
    const Eigen::Index size = fitted_.hypothesis.size();
    Likelihood out{.quadratic = {.gradient = Eigen::VectorXd::Zero(size), .matrix = Eigen::MatrixXd::Zero(size, size)}};
    for (const Block& block : blocks) out.constant += add(block, left, out.quadratic);
    return out;
  }

  // Of likelihood and priors, at a step from the fit where the records are `there`.
  [[nodiscard]] double log_density_at(const Eigen::VectorXd& step, const Likelihood& there) const {
    return there.constant -
           0.5 * (there.quadratic.constant + step.dot(priors_.precisions.cwiseProduct(step)) + pull_at(step).objective);
  }

  // Where the density of the parameters is taken, and its logarithm.
  struct Reached {
    Eigen::VectorXd step;
    double log_density{};
  };
  // The mode, if a simulation there shows what the derivatives promise; otherwise the best of what was simulated on the
  // way to it: a hypothesis is credited with what it has shown.
  [[nodiscard]] Reached reached_by(const Mode& mode, const Likelihood& here, const WhatIsLeft& left) const {
    constexpr double nothing = 1.0;  // of twice the logarithm
    Reached out{.step = Eigen::VectorXd::Zero(mode.step.size())};
    out.log_density = log_density_at(out.step, here);
    const double promised = here.constant - 0.5 * mode.objective;
    if (2.0 * (promised - out.log_density) < nothing) return {.step = mode.step, .log_density = promised};
    for (const double share : {1.0, 0.5, 0.25}) {
      const Eigen::VectorXd step = share * mode.step;
      const auto there = fit::evaluate_at({.hypothesis = &fitted_.hypothesis,
                                           .runs = runs_,
                                           .start = values_at(step),
                                           .local_numbers_from = &fitted_.fit});
      if (!there) continue;
      const double shown =
          log_density_at(step, likelihood_of(blocks_of(runs_, fitted_.fit, there->stacked_residuals, unit_), left));
      if (shown <= out.log_density) continue;
      out = {.step = step, .log_density = shown};
      break;
    }
    return out;
  }

  // Adds what a window says of the parameters, its local numbers eliminated. Returns the part of the logarithm of its
  // likelihood that does not depend on them.
  double add(const Block& block, const WhatIsLeft& left, Quadratic& sum) const {
    const Eigen::Index p = fitted_.hypothesis.size();
    const Eigen::Index locals = block.rows.cols() - 1 - p;
    double out = 0.0;
    Eigen::MatrixXd normal = block.local_priors;
    for (const Series& series : block.series) {
      const DiscrepancyFilter filter(series, left.in(series));
      Rows rows = block.rows.middleRows(series.first, series.samples());
      filter.whiten(rows);
      const double squares = rows.col(0).squaredNorm();
      const double weighs = weight(squares, series.samples(), series.freedom);
      normal.noalias() += weighs * rows.transpose() * rows;
      out += log_likelihood(squares, series.samples(), series.freedom) + 0.5 * weighs * squares -
             0.5 * filter.log_determinant();
    }
    if (locals > 0) {
      const Eigen::MatrixXd own = normal.bottomRightCorner(locals, locals);
      const Eigen::MatrixXd coupling = normal.bottomLeftCorner(locals, 1 + p);
      const Eigen::MatrixXd inverse = algebra::inverse_of_definite(own);
      normal.topLeftCorner(1 + p, 1 + p) -= coupling.transpose() * inverse * coupling;
      for (const double each : algebra::symmetric_modes(own).values) out -= 0.5 * std::log(each);
    }
    sum.constant += normal(0, 0);
    sum.gradient += normal.col(0).segment(1, p);
    sum.matrix += normal.block(1, 1, p, p);
    return out;
  }

  // Newton's method with the weights of Student's t.
  Mode mode_of(const Quadratic& data) const {
    constexpr int iterations = 20;
    const auto& slopes = priors_.slopes;
    const Eigen::MatrixXd matrix = slopes.asDiagonal() * data.matrix * slopes.asDiagonal();
    const Eigen::VectorXd gradient = slopes.cwiseProduct(data.gradient);
    Mode out;
    out.step.setZero(slopes.size());
    if (slopes.size() == 0) {
      out.objective = data.constant;
      return out;
    }
    for (int i = 0; i < iterations; ++i) {
      const Pull pull = pull_at(out.step);
      Eigen::MatrixXd precision = matrix;
      precision.diagonal() += pull.weights + priors_.precisions;
      precision.diagonal().array() += precision_of_nothing;
      out.units = precision.diagonal().cwiseSqrt().cwiseInverse();
      out.modes = algebra::symmetric_modes(out.units.asDiagonal() * precision * out.units.asDiagonal());
      const Eigen::VectorXd inverse = out.modes.values.cwiseMax(least_mode).cwiseInverse();
      // The coordinates of effects have their priors' densities at the fit: only declared numbers are drawn.
      const Eigen::VectorXd downhill = -(gradient + matrix * out.step + pull.weights.cwiseProduct(pull.distances) +
                                         priors_.precisions.cwiseProduct(out.step));
      const Eigen::VectorXd by =
          out.units.cwiseProduct(out.modes.vectors * inverse.asDiagonal() *
                                 (out.modes.vectors.transpose() * out.units.cwiseProduct(downhill)));
      out.step += by;
      if (by.cwiseAbs().maxCoeff() < 1e-6) break;
    }
    out.objective = data.constant + 2.0 * gradient.dot(out.step) + out.step.dot(matrix * out.step) +
                    out.step.dot(priors_.precisions.cwiseProduct(out.step)) + pull_at(out.step).objective;
    return out;
  }

  // Beyond where it pulls, a prior stays as it is there, to the bound: Laplace's integral shall be as wide.
  static double flat_precision(const fit::FitParameter& number, double value) {
    const double bound = value < number.declared ? number.lower : number.upper;
    const double width = std::max(1.0, std::abs(bound - number.declared) / number.tolerance - number.farthest);
    return 2.0 * std::numbers::pi / (width * width);
  }

  struct Pull {
    Eigen::VectorXd distances, weights;  // of each parameter from what is declared, in tolerances
    double objective{};
  };
  Pull pull_at(const Eigen::VectorXd& step) const {
    Pull out{.distances = Eigen::VectorXd::Zero(step.size()), .weights = Eigen::VectorXd::Zero(step.size())};
    const Eigen::VectorXd values = fitted_.fit.values + priors_.slopes.cwiseProduct(step);
    const auto declared = static_cast<Eigen::Index>(fitted_.hypothesis.declared().calibration.size());
    for (Eigen::Index i = 0; i < declared; ++i) {
      const fit::FitParameter& number = fitted_.hypothesis.parameters()[static_cast<std::size_t>(i)];
      if (!number.has_prior()) continue;
      const double distance = -number.distance(values[i]);
      out.objective += (heavy_tail + 1.0) * std::log1p(distance * distance / heavy_tail);
      if (!number.is_pulled(values[i])) {
        out.weights[i] = flat_precision(number, values[i]);
        continue;
      }
      out.distances[i] = distance;
      out.weights[i] = (heavy_tail + 1.0) / (heavy_tail + distance * distance);
    }
    return out;
  }

  std::span<const replay::PreparedRun> runs_;
  const FittedHypothesis& fitted_;
  Times unit_;
  std::vector<Block> blocks_;
  Priors priors_;
};

}  // namespace

WeighedFit weighed(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                   const actuator::RigScale& scale) {
  return Weighing(runs, fitted, scale).run();
}

}  // namespace coilwright::measurement::identification
