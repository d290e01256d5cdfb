#include "thermal/finite_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/SparseCholesky>

#include "coilwright/thermal/paths.hpp"

namespace coilwright::thermal {
namespace {

constexpr int rings = 5;                 // of a coil
constexpr double core_layer = 1.6e-3;    // m, about
constexpr double end_layer = 1.5e-3;     // of a solid end, m, about
constexpr double face_radiation = 8.2;   // as in the network, W/(m2 K)
constexpr double magnet_contact = 1e-9;  // m2 K/W, of a magnet's surface: it has one temperature

}  // namespace

FiniteVolumes::FiniteVolumes(const HeatChain& chain, double cell) : chain_{chain} {
  nx_ = static_cast<int>(std::lround(0.5 * chain.width / cell));
  ny_ = static_cast<int>(std::lround(chain.height / cell));
  dx_ = 0.5 * chain.width / nx_;
  dy_ = chain.height / ny_;
  cut_layers();
  number_unknowns();
  for (std::size_t l = 0; l < layers_.size(); ++l) join_across(l);
  for (std::size_t l = 0; l < layers_.size(); ++l) join_along(l);
}

void FiniteVolumes::cut_layers() {
  const auto add_layers = [this](std::size_t segment, bool core, double length, double about) {
    if (length == 0.0) return;
    const int count = std::max(1, static_cast<int>(std::lround(length / about)));
    for (int i = 0; i < count; ++i) layers_.push_back({.segment = segment, .core = core, .length = length / count});
  };
  const std::size_t count = chain_.segments.size();
  for (std::size_t i = 0; i < count; ++i) {
    const HeatSegment& segment = chain_.segments[i];
    if (i == 0) add_layers(i, false, segment.solid_end, end_layer);
    add_layers(i, false, segment.wall, core_layer);
    add_layers(i, true, segment.core_length, core_layer);
    add_layers(i, false, segment.wall, core_layer);
    if (i > 0 && i + 1 == count) add_layers(i, false, segment.solid_end, end_layer);
    layers_.back().last = true;
  }
}

int FiniteVolumes::add(double capacity) {
  capacity_.push_back(capacity);
  diagonal_.push_back(0.0);
  return static_cast<int>(capacity_.size()) - 1;
}

int& FiniteVolumes::at(std::size_t layer, int x, int y) {
  return grid_[(layer * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(y)) * static_cast<std::size_t>(nx_) +
               static_cast<std::size_t>(x)];
}

double FiniteVolumes::radius_at(int x, int y) const {
  const double axis = chain_.axis_offset + 0.5 * chain_.hinge_layer;
  return std::hypot((x + 0.5) * dx_, (y + 0.5) * dy_ - axis);
}

bool FiniteVolumes::in_core(std::size_t layer, int x, int y) const {
  if (!layers_[layer].core) return false;
  const HeatSegment& segment = chain_.segments[layers_[layer].segment];
  const double radius = radius_at(x, y);
  return radius < segment.core_radius && radius >= segment.bore_radius;
}

double FiniteVolumes::half_path(std::size_t layer, int x, int y) const {
  const HeatSegment& segment = chain_.segments[layers_[layer].segment];
  if (!in_core(layer, x, y)) return 0.5 * layers_[layer].length / chain_.silicone_conductivity;
  return segment.kind == NodeKind::coil ? 0.5 * layers_[layer].length / segment.core_conductivity : magnet_contact;
}

// Rings of a coil and the whole of a magnet are one unknown for many cells. All capacities and heats are halves.
void FiniteVolumes::number_unknowns() {
  grid_.assign(layers_.size() * static_cast<std::size_t>(nx_ * ny_), -1);
  std::map<std::size_t, int> magnet_of;
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    const Layer& layer = layers_[l];
    const HeatSegment& segment = chain_.segments[layer.segment];
    const double silicone = chain_.silicone_heat_capacity;
    const double bore = silicone * std::numbers::pi * segment.bore_radius * segment.bore_radius * segment.core_length;
    const double capacity = 0.5 * (segment.core_heat_capacity - bore);
    std::vector<std::pair<int, int>> ring(rings, {-1, 0});  // unknown, cells
    int cells = 0;
    for (int y = 0; y < ny_; ++y) {
      for (int x = 0; x < nx_; ++x) {
        if (!in_core(l, x, y)) {
          at(l, x, y) = add(silicone * dx_ * dy_ * layer.length);
        } else if (segment.kind == NodeKind::magnet) {
          if (!magnet_of.contains(layer.segment)) {
            magnet_of[layer.segment] = add(capacity);
            magnets_.push_back(magnet_of[layer.segment]);
          }
          at(l, x, y) = magnet_of[layer.segment];
        } else {
          const double depth = (radius_at(x, y) - segment.bore_radius) / (segment.core_radius - segment.bore_radius);
          auto& [unknown, count] = ring[static_cast<std::size_t>(depth * rings)];
          if (unknown < 0) unknown = add(0.0);
          at(l, x, y) = unknown;
          ++count;
          ++cells;
        }
      }
    }
    if (cells == 0) continue;
    const double step = (segment.core_radius - segment.bore_radius) / rings;
    const double part = layer.length / segment.core_length;
    for (int r = 0; r < rings; ++r) {
      const auto [unknown, count] = ring[static_cast<std::size_t>(r)];
      const double share = part * count / cells;
      capacity_[static_cast<std::size_t>(unknown)] = capacity * share;
      heated_.push_back({.unknown = unknown, .segment = layer.segment, .share = share});
      const double middle = segment.bore_radius + (r + 0.5) * step;
      const double around = std::numbers::pi * segment.core_conductivity * layer.length;
      if (r + 1 < rings) {
        link(unknown, ring[static_cast<std::size_t>(r) + 1].first, around / std::log((middle + step) / middle));
        continue;
      }
      // Cells outside meet the coil's surface, not the middle of its last ring.
      const int surface = add(0.0);
      link(unknown, surface, around / std::log(segment.core_radius / middle));
      for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
          if (in_core(l, x, y) || radius_at(x, y) < segment.core_radius) continue;
          const auto meets = [&](int nx, int ny, double area, double distance) {
            if (nx < 0 || ny < 0 || nx >= nx_ || ny >= ny_ || !in_core(l, nx, ny)) return;
            link(surface, at(l, x, y), chain_.silicone_conductivity * area * layer.length / (0.5 * distance));
          };
          meets(x - 1, y, dy_, dx_);
          meets(x, y - 1, dx_, dy_);
          meets(x, y + 1, dx_, dy_);
        }
      }
    }
  }
}

