#include "video/film_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <utility>

namespace film {
namespace {

struct Point {
  double x;
  double y;
};

// The tags as they are printed: ArUco's DICT_4X4_50, numbers 0 to 2, border included; '#' is black.
constexpr std::array<std::array<const char*, 6>, 3> tags{
    {{"######", "# #  #", "## # #", "###  #", "### ##", "######"},
     {"######", "######", "#    #", "# ## #", "# # ##", "######"},
     {"######", "###  #", "###  #", "### ##", "#  # #", "######"}}};

// A body of the scene: a segment, or the base, that carries a tag or none.
struct Body {
  Point origin;  // upper end
  double sine;   // of the angle from straight down
  double cosine;
  double length;
  double tag_along;  // of the tag's middle from the upper end
  int tag;           // -1: none
};

constexpr int sample_count = 24;
constexpr double half_width = 9.0;  // mm

constexpr double segment = 30.0;  // mm, length

constexpr Body base{{0.0, -24.0}, 0.0, 1.0, 24.0, 12.0, 0};

std::array<Body, 2> segments_of(const Scene& scene, const std::array<double, 2>& joints) {
  const double first = joints[0];
  const double second = joints[0] + joints[1];
  const Point knee{segment * std::sin(first), segment * std::cos(first)};
  return {{{{0.0, 0.0}, std::sin(first), std::cos(first), segment, 15.0, scene.segment_tag ? 1 : -1},
           {knee, std::sin(second), std::cos(second), segment, 18.0, scene.segment_tag ? 2 : 1}}};
}

// Whether a segment may be at a place during the exposure, or its blur.
bool is_near(const std::vector<std::array<Body, 2>>& bodies, const Point& at) {
  constexpr double margin = 2.0;  // mm, for the blur of the lens and what it moves between these moments
  for (const auto* each : {&bodies.front(), &bodies.back(), &bodies[bodies.size() / 2]})
    for (const Body& body : *each) {
      const double dx = at.x - body.origin.x;
      const double dy = at.y - body.origin.y;
      const double along = dx * body.sine + dy * body.cosine - 0.5 * segment;
      if (std::abs(along) < 0.5 * segment + margin && std::abs(dx * body.cosine - dy * body.sine) < half_width + margin)
        return true;
    }
  return false;
}

// Share of the white paper's light that a place of the scene sends back.
double albedo(const Scene& scene, std::span<const Body> segments, const Point& at) {
  for (std::size_t k = 0; k <= segments.size(); ++k) {
    const Body& body = k < segments.size() ? segments[k] : base;
    const double dx = at.x - body.origin.x;
    const double dy = at.y - body.origin.y;
    const double along = dx * body.sine + dy * body.cosine;
    const double across = dx * body.cosine - dy * body.sine;
    if (along < 0.0 || along >= body.length || std::abs(across) >= half_width) continue;
    if (body.tag >= 0) {
      const double u = across / scene.tag * 6.0 + 3.0;
      const double v = (along - body.tag_along) / scene.tag * 6.0 + 3.0;
      if (u >= 0.0 && u < 6.0 && v >= 0.0 && v < 6.0)
        return tags[body.tag][static_cast<std::size_t>(v)][static_cast<std::size_t>(u)] == '#' ? 0.12 : 1.0;
      if (u >= -1.2 && u < 7.2 && v >= -1.2 && v < 7.2) return 1.0;
    }
    return 0.45;
  }
  return 0.6 + 0.002 * at.x + 0.05 * std::sin(0.31 * at.x) * std::sin(0.23 * at.y);
}

// Squares of 25 mm on paper, 7 by 10, as seen from a hand that moves.
double board_albedo(const Point& at) {
  const double u = at.x / 25.0 + 3.5;
  const double v = at.y / 25.0 + 5.0;
  if (u < -0.5 || u > 7.5 || v < -0.5 || v > 10.5) return 0.5;
  if (u < 0.0 || u >= 7.0 || v < 0.0 || v >= 10.0) return 1.0;
  return (static_cast<int>(u) + static_cast<int>(v)) % 2 == 0 ? 0.12 : 1.0;
}

// Inverse of the distortion by bisection of the radius, which it grows with.
double undistorted_radius(const std::array<double, 2>& k, double drawn) {
  double low = 0.0;
  double high = 3.0 * drawn + 1e-12;
  for (int i = 0; i < 50; ++i) {
    const double r = 0.5 * (low + high);
    (r * (1.0 + r * r * (k[0] + k[1] * r * r)) < drawn ? low : high) = r;
  }
  return 0.5 * (low + high);
}

struct Pose {
  std::array<double, 2> tilt;
  double px_per_mm;
  Point middle;
};

// The ray of a place in the picture: at the depth of 1 it is so far from the middle.
Point ray_of(const Scene& scene, double x, double y) {
  const double dx = (x - 0.5 * (scene.width - 1)) / scene.focal;
  const double dy = (y - 0.5 * (scene.height - 1)) / scene.focal;
  const double drawn = std::hypot(dx, dy);
  const double scale = drawn > 0.0 ? undistorted_radius(scene.distortion, drawn) / drawn : 1.0;
  return {dx * scale, dy * scale};
}

// The scene's plane as the camera has it: turned about the middle, first about x, then about y.
struct Plane {
  Plane(double focal, const Pose& pose) : distance(focal / pose.px_per_mm), middle(pose.middle) {
    const double ca = std::cos(pose.tilt[0]);
    const double sa = std::sin(pose.tilt[0]);
    const double cb = std::cos(pose.tilt[1]);
    const double sb = std::sin(pose.tilt[1]);
    ex = {cb, 0.0, -sb};
    ey = {sa * sb, ca, sa * cb};
    n = {ca * sb, -sa, ca * cb};
  }

