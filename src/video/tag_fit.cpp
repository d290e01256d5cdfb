#include "video/tag_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace coilwright::video {
namespace {

// Eight numbers of the homography; light: level, two slopes; contrast; three second moments of the blur, as far as they
// differ from the template's.
constexpr int unknowns = 15;
constexpr int contrast = 11;
using Row = Eigen::Matrix<double, unknowns, 1>;
using Square = Eigen::Matrix<double, unknowns, unknowns>;

// A part of the picture within which compression makes errors alike: a macroblock of H.264.
constexpr int block_side = 16;
struct Block {
  Square normal = Square::Zero();
  Row right = Row::Zero();
};

// Coordinates in which the numbers of the fit are of order 1.
struct LocalFrame {
  Place origin;
  double scale;  // px
};

struct Pixel {
  int x;
  int y;
  double grey;
};

Eigen::Matrix3d local_to_picture(const LocalFrame& frame) {
  Eigen::Matrix3d out = Eigen::Matrix3d::Identity();
  out.topLeftCorner<2, 2>() *= frame.scale;
  out.topRightCorner<2, 1>() = frame.origin;
  return out;
}

Eigen::Matrix2d shape_of(const ToTag& homography) {
  const Eigen::Matrix3d back = homography.inverse();
  const double w = back(2, 2);
  const Place centre = back.topRightCorner<2, 1>() / w;
  return (back.topLeftCorner<2, 2>() - centre * back.bottomLeftCorner<1, 2>()) / w;
}

// The pixels on which the tag lies; of a large one every second or third row and column.
std::vector<Pixel> pixels_of(const Picture& picture, const ToTag& homography, double px_a_module) {
  Place low(1e9, 1e9);
  Place high(-1e9, -1e9);
  for (const double u : {-tag_reach(), tag_reach()})
    for (const double v : {-tag_reach(), tag_reach()}) {
      low = low.cwiseMin(in_picture(homography, u, v));
      high = high.cwiseMax(in_picture(homography, u, v));
    }
  if (low.minCoeff() < 0.0 || high.x() > picture.width - 1 || high.y() > picture.height - 1) return {};
  constexpr double enough = 9.0;  // px a module
  const int stride = std::max(1, static_cast<int>(px_a_module / enough));
  std::vector<Pixel> out;
  for (int y = static_cast<int>(low.y()); y <= high.y(); y += stride)
    for (int x = static_cast<int>(low.x()); x <= high.x(); x += stride) {
      const Eigen::Vector3d at = homography * Eigen::Vector3d(x, y, 1.0);
      if (std::max(std::abs(at.x()), std::abs(at.y())) <= tag_reach() * std::abs(at.z()))
        out.push_back({.x = x, .y = y, .grey = picture.at(x, y)});
    }
  return out;
}

class Fit {
 public:
  Fit(std::vector<Pixel> pixels, const LocalFrame& frame, const TagTemplate& shape, const ToTag& start)
      : pixels_(std::move(pixels)), frame_(frame), template_(shape), local_(start * local_to_picture(frame)) {
    local_ /= local_(2, 2);
  }

  // One step of Gauss and Newton; how far it moves the tag, modules, at most.
  double step() {
    assemble();
    solution_ = normal_.ldlt().solve(right_);
    // The light is linear and has its value by the step; the homography moves by it, as the contrast is known then.
    const double gain = solution_[contrast];
    if (!solution_.allFinite() || std::abs(gain) < 1.0) return 1e9;
    const Eigen::Matrix<double, 8, 1> move = solution_.head<8>() / gain;
    for (int k = 0; k < 8; ++k) local_(k / 3, k % 3) += move[k];
    return move.lpNorm<Eigen::Infinity>();
  }