void FiniteVolumes::link(int first, int second, double conductance) {
  if (first == second) return;
  to_ambient(first, conductance);
  to_ambient(second, conductance);
  links_.emplace_back(first, second, -conductance);
  links_.emplace_back(second, first, -conductance);
}

void FiniteVolumes::join_across(std::size_t layer) {
  const double length = layers_[layer].length;
  const HeatSegment& segment = chain_.segments[layers_[layer].segment];
  const double k = chain_.silicone_conductivity;
  const auto pair = [&](int x, int y, int x2, int y2, double width, double distance) {
    const bool first = in_core(layer, x, y);
    const bool second = in_core(layer, x2, y2);
    if (first && second) return;  // rings are joined already
    double path = distance / k;
    if (first != second) {
      const double silicone = first ? radius_at(x2, y2) : radius_at(x, y);
      // A coil's outer surface is joined already; a bore meets the innermost ring.
      if (segment.kind == NodeKind::coil && silicone >= segment.core_radius) return;
      path *= 0.5;
    }
    link(at(layer, x, y), at(layer, x2, y2), width * length / path);
  };
  const auto film = [&](int x, int y, double width, double distance) {
    to_ambient(at(layer, x, y), width * length / (0.5 * distance / k + 1.0 / chain_.heat_transfer));
  };
  for (int y = 0; y < ny_; ++y) {
    for (int x = 0; x < nx_; ++x) {
      if (x + 1 < nx_) pair(x, y, x + 1, y, dy_, dx_);
      if (y + 1 < ny_) pair(x, y, x, y + 1, dx_, dy_);
    }
    film(nx_ - 1, y, dy_, dx_);
  }
  for (int x = 0; x < nx_; ++x) {
    film(x, 0, dx_, dy_);
    film(x, ny_ - 1, dx_, dy_);
  }
}

void FiniteVolumes::join_along(std::size_t layer) {
  const double area = dx_ * dy_;
  for (int y = 0; y < ny_; ++y) {
    for (int x = 0; x < nx_; ++x) {
      const double path = half_path(layer, x, y);
      const double film = area / (path + 1.0 / chain_.heat_transfer);
      if (layer == 0) to_ambient(at(layer, x, y), film);
      if (layer + 1 == layers_.size()) {
        to_ambient(at(layer, x, y), film);
        continue;
      }
      const double conductance = area / (path + half_path(layer + 1, x, y));
      const double angle = layers_[layer].last ? chain_.joint_angles[layers_[layer].segment] : 0.0;
      const double joined = std::clamp(chain_.hinge_layer / dy_ - y, 0.0, 1.0);  // part of the cell in the hinge
      if (angle == 0.0 || joined == 1.0) {
        link(at(layer, x, y), at(layer + 1, x, y), conductance);
        continue;
      }
      link(at(layer, x, y), at(layer + 1, x, y), joined * conductance);
      join_faces(layer, at(layer, x, y), at(layer + 1, x, y), (1.0 - joined) * area, angle,
                 (y + 0.5) * dy_ - 0.5 * chain_.hinge_layer);
    }
  }
}

