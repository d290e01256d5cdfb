#include "magnetics/surface_quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "magnetics/field_kernels.hpp"
#include "magnetics/gauss_legendre.hpp"
#include "magnetics/radial_nodes.hpp"

namespace coilwright::magnetics {
namespace {

constexpr int first_points = 8;
constexpr int max_points = 512;

/// Cosines and sines of the points round a ring. A pose with a mirror plane needs half a ring, midpoints; any other a
/// whole one, a quarter step off so that even and odd harmonics both show.
struct Angles {
  std::array<double, max_points> cosine;
  std::array<double, max_points> sine;
};

enum class Symmetry { none, mirror };

const Angles& angles(Symmetry symmetry, int points) {
  static const auto table = [] {
    std::array<std::array<Angles, 7>, 2> all;
    for (int i = 0, count = first_points; i < 7; ++i, count *= 2)
      for (int j = 0; j < count; ++j) {
        const double half = std::numbers::pi * (j + 0.5) / count;
        const double whole = 2.0 * std::numbers::pi * (j + 0.25) / count;
        all[0][i].cosine[j] = std::cos(whole);
        all[0][i].sine[j] = std::sin(whole);
        all[1][i].cosine[j] = std::cos(half);
        all[1][i].sine[j] = std::sin(half);
      }
    return all;
  }();
  int index = 0;
  for (int count = first_points; count < points; count *= 2) ++index;
  return table[symmetry == Symmetry::mirror ? 1 : 0][index];
}

/// The pose turned about the source's axis so that the target's axis has no y component.
struct Frame {
  Eigen::Vector3d position;
  Eigen::Vector3d axis;
  double cosine;  // of the turn
  double sine;
  Symmetry symmetry;
};

Frame upright_frame(const Eigen::Vector3d& position, const Eigen::Vector3d& axis, double size) {
  const bool tilted = std::hypot(axis.x(), axis.y()) > 1e-14;
  const double x = tilted ? axis.x() : position.x();
  const double y = tilted ? axis.y() : position.y();
  const double length = std::hypot(x, y);
  const double cosine = length > 0.0 ? x / length : 1.0;
  const double sine = length > 0.0 ? y / length : 0.0;
  const auto turn = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(cosine * v.x() + sine * v.y(), cosine * v.y() - sine * v.x(), v.z());
  };
  Frame frame{turn(position), turn(axis), cosine, sine, Symmetry::none};
  frame.axis.y() = 0.0;
  // Off the plane by rounding only: the error of putting it on the plane is of the same size.
  if (std::abs(frame.position.y()) <= 1e-15 * size) {
    frame.position.y() = 0.0;
    frame.symmetry = Symmetry::mirror;
  }
  return frame;
}

double distance_to(double rho, double z, double radius, double height) {
  return std::sqrt((rho - radius) * (rho - radius) + (z - height) * (z - height));
}

/// Convergence of Gauss-Legendre along the target: the integrand on each straight line along its side is singular at
/// the source's edges. Looks at the lines that face the source, spread over the angle under which the target's axis
/// sees it.
double rate_along(const SheetBody& source, const TargetSheet& target, const Frame& frame) {
  constexpr int lines = 12;
  const double towards_x = frame.position.z() * frame.axis.x() - frame.position.x() * frame.axis.z();
  const double towards_y = -frame.position.y();
  const double apart = std::sqrt(towards_x * towards_x + towards_y * towards_y);
  const double facing = apart > 0.0 ? std::atan2(towards_y, towards_x) : 0.0;
  const double seen = 1.2 * (source.outer_radius + source.half_length);
  const double spread = apart > seen ? std::asin(seen / apart) : std::numbers::pi;
  const double first = frame.symmetry == Symmetry::mirror ? 0.0 : -spread;
  double nearest = 1e300;
  for (int j = 0; j < lines; ++j) {
    const double angle = facing + first + (spread - first) * j / (lines - 1);
    const double across = target.radius * std::cos(angle);
    const double y = frame.position.y() + target.radius * std::sin(angle);
    std::array<double, 2> rho;
    std::array<double, 2> z;
    for (int end = 0; end < 2; ++end) {
      const double along = end == 0 ? -target.half_length : target.half_length;
      const double x = frame.position.x() + across * frame.axis.z() + along * frame.axis.x();
      rho[end] = std::sqrt(x * x + y * y);
      z[end] = frame.position.z() - across * frame.axis.x() + along * frame.axis.z();
    }
    for (const double edge : {source.inner_radius, source.outer_radius})
      for (const double face : {-source.half_length, source.half_length})
        nearest = std::min(nearest, distance_to(rho[0], z[0], edge, face) + distance_to(rho[1], z[1], edge, face));
  }
  return gauss_rate(nearest, 2.0 * target.half_length);
}

struct RingSum {
  Wrench wrench;
  double size;      // mean magnitude of the field on the ring
  double harmonic;  // share of the highest harmonic the points can see
};

class RingIntegrator {
 public:
  RingIntegrator(const SheetBody& source, const TargetSheet& target, const Frame& frame, const Accuracy& accuracy)
      : source_(source), frame_(frame), log_error_(accuracy.log_radial) {
    const double nearest = frame.position.norm() - target.radius - target.half_length - source.outer_radius;
    const double to_ends = 2.0 * std::max(nearest - source.half_length, 0.0) + 2.0 * source.half_length;
    const double needed = gauss_nodes_needed(gauss_rate(to_ends, 2.0 * source.half_length), log_error_) + 1.0;
    if (needed <= 4.0) loops_ = static_cast<int>(std::ceil(needed));
  }

