#include "mechanics/plane_strain_hinge.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace coilwright::mechanics {
namespace {

using Points = std::vector<double>;

// From `from` to `to`, the first interval next to `from` the shortest, each `ratio` times the one before.
Points graded(double from, double to, int intervals, double ratio) {
  Points points{from};
  const double first = (to - from) * (ratio - 1.0) / (std::pow(ratio, intervals) - 1.0);
  double at = from;
  for (int i = 0; i + 1 < intervals; ++i) points.push_back(at += first * std::pow(ratio, i));
  points.push_back(to);
  return points;
}

Points merged(const std::vector<Points>& parts) {
  Points all;
  for (const Points& part : parts) all.insert(all.end(), part.begin(), part.end());
  std::ranges::sort(all);
  Points out;
  for (const double x : all)
    if (out.empty() || x - out.back() > 1e-9 * (all.back() - all.front())) out.push_back(x);
  return out;
}

// A displacement as a sum of unknowns.
using Sum = std::vector<std::pair<int, double>>;

struct Shape {
  std::array<double, 8> along_x;
  std::array<double, 8> along_y;
};

constexpr std::array<std::array<int, 2>, 8> node_places = {
    {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}};

// Slopes of the eight serendipity functions at (r, s), over r and s.
Shape slopes(double r, double s) {
  Shape out;
  for (std::size_t i = 0; i < 8; ++i) {
    const double a = node_places[i][0] - 1.0;
    const double b = node_places[i][1] - 1.0;
    if (i < 4) {
      out.along_x[i] = 0.25 * a * (1.0 + s * b) * (2.0 * r * a + s * b);
      out.along_y[i] = 0.25 * b * (1.0 + r * a) * (2.0 * s * b + r * a);
    } else if (a == 0.0) {
      out.along_x[i] = -r * (1.0 + s * b);
      out.along_y[i] = 0.5 * b * (1.0 - r * r);
    } else {
      out.along_x[i] = 0.5 * a * (1.0 - s * s);
      out.along_y[i] = -s * (1.0 + r * a);
    }
  }
  return out;
}

using ElementMatrix = Eigen::Matrix<double, 16, 16>;

// Of a rectangle, in units of E'.
ElementMatrix element_stiffness(double width, double height, double poisson) {
  // In plane strain sigma = E' / (1 - n^2) [1 n; n 1] with n = nu / (1 - nu), and G = E' (1 - n) / (2 (1 - n^2)).
  const double n = poisson / (1.0 - poisson);
  Eigen::Matrix3d elasticity;
  elasticity << 1.0, n, 0.0, n, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - n);
  elasticity /= 1.0 - n * n;
  ElementMatrix out = ElementMatrix::Zero();
  const double gauss = 1.0 / std::sqrt(3.0);
  for (const double r : {-gauss, gauss}) {
    for (const double s : {-gauss, gauss}) {
      const Shape shape = slopes(r, s);
      Eigen::Matrix<double, 3, 16> strain = Eigen::Matrix<double, 3, 16>::Zero();
      for (int i = 0; i < 8; ++i) {
        const double dx = shape.along_x[static_cast<std::size_t>(i)] * 2.0 / width;
        const double dy = shape.along_y[static_cast<std::size_t>(i)] * 2.0 / height;
        strain(0, 2 * i) = dx;
        strain(1, 2 * i + 1) = dy;
        strain(2, 2 * i) = dy;
        strain(2, 2 * i + 1) = dx;
      }
      out += strain.transpose() * elasticity * strain * (0.25 * width * height);
    }
  }
  return out;
}

// Unknowns: the turn of the far end (or core), its shift along x and y, then the nodes' own displacements.
class Assembler {
 public:
  Assembler(const HingeBlock& block, Points x, Points y) : block_(block), x_(std::move(x)), y_(std::move(y)) {}

