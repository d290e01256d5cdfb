#include "measurement/replay/command_shape.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "coilwright/algebra/least_squares.hpp"
#include "measurement/signals/spectrum.hpp"

namespace coilwright::measurement::replay {
namespace {

constexpr Eigen::Index fewest_readings = 8;
constexpr Eigen::Index highest_degree = 3;
// Standard deviations beyond which a statistic is no accident.
constexpr double significant = 4.0;

using Times = Eigen::Map<const Eigen::VectorXd>;

CommandShape projected(Eigen::MatrixXd basis, const Eigen::VectorXd& readings) {
  CommandShape out{.basis = std::move(basis)};
  out.values = out.basis * (out.basis.transpose() * readings);
  return out;
}

// Whether what is left over is white noise of that size: its mean square, and the correlation of neighbours.
bool leaves_noise(const CommandShape& shape, const Eigen::VectorXd& readings, const ReadingNoise& noise) {
  const Eigen::VectorXd left = (readings - shape.values) / noise.sigma;
  const Eigen::Index n = left.size();
  const auto freedom = static_cast<double>(n - shape.basis.cols());
  const double excess = (left.squaredNorm() / freedom - 1.0) / std::sqrt(2.0 / freedom + 2.0 / noise.freedom);
  const double alike = left.head(n - 1).dot(left.tail(n - 1)) / left.squaredNorm() * std::sqrt(static_cast<double>(n));
  return excess < significant && alike < significant;
}

// To the last bit the same everywhere: simulations pass over what is held.
CommandShape constant(const Eigen::VectorXd& readings) {
  const Eigen::Index n = readings.size();
  return {.basis = Eigen::MatrixXd::Constant(n, 1, 1.0 / std::sqrt(static_cast<double>(n))),
          .values = Eigen::VectorXd::Constant(n, readings.mean())};
}

// Polynomials up to the highest degree whose coefficient is not noise.
CommandShape polynomial(const Times& times, const Eigen::VectorXd& readings, double sigma) {
  const double first = times[0];
  const double half = 0.5 * (times[times.size() - 1] - first);
  Eigen::MatrixXd powers(times.size(), highest_degree + 1);
  powers.col(0).setOnes();
  for (Eigen::Index k = 1; k <= highest_degree; ++k)
    powers.col(k) = powers.col(k - 1).cwiseProduct(((times.array() - first) / half - 1.0).matrix());
  const Eigen::MatrixXd basis = algebra::orthonormal(powers);
  Eigen::Index degree = highest_degree;
  while (degree > 0 && std::abs(basis.col(degree).dot(readings)) < significant * sigma) --degree;
  if (degree == 0) return constant(readings);
  return projected(basis.leftCols(degree + 1), readings);
}

Eigen::MatrixXd sine_columns(const Times& times, double frequency) {
  Eigen::MatrixXd out(times.size(), 3);
  const Eigen::ArrayXd phase = 2.0 * std::numbers::pi * frequency * (times.array() - times[0]);
  out << Eigen::VectorXd::Ones(times.size()), phase.cos().matrix(), phase.sin().matrix();
  return out;
}

// A sine about a constant. The frequency is sought within one line of the periodogram about its highest.
std::optional<CommandShape> sine(const Times& times, const Eigen::VectorXd& readings) {
  const Eigen::VectorXd swing = readings.array() - readings.mean();
  const signals::Periodogram spectrum = signals::periodogram({swing.data(), static_cast<std::size_t>(swing.size())});
  const auto highest = std::ranges::max_element(spectrum.power.begin() + 1, spectrum.power.end());
  const double interval = (times[times.size() - 1] - times[0]) / static_cast<double>(times.size() - 1);
  const double line = 1.0 / (static_cast<double>(spectrum.size) * interval);
  const double middle = static_cast<double>(highest - spectrum.power.begin()) * line;
  const auto left = [&](double frequency) {
    const Eigen::MatrixXd basis = algebra::orthonormal(sine_columns(times, frequency));
    return (readings - basis * (basis.transpose() * readings)).squaredNorm();
  };
  // Less than half a period is no sine that anybody could tell from a polynomial.
  const double slowest = 0.5 / (times[times.size() - 1] - times[0]);
  constexpr int bits = 30;
  const double frequency = boost::math::tools::brent_find_minima(left, std::max(slowest, middle - 2.0 * line),
                                                                 std::max(slowest, middle) + 2.0 * line, bits)
                               .first;
  const Eigen::MatrixXd columns = sine_columns(times, frequency);
  const Eigen::VectorXd coefficients = algebra::least_squares(columns, readings);
  Eigen::MatrixXd with_frequency(times.size(), 4);
  const Eigen::ArrayXd since = times.array() - times[0];
  with_frequency << columns,
      (since * (coefficients[2] * columns.col(1).array() - coefficients[1] * columns.col(2).array())).matrix();
  return projected(algebra::orthonormal(with_frequency), readings);
}

}  // namespace

std::optional<CommandShape> command_shape(std::span<const double> times, std::span<const double> values,
                                          const ReadingNoise& noise) {
  const auto n = static_cast<Eigen::Index>(values.size());
  if (n < fewest_readings) return std::nullopt;
  const Times at(times.data(), n);
  const Eigen::VectorXd readings = Times(values.data(), n);
  CommandShape simple = polynomial(at, readings, noise.sigma);
  if (leaves_noise(simple, readings, noise)) return simple;
  std::optional<CommandShape> swinging = sine(at, readings);
  if (swinging && leaves_noise(*swinging, readings, noise)) return swinging;
  return std::nullopt;
}

}  // namespace coilwright::measurement::replay