  // The place of the plane that a ray meets.
  [[nodiscard]] Point met(const Point& ray) const {
    const double reach = distance * n[2] / (n[0] * ray.x + n[1] * ray.y + n[2]);
    const std::array<double, 3> p{ray.x * reach, ray.y * reach, reach - distance};
    return {middle.x + p[0] * ex[0] + p[1] * ex[1] + p[2] * ex[2],
            middle.y + p[0] * ey[0] + p[1] * ey[1] + p[2] * ey[2]};
  }

  double distance;
  Point middle;
  std::array<double, 3> ex{};
  std::array<double, 3> ey{};
  std::array<double, 3> n{};
};

struct Sample {
  double x;  // of the pixel, 0 to 1
  double y;
  double dx;  // px, of the blur
  double dy;
  double dt;  // of the exposure, -0.5 to 0.5
};

// Over the area of a pixel, the blur of the lens and the exposure; a sequence of low discrepancy (Roberts's R5).
std::vector<Sample> samples_of(const Scene& scene, int count) {
  constexpr double g = 1.17393600286;  // x^6 = x + 1 has it near; any irrational will do
  std::vector<Sample> out;
  for (int i = 0; i < count; ++i) {
    std::array<double, 5> r{};
    for (int k = 0; k < 5; ++k) {
      const double value = 0.5 + (i + 1) / std::pow(g, k + 1);
      r[k] = value - std::floor(value);
    }
    const double radius = scene.optics * std::sqrt(-2.0 * std::log(1.0 - r[2] * 0.9999));
    out.push_back({r[0], r[1], radius * std::cos(2.0 * M_PI * r[3]), radius * std::sin(2.0 * M_PI * r[3]),
                   (i + 0.5) / count - 0.5});
  }
  return out;
}

// Of a number from 0 to 2.
double fraction(double value) {
  return value < 1.0 ? value : value - 1.0;
}

// Mean over the samples of a pixel. In each they are shifted otherwise: alike in all, their error would be one too.
template <class Light>
double mean_light(const std::array<float, 6>& seen, const std::vector<Sample>& samples, std::size_t pixel,
                  const Light& light) {
  const std::uint64_t hash = (pixel + 1) * 0x9E3779B97F4A7C15U;
  const double x = static_cast<double>(hash >> 40U) / (1 << 24);
  const double y = static_cast<double>((hash * 0xD1B54A32D192ED03U) >> 40U) / (1 << 24);
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double dx = samples[i].dx + fraction(samples[i].x + x) - 0.5;
    const double dy = samples[i].dy + fraction(samples[i].y + y) - 0.5;
    sum += light(i, Point{seen[0] + seen[2] * dx + seen[4] * dy, seen[1] + seen[3] * dx + seen[5] * dy});
  }
  return sum / static_cast<double>(samples.size());
}

Pose pose_of(const Scene& scene, int number) {
  if (!scene.board) return {scene.tilt, scene.px_per_mm, {scene.middle[0], scene.middle[1]}};
  const double k = number;
  return {{0.45 * std::sin(1.7 * k), 0.45 * std::cos(2.3 * k)},
          scene.px_per_mm * (1.0 + 0.15 * std::sin(k)),
          {20.0 * std::sin(0.9 * k), 15.0 * std::cos(1.3 * k)}};
}

double led_light(const Scene& scene, int x, int y, double time) {
  if (scene.led[0] < 0.0 || std::hypot(x - scene.led[0], y - scene.led[1]) > 6.0) return -1.0;
  const double share = (time + 0.5 * scene.exposure - scene.led[2]) / scene.exposure;
  return 0.1 + 1.1 * std::clamp(share, 0.0, 1.0);
}

}  // namespace

