#include "coilwright/exports/field_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "coilwright/magnetics/field.hpp"
#include "coilwright/units/unit.hpp"
#include "exports/drawing/sketch.hpp"

namespace coilwright::exports {
namespace {

constexpr double map_width = 0.24;   // m, of the map on paper
constexpr double map_height = 0.15;  // m
constexpr double letter = 2.5e-3;    // m on paper
constexpr int shades = 24;
constexpr double decades = 3.0;
constexpr std::size_t arrows_across = 24;  // about as many along the longer side
constexpr int outline_share = 4;           // parts of a cell in which an outline is looked for

// Matplotlib's viridis (CC0), every eighth of it.
constexpr std::array<std::array<double, 3>, 9> viridis = {{{68, 1, 84},
                                                           {71, 45, 123},
                                                           {59, 82, 139},
                                                           {44, 114, 142},
                                                           {33, 145, 140},
                                                           {40, 174, 128},
                                                           {94, 201, 98},
                                                           {173, 220, 48},
                                                           {253, 231, 37}}};

std::string colour_of(int shade) {
  const double place = static_cast<double>(shade) / (shades - 1) * (viridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  const double share = place - static_cast<double>(below);
  std::array<int, 3> mixed{};
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = static_cast<int>(std::lround(viridis[below][i] + share * (viridis[below + 1][i] - viridis[below][i])));
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

/// Magnitudes as shades: three decades below the largest.
struct Scale {
  double largest{};  // T; > 0

  [[nodiscard]] int shade(double magnitude) const {
    if (!(magnitude > 0.0)) return 0;
    const double place = 1.0 + std::log10(magnitude / largest) / decades;
    return static_cast<int>(std::clamp(std::floor(place * shades), 0.0, shades - 1.0));
  }
  // At the lower end of a shade.
  [[nodiscard]] double value(int shade) const {
    return largest * std::pow(10.0, decades * (static_cast<double>(shade) / shades - 1.0));
  }
};

Scale scale_of(std::span<const Eigen::Vector3d> flux_density) {
  double largest = 0.0;
  for (const Eigen::Vector3d& each : flux_density)
    if (each.allFinite()) largest = std::max(largest, each.norm());
  return {.largest = largest > 0.0 ? largest : 1e-12};
}

// Runs of cells of one shade in a row are one rectangle.
void draw_cells(Sketch& sketch, const MapPlane& plane, std::span<const Eigen::Vector3d> flux_density,
                const Scale& scale) {
  constexpr int none = -1;
  std::map<int, std::vector<Bounds>> areas;
  for (std::size_t row = 0; row < plane.rows; ++row) {
    const double bottom = plane.bottom + plane.cell * static_cast<double>(row);
    const auto shade = [&](std::size_t column) {
      const Eigen::Vector3d& value = flux_density[row * plane.columns + column];
      return value.allFinite() ? scale.shade(value.norm()) : none;
    };
    for (std::size_t first = 0, last = 0; first < plane.columns; first = last) {
      while (last < plane.columns && shade(last) == shade(first)) ++last;
      areas[shade(first)].push_back({{plane.left + plane.cell * static_cast<double>(first), bottom},
                                     {plane.left + plane.cell * static_cast<double>(last), bottom + plane.cell}});
    }
  }
  for (auto& [shade, rectangles] : areas)
    sketch.fill(shade == none ? "#c8ccd0" : colour_of(shade), std::move(rectangles));
}

void draw_arrows(Sketch& sketch, const MapPlane& plane, std::span<const Eigen::Vector3d> flux_density) {
  const std::size_t step = std::max<std::size_t>(1, std::max(plane.columns, plane.rows) / arrows_across);
  const double half = 0.35 * plane.cell * static_cast<double>(step);
  for (std::size_t row = step / 2; row < plane.rows; row += step)
    for (std::size_t column = step / 2; column < plane.columns; column += step) {
      const Eigen::Vector3d& value = flux_density[row * plane.columns + column];
      const Point along{value.dot(plane.right), value.dot(plane.up)};
      const double length = std::hypot(along.x, along.y);
      // Of a field out of the plane nothing would point anywhere.
      if (!value.allFinite() || length <= 1e-3 * value.norm()) continue;
      const double x = half * along.x / length;
      const double y = half * along.y / length;
      const Point middle{plane.left + plane.cell * (static_cast<double>(column) + 0.5),
                         plane.bottom + plane.cell * (static_cast<double>(row) + 0.5)};
      const Point tip{middle.x + x, middle.y + y};
      sketch.line(Layer::field, {middle.x - x, middle.y - y}, tip);
      for (const double side : {0.4, -0.4})
        sketch.line(Layer::field, tip, {tip.x - 0.6 * x - side * y, tip.y - 0.6 * y + side * x});
    }
}

// Where the plane cuts the bodies: the sides between small cells of which one is inside.
void draw_outlines(Sketch& sketch, const MapPlane& plane, std::span<const magnetics::Body> bodies) {
  const double part = plane.cell / outline_share;
  const std::size_t columns = plane.columns * outline_share;
  const std::size_t rows = plane.rows * outline_share;
  for (const magnetics::Body& body : bodies) {
    std::vector<bool> cut(rows * columns);
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < columns; ++column)
        cut[row * columns + column] =
            magnetics::is_inside(body, plane.at(plane.left + part * (static_cast<double>(column) + 0.5),
                                                plane.bottom + part * (static_cast<double>(row) + 0.5)));
    const auto inside = [&](std::size_t column, std::size_t row) {
      return column < columns && row < rows && cut[row * columns + column];
    };
    for (std::size_t row = 0; row <= rows; ++row)
      for (std::size_t column = 0; column <= columns; ++column) {
        const bool here = inside(column, row);
        const Point at{plane.left + part * static_cast<double>(column), plane.bottom + part * static_cast<double>(row)};
        if (here != (column > 0 && inside(column - 1, row))) sketch.line(Layer::outline, at, {at.x, at.y + part});
        if (here != (row > 0 && inside(column, row - 1))) sketch.line(Layer::outline, at, {at.x + part, at.y});
      }
  }
}

// 1, 2 or 5 times a power of ten, so that four to ten marks stand along the length.
double mark_spacing(double length) {
  const double most = 0.25 * length;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (most >= 5.0 * power ? 5.0 : most >= 2.0 * power ? 2.0 : 1.0);
}

void draw_axes(Sketch& sketch, const MapPlane& plane) {
  const double unit = sketch.text_height();
  const double right = plane.left + plane.cell * static_cast<double>(plane.columns);
  const double top = plane.bottom + plane.cell * static_cast<double>(plane.rows);
  for (const auto& [from, to] : {std::pair(Point{plane.left, plane.bottom}, Point{right, plane.bottom}),
                                 std::pair(Point{plane.left, top}, Point{right, top}),
                                 std::pair(Point{plane.left, plane.bottom}, Point{plane.left, top}),
                                 std::pair(Point{right, plane.bottom}, Point{right, top})})
    sketch.line(Layer::dimension, from, to);
  const double spacing = mark_spacing(std::max(right - plane.left, top - plane.bottom));
  for (int i = static_cast<int>(std::ceil(plane.left / spacing)); i * spacing <= right; ++i) {
    const double x = i * spacing;
    sketch.line(Layer::dimension, {x, plane.bottom}, {x, plane.bottom - 0.5 * unit});
    sketch.text(Layer::note, {x, plane.bottom - 2.0 * unit}, fmt::format("{:.4g}", 1e3 * x), Anchor::middle);
  }
  for (int i = static_cast<int>(std::ceil(plane.bottom / spacing)); i * spacing <= top; ++i) {
    const double y = i * spacing;
    sketch.line(Layer::dimension, {plane.left, y}, {plane.left - 0.5 * unit, y});
    sketch.text(Layer::note, {plane.left - unit, y - 0.5 * unit}, fmt::format("{:.4g}", 1e3 * y), Anchor::end);
  }
  sketch.text(Layer::note, {0.5 * (plane.left + right), plane.bottom - 4.0 * unit}, plane.right_name + " (mm)",
              Anchor::middle);
  sketch.text(Layer::note, {plane.left - 1.0 * unit, top + unit}, plane.up_name + " (mm)", Anchor::end);
}

void draw_legend(Sketch& sketch, const MapPlane& plane, const Scale& scale) {
  const double unit = sketch.text_height();
  const double right = plane.left + plane.cell * static_cast<double>(plane.columns);
  const double height = plane.cell * static_cast<double>(plane.rows);
  const double low = right + 2.0 * unit;
  for (int i = 0; i < shades; ++i) {
    const double bottom = plane.bottom + height * i / shades;
    sketch.fill(colour_of(i), {{{low, bottom}, {low + 2.0 * unit, bottom + height / shades}}});
  }
  constexpr int step = 4;
  for (int i = 0; i <= shades; i += step)
    sketch.text(Layer::note, {low + 2.5 * unit, plane.bottom + height * i / shades - 0.5 * unit},
                fmt::format("{:.4g}", units::from_si(scale.value(i), "B_mT")));
  sketch.text(Layer::note, {low, plane.bottom + height + unit}, "|B| (mT)");
}

}  // namespace

std::vector<Eigen::Vector3d> MapPlane::points() const {
  std::vector<Eigen::Vector3d> out;
  out.reserve(rows * columns);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      out.push_back(
          at(left + cell * (static_cast<double>(column) + 0.5), bottom + cell * (static_cast<double>(row) + 0.5)));
  return out;
}

std::string field_map_svg(const MapPlane& plane, std::span<const Eigen::Vector3d> flux_density,
                          std::span<const magnetics::Body> bodies, const std::string& title) {
  if (flux_density.size() != plane.rows * plane.columns)
    throw std::invalid_argument(fmt::format("flux_density must have a value for each of the {} cells; got {}",
                                            plane.rows * plane.columns, flux_density.size()));
  const double scale = std::min(map_width / (plane.cell * static_cast<double>(plane.columns)),
                                map_height / (plane.cell * static_cast<double>(plane.rows)));
  Sketch sketch(letter / scale);
  const Scale shade = scale_of(flux_density);
  draw_cells(sketch, plane, flux_density, shade);
  draw_arrows(sketch, plane, flux_density);
  draw_outlines(sketch, plane, bodies);
  draw_axes(sketch, plane);
  draw_legend(sketch, plane, shade);
  const std::string description = fmt::format(
      "Flux density in the plane of {} and {}: colour by magnitude, up to {:.4g} mT, arrows along the field.",
      plane.right_name, plane.up_name, units::from_si(shade.largest, "B_mT"));
  return svg_of(sketch, scale, {.title = title, .description = description});
}

}  // namespace coilwright::exports