// Two faces of an open joint, `distance` above the hinge axis: to ambient each, and across the air to each other.
void FiniteVolumes::join_faces(std::size_t layer, int first, int second, double area, double angle, double distance) {
  const double share = open_face_share(angle, (chain_.height - chain_.hinge_layer) / chain_.width);
  const double across = area * (chain_.air_conductivity / (angle * distance) + face_radiation * (1.0 - share));
  const double lost = area * chain_.heat_transfer * share;
  const int faces[2] = {add(0.0), add(0.0)};
  link(first, faces[0], area * chain_.silicone_conductivity / (0.5 * layers_[layer].length));
  link(second, faces[1], area * chain_.silicone_conductivity / (0.5 * layers_[layer + 1].length));
  link(faces[0], faces[1], across);
  to_ambient(faces[0], lost);
  to_ambient(faces[1], lost);
}

FiniteVolumes::Matrix FiniteVolumes::matrix(double mean_square, double per_time) const {
  std::vector<double> diagonal = diagonal_;
  for (std::size_t i = 0; i < diagonal.size(); ++i) diagonal[i] += per_time * capacity_[i];
  for (const Heated& part : heated_)
    diagonal[static_cast<std::size_t>(part.unknown)] -=
        0.5 * mean_square * chain_.temperature_coefficient * chain_.segments[part.segment].resistance * part.share;
  std::vector<Eigen::Triplet<double>> entries = links_;
  for (std::size_t i = 0; i < diagonal.size(); ++i)
    entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal[i]);
  const auto size = static_cast<Eigen::Index>(diagonal.size());
  Matrix out(size, size);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

Eigen::VectorXd FiniteVolumes::heat(double mean_square) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(diagonal_.size()));
  const double warm = 1.0 + chain_.temperature_coefficient * (chain_.ambient - 20.0);
  for (const Heated& part : heated_)
    out(part.unknown) += 0.5 * mean_square * chain_.segments[part.segment].resistance * part.share * warm;
  return out;
}

FiniteVolumes::Temperatures FiniteVolumes::read(const Eigen::VectorXd& rises) const {
  std::map<std::size_t, double> means;
  Temperatures out{.mean = chain_.ambient, .hot_spot = chain_.ambient, .magnet = chain_.ambient};
  for (const Heated& part : heated_) {
    means[part.segment] += part.share * rises(part.unknown);
    out.hot_spot = std::max(out.hot_spot, chain_.ambient + rises(part.unknown));
  }
  for (const auto& [segment, mean] : means) out.mean = std::max(out.mean, chain_.ambient + mean);
  for (const int magnet : magnets_) out.magnet = std::max(out.magnet, chain_.ambient + rises(magnet));
  return out;
}

FiniteVolumes::Temperatures FiniteVolumes::steady(double mean_square) const {
  const Eigen::SimplicialLDLT<Matrix> factor(matrix(mean_square, 0.0));
  return read(factor.solve(heat(mean_square)));
}

// Regula falsi on 1 / rise, which is nearly a straight line over the mean square current.
double FiniteVolumes::continuous_current(double limit) const {
  const double wanted = 1.0 / (limit - chain_.ambient);
  double x = 0.3;
  double before = 0.0;
  double before_value = 0.0;
  for (int i = 0; i < 12; ++i) {
    // x / rise is finite at zero and falls to zero at the runaway.
    const double rise = steady(x).hot_spot - chain_.ambient;
    const double value = x / rise - x * wanted;
    if (std::abs(rise * wanted - 1.0) < 1e-5) break;
    const double next = i == 0 ? x * 1.2 : x - value * (x - before) / (value - before_value);
    before = x;
    before_value = value;
    x = next;
  }
  return std::sqrt(x);
}

double FiniteVolumes::time_to_limit(double current, double limit, double step) const {
  const double mean_square = current * current;
  const Eigen::SimplicialLDLT<Matrix> factor(matrix(mean_square, 1.0 / step));
  const Eigen::VectorXd source = heat(mean_square);
  Eigen::VectorXd capacity(source.size());
  for (Eigen::Index i = 0; i < source.size(); ++i) capacity(i) = capacity_[static_cast<std::size_t>(i)] / step;
  Eigen::VectorXd rises = Eigen::VectorXd::Zero(source.size());
  double before = chain_.ambient;
  for (int n = 1; n < 4000; ++n) {
    rises = factor.solve(source + capacity.cwiseProduct(rises)).eval();
    const double now = read(rises).hot_spot;
    if (now >= limit) return step * (n - 1 + (limit - before) / (now - before));
    before = now;
  }
  return HUGE_VAL;
}

}  // namespace coilwright::thermal
