#include "video/shutter.hpp"

#include <cmath>
#include <limits>

namespace coilwright::video {
namespace {

std::size_t count_of(std::span<const std::vector<SeriesEntry>> series) {
  std::size_t out = 0;
  for (const auto& each : series) out += each.size();
  return out;
}

constexpr LastCoefficient untold{.sigma = std::numeric_limits<double>::infinity()};

}  // namespace

// Within a tag that moves by v a second, a row further by s along the direction d of the rows is drawn v t s further: J
// is seen as (1 + V)J with V = t v d^T. As a map of complex numbers V z = t v (conj(d) z + d conj(z))/2, so that a
// square has the skew t v d/2, beside that of a camera out of the normal, which is linear over the picture.
LastCoefficient row_time_of(std::span<const std::vector<SeriesEntry>> series, const Place& rows) {
  constexpr Eigen::Index columns = 7;
  const auto count = static_cast<Eigen::Index>(count_of(series));
  if (2 * count < 4 * columns) return untold;
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(2 * count, columns);
  Eigen::VectorXd values(2 * count);
  Eigen::VectorXd times(2 * count);
  Eigen::Index row = 0;
  for (const auto& each : series)
    for (const SeriesEntry& entry : each) {
      const std::complex<double> skew = ComplexMap(entry.sighting->shape).skew();
      const Place place = 1e-3 * entry.sighting->centre;
      const std::complex<double> by_row_time =
          0.5 * std::complex<double>(rows.x(), rows.y()) * std::complex<double>(entry.velocity.x(), entry.velocity.y());
      for (Eigen::Index part = 0; part < 2; ++part, ++row) {
        terms.row(row).segment<3>(3 * part) << 1.0, place.x(), place.y();
        terms(row, columns - 1) = part == 0 ? by_row_time.real() : by_row_time.imag();
        times[row] = entry.time;
        values[row] = part == 0 ? skew.real() : skew.imag();
      }
    }
  // Columns of like size; a constant place or a tag at rest leaves columns that say nothing.
  const double size = std::max(1e-12, terms.col(columns - 1).norm() / std::sqrt(static_cast<double>(2 * count)));
  terms.col(columns - 1) /= size;
  const LastCoefficient scaled = robust_last_coefficient(terms, values, times);
  return {.value = scaled.value / size, .sigma = scaled.sigma / size};
}

// A motion by v during the exposure E adds v v^T E^2/12 to the second moments of the blur.
LastCoefficient squared_exposure_of(std::span<const std::vector<SeriesEntry>> series) {
  const auto count = static_cast<Eigen::Index>(count_of(series));
  constexpr Eigen::Index fewest = 8;
  if (count < fewest) return untold;
  Eigen::MatrixXd terms(count, 2);
  Eigen::VectorXd values(count);
  Eigen::VectorXd times(count);
  Eigen::Index row = 0;
  for (const auto& each : series)
    for (const SeriesEntry& entry : each) {
      const Place along = entry.velocity.normalized();
      const Place across(-along.y(), along.x());
      const Eigen::Matrix2d& blur = entry.sighting->blur;
      values[row] = along.dot(blur * along) - across.dot(blur * across);
      times[row] = entry.time;
      terms.row(row++) << 1.0, entry.velocity.squaredNorm() / 12.0;
    }
  const double size = std::max(1e-12, terms.col(1).maxCoeff());
  terms.col(1) /= size;
  const LastCoefficient scaled = robust_last_coefficient(terms, values, times);
  return {.value = scaled.value / size, .sigma = scaled.sigma / size};
}

Eigen::Matrix2d without_rolling(const SeriesEntry& entry, double row_time, const Place& rows) {
  const Eigen::Matrix2d rolling = row_time * entry.velocity * rows.transpose();
  return (Eigen::Matrix2d::Identity() - rolling) * entry.sighting->shape;
}

}  // namespace coilwright::video
