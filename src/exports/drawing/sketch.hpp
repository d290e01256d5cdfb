#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/exports/body_plan.hpp"

namespace coilwright::exports {

/// A place on the sheet, m in the world of the part that is drawn: x to the right, y up.
struct Point {
  double x{};
  double y{};
};

/// What a line belongs to: layer of a DXF file, style of an SVG.
enum class Layer { body, winding, magnet, slit, axis, dimension, note, field, outline };

struct SketchLine {
  Layer layer{};
  Point from;
  Point to;
};

struct SketchCircle {
  Layer layer{};
  Point centre;
  double radius{};
};

/// With its sides along x and y.
struct SketchRectangle {
  Layer layer{};
  Point low;
  Point high;
};

enum class Anchor { start, middle, end };

struct SketchText {
  Layer layer{};
  Point at;         ///< start, middle or end of the base line
  double height{};  ///< of a capital letter, m
  Anchor anchor = Anchor::start;
  bool upright{};  ///< reads from below upwards
  std::string text;
};

/// Smallest box with sides along x and y.
struct Bounds {
  Point low;
  Point high;
};

/// Areas of one colour behind the lines; in an SVG alone.
struct SketchFill {
  std::string colour;  ///< "#1c2733"
  std::vector<Bounds> areas;
};

/// From one place to another one, m.
struct Span {
  double from{};
  double to{};
};

/// A drawing by its parts, which an SVG and a DXF writer write alike. Lengths in m, true to the part; only letters and
/// arrows have the size that they need on paper.
class Sketch {
 public:
  /// `text_height`: of the letters of dimensions and notes, m in the world of the part; > 0.
  explicit Sketch(double text_height) : text_height_(text_height) {}

  void line(Layer layer, Point from, Point to) { lines_.push_back({layer, from, to}); }
  void circle(Layer layer, Point centre, double radius) { circles_.push_back({layer, centre, radius}); }
  void rectangle(Layer layer, Point low, Point high) { rectangles_.push_back({layer, low, high}); }
  void text(Layer layer, Point at, std::string text, Anchor anchor = Anchor::start, double times_height = 1.0);

  void fill(std::string colour, std::vector<Bounds> areas) { fills_.push_back({std::move(colour), std::move(areas)}); }

  /// What is between two places as a number in mm, on a line at height `row`, with lines out to it from `edge`.
  void horizontal_dimension(double x1, double x2, double edge, double row);
  /// The same for each of `spans`, all on one line. Numbers that are too wide for their place stand further out, on as
  /// many levels as it takes to keep them apart, with a line to them. Returns the height at which the outermost one
  /// ends.
  double horizontal_dimensions(std::span<const Span> spans, double edge, double row);
  /// The same for heights, on a line at x = `row`; what is too wide stands a line further out.
  void vertical_dimension(double y1, double y2, double edge, double row);
  /// The diameter of a circle in mm, at x = `row` to the right of it, with a line to it.
  void diameter(Point centre, double radius, double row);

  [[nodiscard]] double text_height() const noexcept { return text_height_; }
  [[nodiscard]] const std::vector<SketchFill>& fills() const noexcept { return fills_; }
  [[nodiscard]] const std::vector<SketchRectangle>& rectangles() const noexcept { return rectangles_; }
  [[nodiscard]] const std::vector<SketchCircle>& circles() const noexcept { return circles_; }
  [[nodiscard]] const std::vector<SketchLine>& lines() const noexcept { return lines_; }
  [[nodiscard]] const std::vector<SketchText>& texts() const noexcept { return texts_; }
  /// Of everything, texts by an estimate of their width.
  [[nodiscard]] Bounds bounds() const;

 private:
  void tick(Point at);

  double text_height_;
  std::vector<SketchFill> fills_;
  std::vector<SketchRectangle> rectangles_;
  std::vector<SketchCircle> circles_;
  std::vector<SketchLine> lines_;
  std::vector<SketchText> texts_;
};

/// "12.4", a length of m as mm to a hundredth at most.
[[nodiscard]] std::string length_text(double length);

/// Width of a text, m: an estimate.
[[nodiscard]] double width_of(const SketchText& text);

/// What an SVG says about itself.
struct SvgText {
  std::string_view title;
  std::string_view description;
};

/// A complete SVG of a sketch, `scale` times as large as the part where it is printed as it is. Its user unit is a
/// millimetre of the part.
[[nodiscard]] std::string svg_of(const Sketch& sketch, double scale, const SvgText& text);

/// A complete DXF file of a sketch, in the ASCII form of release 12, which every program that knows DXF reads: lines,
/// circles and texts on a layer each for body, windings, magnets, slits, axes, dimensions and notes, at the size of the
/// part in mm. Letters beyond ASCII, which release 12 does not have, are question marks, but for the sign of a
/// diameter.
[[nodiscard]] std::string dxf_of(const Sketch& sketch);

/// The actuator straight: longitudinal section, and cross-sections through its first coil and its first magnet, all
/// with dimensions in mm. The rear end of the underside is at (0, 0). `text_height`: m in the world of the actuator.
[[nodiscard]] Sketch sketch_of(const BodyPlan& plan, double text_height);

/// A sketch at the scale at which it is printed.
struct ScaledSketch {
  Sketch sketch;
  double scale{};  ///< paper over part
};

/// The drawing of a body with its title block on a sheet of `width` by `height`, m, at the largest scale of ISO 5455
/// that fits, with letters of 2.5 mm. The smallest of its scales (1 to 100) where none fits.
[[nodiscard]] ScaledSketch drawing_on(const DesignSubject& subject, const BodyPlan& plan, double width, double height);

/// One field of a title block.
struct TitleField {
  std::string_view label;
  std::string value;  ///< empty: to be filled in by hand
};

/// The fields of the title block of a design's drawing at a scale, "2:1"; empty where it has the size of the part. Its
/// number follows from the design's numbers: another number, another drawing. Tolerances are those that a spread takes
/// as usual.
[[nodiscard]] std::vector<TitleField> title_block(const DesignSubject& subject, std::string scale);

/// The sketch with a title block below it or, `beside` its lowest views, to the right of these.
[[nodiscard]] Sketch titled(Sketch sketch, const std::vector<TitleField>& fields, bool beside);

/// "2:1", "1:5".
[[nodiscard]] std::string scale_text(double scale);

}  // namespace coilwright::exports
