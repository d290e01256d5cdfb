#include "magnetics/charged_faces.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <queue>
#include <vector>

#include "coilwright/magnetics/constants.hpp"
#include "coilwright/magnetics/field.hpp"
#include "magnetics/gauss_legendre.hpp"

namespace coilwright::magnetics {
namespace {

constexpr int order = 8;  // of the rule on a patch, along each side
constexpr double wanted = 1e-8;
constexpr std::size_t most_points = 250'000;

using Vector6 = Eigen::Matrix<double, 6, 1>;  // force, and torque over the magnet's size

/// A place on a face and the charge there per unit of its two coordinates, Wb.
struct Charge {
  Eigen::Vector3d place;
  double density;
};
using Face = std::function<Charge(double, double)>;

struct Patch {
  std::size_t face{};
  std::array<double, 2> low{};
  std::array<double, 2> high{};
  Vector6 sum = Vector6::Zero();
  int longer{};    // the coordinate along which the integrand is less smooth
  double error{};  // of the sum
  std::size_t number{};

  // The worst on top; of equals the older one, so that the order never depends on anything else.
  bool operator<(const Patch& other) const {
    return error != other.error ? error < other.error : number > other.number;
  }
};

/// The faces of a magnet that carry charge, in its own axes, and the ranges of their coordinates.
class Faces {
 public:
  Faces(const Ring& ring, const Eigen::Vector3d& polarisation) {
    for (const double end : {-1.0, 1.0}) {
      if (polarisation.z() == 0.0) break;
      const double height = 0.5 * end * ring.length;
      const double charge = end * polarisation.z();
      add_round({ring.inner_radius, ring.outer_radius}, [height, charge](double angle, double radius) {
        return Charge{{radius * std::cos(angle), radius * std::sin(angle), height}, charge * radius};
      });
    }
    for (const double side : {1.0, -1.0}) {
      const double radius = side > 0.0 ? ring.outer_radius : ring.inner_radius;
      if (radius == 0.0 || polarisation.head<2>().isZero(0.0)) break;
      const double x = side * polarisation.x();
      const double y = side * polarisation.y();
      add_round({-0.5 * ring.length, 0.5 * ring.length}, [=](double angle, double height) {
        return Charge{{radius * std::cos(angle), radius * std::sin(angle), height},
                      radius * (x * std::cos(angle) + y * std::sin(angle))};
      });
    }
  }
  Faces(const Cuboid& cuboid, const Eigen::Vector3d& polarisation) {
    const Eigen::Vector3d half = 0.5 * cuboid.size;
    for (int axis = 0; axis < 3; ++axis)
      for (const double end : {-1.0, 1.0}) {
        if (polarisation[axis] == 0.0) break;
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        patches.push_back({.face = faces.size(), .low = {-half[u], -half[v]}, .high = {half[u], half[v]}});
        faces.push_back([=, level = end * half[axis], charge = end * polarisation[axis]](double p, double q) {
          Charge out{Eigen::Vector3d::Zero(), charge};
          out.place[axis] = level;
          out.place[u] = p;
          out.place[v] = q;
          return out;
        });
      }
  }

  std::vector<Face> faces;
  std::vector<Patch> patches;

 private:
  void add_round(std::array<double, 2> range, Face face) {
    constexpr int parts = 4;
    constexpr double turn = 2.0 * std::numbers::pi / parts;
    for (int i = 0; i < parts; ++i)
      patches.push_back({.face = faces.size(), .low = {turn * i, range[0]}, .high = {turn * (i + 1), range[1]}});
    faces.push_back(std::move(face));
  }
};

class Integral {
 public:
  Integral(const Body& source, Faces faces, double size) : source_(source), faces_(std::move(faces)), size_(size) {}

  [[nodiscard]] EstimatedWrench value() {
    std::priority_queue<Patch> patches;
    Vector6 total = Vector6::Zero();
    double error = 0.0;
    std::size_t number = 0;
    const auto push = [&](Patch patch) {
      patch.number = number++;
      total += patch.sum;
      error += patch.error;
      patches.push(patch);
    };
    // No patch is believed before it has been halved.
    std::vector<Patch> first = faces_.patches;
    for (Patch& patch : first) {
      sum_up(patch, true);
      for (const Patch& half : halves(patch)) push(half);
    }
    while (!patches.empty() && error > wanted * magnitude_ && points_ < most_points) {
      const Patch worst = patches.top();
      patches.pop();
      total -= worst.sum;
      error -= worst.error;
      for (const Patch& half : halves(worst)) push(half);
    }
    return {.wrench = {.force = total.head<3>() / vacuum_permeability,
                       .torque = total.tail<3>() * size_ / vacuum_permeability},
            .error = error / vacuum_permeability};
  }