  /// Mean over the points of a ring of unit current of the force and torque per length.
  [[nodiscard]] RingSum sum(double radius, double along, int points) const {
    const Angles& round = angles(frame_.symmetry, points);
    const auto n = static_cast<std::size_t>(points);
    std::array<double, max_points> x;
    std::array<double, max_points> y;
    std::array<double, max_points> z;
    std::array<double, max_points> rho;
    std::array<double, max_points> radial;
    std::array<double, max_points> axial;
    const double nx = frame_.axis.x();
    const double nz = frame_.axis.z();
    for (int j = 0; j < points; ++j) {
      const double across = radius * round.cosine[j];
      x[j] = frame_.position.x() + across * nz + along * nx;
      y[j] = frame_.position.y() + radius * round.sine[j];
      z[j] = frame_.position.z() - across * nx + along * nz;
      rho[j] = std::sqrt(x[j] * x[j] + y[j] * y[j]);
    }
    const FieldPoints at{{rho.data(), n}, {z.data(), n}};
    const FieldValues field{{radial.data(), n}, {axial.data(), n}};
    if (loops_ > 0)
      field_of_loops(source_, log_error_, gauss_legendre(loops_), at, field);
    else
      field_of_sheets(source_, log_error_, at, field);

    double fx = 0.0, fy = 0.0, fz = 0.0, tx = 0.0, ty = 0.0, tz = 0.0, size = 0.0;
    double outward_harmonic = 0.0, lengthwise_harmonic = 0.0, sign = 1.0;
    for (int j = 0; j < points; ++j) {
      const double over = radial[j] / std::max(rho[j], 1e-300);
      const double hx = x[j] * over;
      const double hy = y[j] * over;
      const double hz = axial[j];
      const double ux = -round.sine[j] * nz;
      const double uy = round.cosine[j];
      const double uz = round.sine[j] * nx;
      const double outward = round.cosine[j] * (nz * hx - nx * hz) + round.sine[j] * hy;
      const double lengthwise = nx * hx + nz * hz;
      const double moment = radius * outward + along * lengthwise;
      fx += uy * hz - uz * hy;
      fy += uz * hx - ux * hz;
      fz += ux * hy - uy * hx;
      tx += ux * moment;
      ty += uy * moment;
      tz += uz * moment;
      size += std::abs(outward) + std::abs(lengthwise);
      const double highest = frame_.symmetry == Symmetry::mirror ? sign * round.sine[j] : sign;
      outward_harmonic += highest * outward;
      lengthwise_harmonic += highest * lengthwise;
      sign = -sign;
    }
    const double mean = 1.0 / points;
    RingSum result{{Eigen::Vector3d(fx, fy, fz) * mean, Eigen::Vector3d(tx, ty, tz) * mean},
                   size * mean,
                   (std::abs(outward_harmonic) + std::abs(lengthwise_harmonic)) * mean};
    if (frame_.symmetry == Symmetry::mirror) {
      result.wrench.force.y() = 0.0;
      result.wrench.torque.x() = 0.0;
      result.wrench.torque.z() = 0.0;
    }
    return result;
  }