std::array<double, 2> Motion::at(double time) const {
  if (time <= times.front()) return angles.front();
  if (time >= times.back()) return angles.back();
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
  const double share = (time - times[after - 1]) / (times[after] - times[after - 1]);
  std::array<double, 2> out{};
  for (std::size_t k = 0; k < 2; ++k) out[k] = angles[after - 1][k] * (1.0 - share) + angles[after][k] * share;
  return out;
}

Renderer::Renderer(const Scene& scene, Motion motion) : scene_(scene), motion_(std::move(motion)) {
  for (int y = 0; y <= scene.height; ++y)
    for (int x = 0; x <= scene.width; ++x) {
      const Point ray = ray_of(scene, x, y);
      rays_.push_back({ray.x, ray.y});
    }
  if (!scene.board) see(0);
}

// What does not change from picture to picture.
void Renderer::see(int number) {
  const std::vector<Sample> samples = samples_of(scene_, sample_count);
  const Plane plane(scene_.focal, pose_of(scene_, number));
  const auto place_at = [&](int x, int y) {
    const std::array<double, 2>& ray = rays_[static_cast<std::size_t>(y) * (scene_.width + 1) + x];
    return plane.met({ray[0], ray[1]});
  };
  seen_.clear();
  still_.clear();
  for (int y = 0; y < scene_.height; ++y)
    for (int x = 0; x < scene_.width; ++x) {
      const Point at = place_at(x, y);
      const Point right = place_at(x + 1, y);
      const Point below = place_at(x, y + 1);
      const std::array<double, 6> all{at.x, at.y, right.x - at.x, right.y - at.y, below.x - at.x, below.y - at.y};
      seen_.emplace_back();
      std::ranges::transform(all, seen_.back().begin(), [](double value) { return static_cast<float>(value); });
      still_.push_back(
          static_cast<float>(mean_light(seen_.back(), samples, still_.size(), [&](std::size_t, const Point& place) {
            return scene_.board ? board_albedo(place) : albedo(scene_, std::span(&base, 1), place);
          })));
    }
}

std::vector<std::uint8_t> Renderer::render(double time, int number) {
  if (scene_.board) see(number);
  const std::vector<Sample> samples = samples_of(scene_, sample_count);
  std::mt19937_64 random(scene_.seed * 1000003U + static_cast<std::uint64_t>(number));
  std::normal_distribution<float> normal;
  std::vector<std::uint8_t> out;
  // The rows of the sensor: columns of the picture, the last one first, where it was turned clockwise.
  const bool upright = scene_.quarter_turns % 2 != 0;
  const int rows = upright ? scene_.width : scene_.height;
  std::vector<double> row_times;
  std::vector<std::vector<std::array<Body, 2>>> bodies_of_rows;
  for (int row = 0; row < rows; ++row) {
    row_times.push_back(time + scene_.readout * (row - 0.5 * (rows - 1)) / rows);
    auto& bodies = bodies_of_rows.emplace_back();
    for (const Sample& sample : samples)
      bodies.push_back(segments_of(scene_, motion_.at(row_times.back() + sample.dt * scene_.exposure)));
  }
  for (int y = 0; y < scene_.height; ++y) {
    for (int x = 0; x < scene_.width; ++x) {
      const int along = upright ? x : y;
      const bool backwards = scene_.quarter_turns == 1 || scene_.quarter_turns == 2;
      const auto row = static_cast<std::size_t>(backwards ? rows - 1 - along : along);
      const double row_time = row_times[row];
      const std::vector<std::array<Body, 2>>& bodies = bodies_of_rows[row];
      const std::size_t pixel = out.size();
      double light = still_[pixel];
      if (!scene_.board && is_near(bodies, {seen_[pixel][0], seen_[pixel][1]}))
        light = mean_light(seen_[pixel], samples, pixel + 7919U * static_cast<std::size_t>(number),
                           [&](std::size_t i, const Point& place) { return albedo(scene_, bodies[i], place); });
      if (const double led = led_light(scene_, x, y, row_time); led >= 0.0) light = led;
      const double grey = scene_.white * light + scene_.noise * std::sqrt(light) * normal(random);
      out.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(grey), 0L, 255L)));
    }
  }
  return out;
}

}  // namespace film