  [[nodiscard]] ToTag homography() const { return local_ * local_to_picture(frame_).inverse(); }
  [[nodiscard]] double gain() const { return solution_[contrast]; }
  // Second moments of the blur, modules^2.
  [[nodiscard]] Eigen::Matrix2d blur() const {
    Eigen::Matrix2d out = template_.blur() * template_.blur() * Eigen::Matrix2d::Identity();
    const Eigen::Vector3d more = 2.0 * solution_.tail<3>() / gain();
    out(0, 0) += more[0];
    out(1, 1) += more[2];
    out(0, 1) += 0.5 * more[1];
    out(1, 0) += 0.5 * more[1];
    return out;
  }

  // Share of the picture's variance that the fit explains, and variance of the angle by blocks, rad^2.
  struct Quality {
    double explained;
    double angle_variance;
  };
  Quality quality() {
    assemble();
    solution_ = normal_.ldlt().solve(right_);
    std::map<std::pair<int, int>, Block> blocks;
    double squares = 0.0;
    double sum = 0.0;
    double residuals = 0.0;
    for (const Pixel& pixel : pixels_) {
      const Row row = row_of(pixel);
      const double residual = pixel.grey - row.dot(solution_);
      Block& block = blocks[{pixel.x / block_side, pixel.y / block_side}];
      block.normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
      block.right += residual * row;
      residuals += residual * residual;
      squares += pixel.grey * pixel.grey;
      sum += pixel.grey;
    }
    const double count = static_cast<double>(pixels_.size());
    const Row slope = angle_slope();
    double variance = 0.0;
    for (const auto& [place, block] : blocks) {
      const Square others = normal_ - Square(block.normal.selfadjointView<Eigen::Lower>());
      variance += std::pow(slope.dot(others.ldlt().solve(block.right)), 2);
    }
    variance *= 1.0 - 1.0 / static_cast<double>(blocks.size());
    return {.explained = 1.0 - residuals / std::max(1e-9, squares - sum * sum / count), .angle_variance = variance};
  }

 private:
  // Derivatives of a pixel's grey; those of the homography for a contrast of 1, so that the problem is linear.
  [[nodiscard]] Row row_of(const Pixel& pixel) const {
    const double x = (pixel.x - frame_.origin.x()) / frame_.scale;
    const double y = (pixel.y - frame_.origin.y()) / frame_.scale;
    const double w = local_(2, 0) * x + local_(2, 1) * y + 1.0;
    const double u = (local_(0, 0) * x + local_(0, 1) * y + local_(0, 2)) / w;
    const double v = (local_(1, 0) * x + local_(1, 1) * y + local_(1, 2)) / w;
    constexpr double edge = 3.95;
    const Eigen::Matrix<double, 6, 1> t =
        template_.at(std::clamp(u, -edge, edge), std::clamp(v, -edge, edge)).cast<double>();
    const double along_u = t[1] / w;
    const double along_v = t[2] / w;
    const double together = -(along_u * u + along_v * v);
    Row row;
    row << along_u * x, along_u * y, along_u, along_v * x, along_v * y, along_v, together * x, together * y, 1.0, x, y,
        t[0], t[3], t[4], t[5];
    return row;
  }

  void assemble() {
    normal_.setZero();
    right_.setZero();
    for (const Pixel& pixel : pixels_) {
      const Row row = row_of(pixel);
      normal_.selfadjointView<Eigen::Lower>().rankUpdate(row);
      right_ += pixel.grey * row;
    }
    normal_ = normal_.selfadjointView<Eigen::Lower>();
  }

  // Derivative of the angle by what is solved for.
  [[nodiscard]] Row angle_slope() const {
    constexpr double step = 1e-6;
    Row out = Row::Zero();
    const auto angle = [](const Eigen::Matrix3d& local) { return picture_angle(shape_of(local)); };
    for (int k = 0; k < 8; ++k) {
      Eigen::Matrix3d up = local_;
      Eigen::Matrix3d down = local_;
      up(k / 3, k % 3) += step;
      down(k / 3, k % 3) -= step;
      out[k] = std::remainder(angle(up) - angle(down), 2.0 * M_PI) / (2.0 * step * gain());
    }
    return out;
  }