 private:
  const SheetBody& source_;
  const Frame& frame_;
  double log_error_;
  int loops_ = 0;
};

/// Rings one after the other, each with as many points as its field needs; neighbours need about as many.
class RingByRing {
 public:
  RingByRing(const SheetBody& source, const TargetSheet& target, const Frame& frame, const Accuracy& accuracy)
      : rings_(source, target, frame, accuracy), least_harmonic_(accuracy.harmonic) {}

  void add(double radius, double along, double weight) {
    RingSum ring = rings_.sum(radius, along, points_);
    largest_ = std::max(largest_, ring.size);
    while (ring.harmonic > least_harmonic_ * largest_ && points_ < max_points) {
      points_ *= 2;
      ring = rings_.sum(radius, along, points_);
    }
    if (ring.harmonic < least_harmonic_ * least_harmonic_ * largest_ && points_ > first_points) points_ /= 2;
    total_.force += weight * ring.wrench.force;
    total_.torque += weight * ring.wrench.torque;
  }

  [[nodiscard]] const Wrench& total() const noexcept { return total_; }

 private:
  RingIntegrator rings_;
  double least_harmonic_;
  int points_ = first_points;
  double largest_ = 0.0;
  Wrench total_;
};

double size_of(const SheetBody& source, const TargetSheet& target) {
  return source.outer_radius + source.half_length + target.radius + target.half_length;
}

Wrench turned_back(const Frame& frame, const Wrench& wrench, double scale) {
  const auto turn = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(frame.cosine * v.x() - frame.sine * v.y(), frame.cosine * v.y() + frame.sine * v.x(), v.z());
  };
  return {turn(scale * wrench.force), turn(scale * wrench.torque)};
}

}  // namespace

Wrench lorentz_wrench(const SheetBody& source, const TargetSheet& target, const Eigen::Vector3d& position,
                      const Eigen::Vector3d& axis, const Accuracy& accuracy) {
  const Frame frame = upright_frame(position, axis, size_of(source, target));
  const PanelRule rule(gauss_nodes_needed(rate_along(source, target, frame), accuracy.log_along));
  RingByRing sheet(source, target, frame, accuracy);
  for (int i = 0; i < rule.count(); ++i) sheet.add(target.radius, target.half_length * rule.node(i), rule.weight(i));
  return turned_back(frame, sheet.total(), 4.0 * std::numbers::pi * target.radius * target.half_length);
}

Wrench lorentz_wrench(const SheetBody& source, const TargetSheet& target, std::span<const CurrentRing> rings,
                      const Eigen::Vector3d& position, const Eigen::Vector3d& axis, const Accuracy& accuracy) {
  const Frame frame = upright_frame(position, axis, size_of(source, target));
  RingByRing sum(source, target, frame, accuracy);
  for (const CurrentRing& ring : rings) sum.add(ring.radius, ring.height, ring.radius * ring.current);
  return turned_back(frame, sum.total(), 2.0 * std::numbers::pi);
}

}  // namespace coilwright::magnetics
