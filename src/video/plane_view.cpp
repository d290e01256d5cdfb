#include "video/plane_view.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "video/sighting_series.hpp"

namespace coilwright::video {
namespace {

using Complex = std::complex<double>;

Complex skew_under(const PlaneView& plane, const TagView& view) {
  return ComplexMap(plane.shape(view)).skew();
}

struct Descent {
  Eigen::Vector2d tilt;
  double cost;
};

double cost_of(const Eigen::Vector2d& tilt, std::span<const TagView> views) {
  const PlaneView plane(tilt);
  double sum = 0.0;
  for (const TagView& view : views) sum += std::norm(skew_under(plane, view));
  return sum;
}

// Gauss and Newton with halved steps; two unknowns, two residuals a view.
Descent descend(Eigen::Vector2d tilt, std::span<const TagView> views) {
  double cost = cost_of(tilt, views);
  constexpr int most_steps = 20;
  for (int i = 0; i < most_steps; ++i) {
    Eigen::Matrix2d normal = 1e-9 * static_cast<double>(views.size()) * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    constexpr double step = 1e-4;
    const PlaneView here(tilt);
    const std::array<PlaneView, 2> there = {PlaneView(tilt + step * Eigen::Vector2d::UnitX()),
                                            PlaneView(tilt + step * Eigen::Vector2d::UnitY())};
    for (const TagView& view : views) {
      const Complex skew = skew_under(here, view);
      const std::array<Complex, 2> slope = {(skew_under(there[0], view) - skew) / step,
                                            (skew_under(there[1], view) - skew) / step};
      for (int a = 0; a < 2; ++a) {
        right[a] -= (std::conj(slope[a]) * skew).real();
        for (int b = 0; b < 2; ++b) normal(a, b) += (std::conj(slope[a]) * slope[b]).real();
      }
    }
    Eigen::Vector2d move = normal.ldlt().solve(right);
    double moved = cost_of(tilt + move, views);
    for (int halves = 0; halves < 8 && moved > cost; ++halves) {
      move *= 0.5;
      moved = cost_of(tilt + move, views);
    }
    if (moved >= cost) break;
    tilt += move;
    cost = moved;
    if (move.norm() < 1e-6) break;
  }
  return {.tilt = tilt, .cost = cost};
}

// Sum of the squares of relative sizes about the mean of their tag, which is as large as its noise like that of skews.
double spread_of_sizes(const Eigen::Vector2d& tilt, std::span<const std::vector<TagView>> tags) {
  const PlaneView plane(tilt);
  double out = 0.0;
  for (const auto& views : tags) {
    double sum = 0.0;
    double squares = 0.0;
    for (const TagView& view : views) {
      const double size = 0.5 * std::log(std::abs(plane.shape(view).determinant()));
      sum += size;
      squares += size * size;
    }
    out += squares - sum * sum / static_cast<double>(std::max<std::size_t>(1, views.size()));
  }
  return out;
}

}  // namespace

TagView view_of(const Lens& lens, const Place& centre, const Eigen::Matrix2d& shape) {
  return {.ray = undistorted(lens, centre), .slope = undistortion_slope(lens, centre) * shape};
}

PlaneView::PlaneView(const Eigen::Vector2d& tilt) : tilt_(tilt.norm()) {
  const Eigen::Vector3d axis(tilt.x(), tilt.y(), 0.0);
  turn_ = tilt_ == 0.0 ? Eigen::Matrix3d::Identity() : Eigen::AngleAxisd(tilt_, axis / tilt_).toRotationMatrix();
}

Eigen::Matrix2d PlaneView::shape(const TagView& view) const {
  const Eigen::Vector3d ray = turn_ * Eigen::Vector3d(view.ray.x(), view.ray.y(), 1.0);
  const Eigen::Matrix<double, 3, 2> slope = turn_.leftCols<2>() * view.slope;
  return (slope.topRows<2>() - ray.head<2>() / ray.z() * slope.row(2)) / ray.z();
}

// Skew grows with the square of the tilt, and tells its direction but for half a turn: perspective decides, which
// changes the size of a tag that moves more than its skew.
FittedPlane fit_plane(std::span<const std::vector<TagView>> tags) {
  std::vector<TagView> views;
  for (const auto& each : tags) views.insert(views.end(), each.begin(), each.end());
  Complex mean = 0.0;
  for (const TagView& view : views) mean += ComplexMap(view.slope).skew() / static_cast<double>(views.size());
  const double tilt = 2.0 * std::sqrt(std::min(std::abs(mean), 0.2));
  const double direction = 0.5 * std::arg(mean);
  const Eigen::Vector2d start = tilt * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  Descent one = descend(start, views);
  Descent other = descend(-start, views);
  for (Descent* each : {&one, &other}) each->cost += spread_of_sizes(each->tilt, tags);
  if (one.cost > other.cost) std::swap(one, other);
  constexpr double apart = 1.5;
  const double unseen = 1e-8 * static_cast<double>(views.size());  // a ten-thousandth of skew each
  FittedPlane out{.plane = PlaneView(one.tilt)};
  if (one.tilt.dot(other.tilt) < 0.0 && other.cost < apart * one.cost + unseen) out.rival = PlaneView(other.tilt);
  return out;
}

}  // namespace coilwright::video
