#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/page/page.hpp"

namespace coilwright::page {

/// The beginning of a specification of Vega-Lite: a view as wide as its place and `height` pixels high, which stays
/// within its size by `autosize` ("fit", "fit-x"). If `resizes`, it is laid out again when its data change.
[[nodiscard]] text::Json vega_lite(const std::string& description, std::size_t height, bool resizes,
                                   const char* autosize = "fit");

/// The drawing style of a series.
enum class Mark {
  line,    ///< straight lines between its points, in their order
  steps,   ///< each value holds until the next point
  points,  ///< a symbol a point, of a shape of its own
  dots,    ///< a small symbol for each point: measured values
  faint,   ///< small, pale symbols, for large numbers of points
  level    ///< a line across at the one value of y; x is empty
};

/// Numbers with a common name.
struct Series {
  std::string name;  ///< with its unit, as the legend has it; unique in its chart
  std::vector<double> x{};
  std::vector<double> y{};  ///< one for each x; finite
  Mark mark = Mark::line;
};

/// Scale of an axis.
enum class AxisScale { linear, logarithmic };

/// Curves and points over one axis.
struct Chart {
  std::string id;
  std::string title;
  std::string description;
  std::string x_title;  ///< with its unit
  std::string y_title;  ///< with its unit
  std::vector<Series> series{};
  /// Names whose order assigns the colours, for figures that share series: each series has the same colour in all of
  /// them. Empty: the order of the series.
  std::vector<std::string> colour_order{};
  AxisScale x_scale = AxisScale::linear;  ///< logarithmic: every x > 0
  AxisScale y_scale = AxisScale::linear;  ///< logarithmic: every y > 0
};

/// The chart as Vega-Lite, and its numbers as a table. Every number of the specification is one of the series,
/// unchanged. A table of more than 400 rows shows an even selection of them and states that.
[[nodiscard]] Figure figure_of(const Chart& chart);

using report::Bar;
using report::BarChart;
using report::short_number;

/// The bars as Vega-Lite, and as a table.
[[nodiscard]] Figure figure_of(const BarChart& chart);

}  // namespace coilwright::page
