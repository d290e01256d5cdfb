#include "measurement/misfit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace coilwright::measurement {
namespace {

using Values = Eigen::VectorXd;

Values values_of(const std::vector<double>& values) {
  return Eigen::Map<const Values>(values.data(), static_cast<Eigen::Index>(values.size()));
}

double angle_between(const Values& a, const Values& b) {
  const double norms = a.norm() * b.norm();
  return norms > 0.0 ? std::acos(std::clamp(a.dot(b) / norms, -1.0, 1.0)) : 0.5 * M_PI;
}

}  // namespace

double MissedSquares::rms() const {
  return std::sqrt(missed / static_cast<double>(count));
}

void add(MissedSquares& sums, const DeclaredReadings& readings) {
  const Values measured = values_of(readings.measured);
  sums.missed += (measured - values_of(readings.declared)).squaredNorm();
  sums.varied += (measured.array() - measured.mean()).matrix().squaredNorm();
  sums.count += readings.measured.size();
}

double RelativeDistance::whole() const {
  return std::hypot(size, shape);
}

RelativeDistance relative_distance(const DeclaredReadings& readings) {
  constexpr double varies = 0.1;         // of the size
  constexpr double least_varied = 0.01;  // of what is declared: it may vary by less, and no ratio is made of that
  const Values measured = values_of(readings.measured);
  const Values declared = values_of(readings.declared);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!measured.allFinite() || !declared.allFinite() || measured.norm() == 0.0 || declared.norm() == 0.0)
    return {.size = infinity, .shape = infinity};
  RelativeDistance out{.size = std::log(measured.norm() / declared.norm()), .shape = angle_between(measured, declared)};
  const Values about = measured.array() - measured.mean();
  const Values declared_about = declared.array() - declared.mean();
  if (about.norm() < varies * measured.norm() && declared_about.norm() < varies * declared.norm()) return out;
  const double size = std::log(about.norm() / std::max(declared_about.norm(), least_varied * declared.norm()));
  return {.size = std::hypot(out.size, size), .shape = std::hypot(out.shape, angle_between(about, declared_about))};
}

}  // namespace coilwright::measurement