  std::vector<Pixel> pixels_;
  LocalFrame frame_;
  const TagTemplate& template_;
  Eigen::Matrix3d local_;
  Square normal_{};
  Row right_{};
  Row solution_{};
};

TagCorners outline_of(int tag, const ToTag& homography) {
  return {.id = tag,
          .corners = {in_picture(homography, -3, -3), in_picture(homography, 3, -3), in_picture(homography, 3, 3),
                      in_picture(homography, -3, 3)}};
}

}  // namespace

ToTag to_tag(const TagCorners& outline) {
  constexpr std::array<std::array<double, 2>, 4> on_tag{{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}};
  Eigen::Matrix<double, 8, 8> rows = Eigen::Matrix<double, 8, 8>::Zero();
  Eigen::Matrix<double, 8, 1> right;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const auto corner = static_cast<std::size_t>(k);
    const double x = outline.corners[corner].x();
    const double y = outline.corners[corner].y();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const double to = on_tag[corner][static_cast<std::size_t>(axis)];
      rows.row(2 * k + axis).segment<3>(3 * axis) << x, y, 1.0;
      rows.row(2 * k + axis).tail<2>() << -to * x, -to * y;
      right[2 * k + axis] = to;
    }
  }
  const Eigen::Matrix<double, 8, 1> found = rows.partialPivLu().solve(right);
  ToTag out;
  out << found[0], found[1], found[2], found[3], found[4], found[5], found[6], found[7], 1.0;
  return out;
}

ToTag moved(const ToTag& before, const Place& from, const Place& to, double turn) {
  Eigen::Matrix3d back = Eigen::Matrix3d::Identity();
  back.topLeftCorner<2, 2>() << std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn);
  back.topRightCorner<2, 1>() = from - back.topLeftCorner<2, 2>() * to;
  return before * back;
}

Place in_picture(const ToTag& homography, double u, double v) {
  return (homography.inverse() * Eigen::Vector3d(u, v, 1.0)).hnormalized();
}

double picture_angle(const Eigen::Matrix2d& shape) {
  return std::atan2(shape(1, 0) - shape(0, 1), shape(0, 0) + shape(1, 1));
}

std::optional<TagFit> fit_tag(const Picture& picture, int tag, const ToTag& start, double blur,
                              TagTemplates& templates) {
  const double scale = std::sqrt(std::abs(shape_of(start).determinant()));
  constexpr double smallest = 1.5;  // px a module
  if (!(scale >= smallest && scale < 1e4)) return std::nullopt;
  const LocalFrame frame{.origin = in_picture(start, 0, 0), .scale = 3.0 * scale};
  std::vector<Pixel> pixels = pixels_of(picture, start, scale);
  constexpr std::size_t fewest = 60;  // four a number of the fit
  if (pixels.size() < fewest) return std::nullopt;
  Fit fit(std::move(pixels), frame, templates.of(tag, blur), start);
  constexpr int most_steps = 12;
  constexpr double close_enough = 3e-4;  // modules: a thousandth of a degree
  double last = 1e9;
  for (int i = 0; i < most_steps && last > close_enough; ++i) {
    last = fit.step();
    if (last > 2.0) return std::nullopt;
  }
  if (last > 0.03) return std::nullopt;
  const ToTag homography = fit.homography();
  const Eigen::Matrix2d shape = shape_of(homography);
  const auto [explained, variance] = fit.quality();
  constexpr double least_explained = 0.75;
  constexpr double least_contrast = 8.0;  // grey
  const double size = std::sqrt(std::abs(shape.determinant()));
  if (explained < least_explained || fit.gain() < least_contrast || !(std::abs(std::log(size / scale)) < 0.35))
    return std::nullopt;
  const Eigen::Matrix2d moments = fit.blur();
  return TagFit{.homography = homography,
                .sighting = {.id = tag,
                             .centre = in_picture(homography, 0, 0),
                             .shape = shape,
                             .sigma = std::sqrt(variance),
                             .blur = shape * moments * shape.transpose(),
                             .outline = outline_of(tag, homography)},
                .blur = std::sqrt(std::max(1e-4, 0.5 * moments.trace()))};
}

}  // namespace coilwright::video