 private:
  [[nodiscard]] std::array<Patch, 2> halves(const Patch& patch) {
    std::array<Patch, 2> out{patch, patch};
    const auto along = static_cast<std::size_t>(patch.longer);
    const double middle = 0.5 * (patch.low[along] + patch.high[along]);
    out[0].high[along] = middle;
    out[1].low[along] = middle;
    for (Patch& half : out) sum_up(half, false);
    // Half of what the halving has changed for each: the next one changes less.
    const double change = (patch.sum - out[0].sum - out[1].sum).norm();
    for (Patch& half : out) half.error = 0.5 * change;
    return out;
  }

  // The sum over a patch; the first ones also give the sum of the magnitudes.
  void sum_up(Patch& patch, bool first) {
    const QuadratureRule rule = gauss_legendre(order);
    std::array<Charge, order * order> charges;
    std::array<Eigen::Vector3d, order * order> places;
    const Face& face = faces_.faces[patch.face];
    const auto at = [&](std::size_t i, int along) {
      const auto k = static_cast<std::size_t>(along);
      return 0.5 * (patch.low[k] + patch.high[k]) + 0.5 * (patch.high[k] - patch.low[k]) * rule.node[i];
    };
    for (std::size_t i = 0; i < order; ++i)
      for (std::size_t j = 0; j < order; ++j) {
        charges[order * i + j] = face(at(i, 0), at(j, 1));
        places[order * i + j] = charges[order * i + j].place;
      }
    const std::vector<Eigen::Vector3d> field = flux_density({&source_, 1}, places);
    points_ += places.size();
    const double area = (patch.high[0] - patch.low[0]) * (patch.high[1] - patch.low[1]);
    patch.sum.setZero();
    // The highest harmonics that eight points see, along either side.
    std::array<Eigen::Matrix<double, 6, order>, 2> highest;
    highest[0].setZero();
    highest[1].setZero();
    for (std::size_t i = 0; i < order; ++i)
      for (std::size_t j = 0; j < order; ++j) {
        const std::size_t n = order * i + j;
        const Eigen::Vector3d force = area * charges[n].density * field[n];
        Vector6 value;
        value << force, charges[n].place.cross(force) / size_;
        const double weight = rule.weight[i] * rule.weight[j];
        patch.sum += weight * value;
        if (first) magnitude_ += weight * force.norm();
        highest[0].col(static_cast<Eigen::Index>(j)) += rule.weight[i] * legendre(rule.node[i]) * value;
        highest[1].col(static_cast<Eigen::Index>(i)) += rule.weight[j] * legendre(rule.node[j]) * value;
      }
    patch.longer = highest[0].cwiseAbs().sum() >= highest[1].cwiseAbs().sum() ? 0 : 1;
  }

  static double legendre(double x) { return std::legendre(order - 1, x); }

  const Body& source_;
  Faces faces_;
  double size_;
  double magnitude_ = 0.0;
  std::size_t points_ = 0;
};

double target_size(const Ring& ring) {
  return std::hypot(ring.outer_radius, 0.5 * ring.length);
}

double target_size(const Cuboid& cuboid) {
  return 0.5 * cuboid.size.norm();
}

}  // namespace

EstimatedWrench wrench_on_faces(const Body& source, const Magnet& magnet, const Pose& pose) {
  Body seen = source;
  seen.pose = seen_from(pose, source.pose);
  if (auto* other = std::get_if<Magnet>(&seen.part))
    *other = {.shape = other->shape, .remanence = polarisation_of(*other), .recoil_permeability = 1.0};
  const Eigen::Vector3d polarisation = polarisation_of(magnet);
  EstimatedWrench out = std::visit(
      [&](const auto& shape) { return Integral(seen, Faces(shape, polarisation), target_size(shape)).value(); },
      magnet.shape);
  const Eigen::Matrix3d axes = rotation_of(pose);
  out.wrench.force = axes * out.wrench.force;
  out.wrench.torque = axes * out.wrench.torque;
  return out;
}

}  // namespace coilwright::magnetics