  [[nodiscard]] double stiffness() {
    std::vector<Eigen::Triplet<double>> entries;
    if (!block_.core) entries.emplace_back(2, 2, 1.0);  // a far end keeps its plane, and shifts along x alone
    for (std::size_t i = 0; i + 1 < x_.size(); ++i)
      for (std::size_t k = 0; k + 1 < y_.size(); ++k)
        if (!cut_out(i, k)) add_element(static_cast<int>(i), static_cast<int>(k), entries);
    Eigen::SparseMatrix<double> matrix(unknowns_, unknowns_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    // A unit moment on the half turns it by theta; the block turns by twice that.
    const Eigen::VectorXd moved = factor.solve(Eigen::VectorXd::Unit(unknowns_, 0));
    return 1.0 / (2.0 * moved[0]);
  }

 private:
  [[nodiscard]] bool cut_out(std::size_t i, std::size_t k) const {
    return x_[i + 1] <= 0.5 * block_.slot_width + 1e-12 && y_[k] >= block_.ligament - 1e-12;
  }
  [[nodiscard]] static double at(const Points& points, int half) {
    const auto below = static_cast<std::size_t>(half / 2);
    return half % 2 == 0 ? points[below] : 0.5 * (points[below] + points[below + 1]);
  }
  [[nodiscard]] bool turns_as_one(double x, double y) const {
    if (!block_.core) return false;
    const double face = 0.5 * block_.slot_width + block_.core->wall;
    return x >= face - 1e-12 && y >= block_.core->bottom - 1e-12 && y <= block_.core->top + 1e-12;
  }

  // What the displacement of the node at half steps (i, k) along `direction` (0: x, 1: y) consists of.
  [[nodiscard]] Sum displacement(int i, int k, int direction) {
    const double x = at(x_, i);
    const double y = at(y_, k);
    if (turns_as_one(x, y)) return direction == 0 ? Sum{{0, -y}, {1, 1.0}} : Sum{{0, x}, {2, 1.0}};
    if (direction == 0 && i == 0 && y <= block_.ligament + 1e-12) return {};  // plane of symmetry
    if (direction == 1 && i == 0 && k == 0) return {};                        // held from drifting
    if (direction == 0 && x >= block_.half_length - 1e-12) return {{0, -y}, {1, 1.0}};
    const auto [place, added] = own_.try_emplace({i, k, direction}, unknowns_);
    if (added) ++unknowns_;
    return {{place->second, 1.0}};
  }

  void add_element(int i, int k, std::vector<Eigen::Triplet<double>>& entries) {
    const auto column = static_cast<std::size_t>(i);
    const auto row = static_cast<std::size_t>(k);
    const double modulus = y_[row] >= block_.ligament - 1e-12 ? block_.modulus_above : 1.0;
    const ElementMatrix own =
        modulus * element_stiffness(x_[column + 1] - x_[column], y_[row + 1] - y_[row], block_.poisson_ratio);
    std::array<Sum, 16> sums;
    for (std::size_t node = 0; node < 8; ++node)
      for (int direction = 0; direction < 2; ++direction)
        sums[2 * node + static_cast<std::size_t>(direction)] =
            displacement(2 * i + node_places[node][0], 2 * k + node_places[node][1], direction);
    for (std::size_t a = 0; a < 16; ++a)
      for (std::size_t b = 0; b < 16; ++b)
        for (const auto& [first, first_share] : sums[a])
          for (const auto& [second, second_share] : sums[b])
            entries.emplace_back(
                first, second,
                first_share * second_share * own(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
  }

  HingeBlock block_;
  Points x_;
  Points y_;
  std::map<std::array<int, 3>, int> own_;
  int unknowns_ = 3;
};

}  // namespace

double hinge_stiffness_by_elements(const HingeBlock& block, int levels, double ratio) {
  const double edge = 0.5 * block.slot_width;
  // Elements near the edge of the cut are as small on every side of it, or the coarse side would decide.
  const double smallest = block.ligament * (ratio - 1.0) / (std::pow(ratio, levels) - 1.0);
  const auto outward = [&](double from, double to) {
    const double span = std::abs(to - from);
    const int intervals =
        std::max(2, static_cast<int>(std::lround(std::log1p(span / smallest * (ratio - 1.0)) / std::log(ratio))));
    return graded(from, to, intervals, ratio);
  };
  std::vector<Points> x{outward(edge, block.half_length)};
  if (edge > 0.0) x.push_back(outward(edge, 0.0));
  std::vector<Points> y{graded(block.ligament, 0.0, levels, ratio), outward(block.ligament, block.height)};
  if (block.core) {
    x.push_back({edge + block.core->wall});
    y.push_back({block.core->bottom, block.core->top});
  }
  return Assembler(block, merged(x), merged(y)).stiffness();
}

}  // namespace coilwright::mechanics
