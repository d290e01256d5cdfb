#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/model/commands.hpp"
#include "cli/model/placed_bodies.hpp"
#include "cli/model/task_options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/exports/field_map.hpp"
#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/magnetics/field_places.hpp"
#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using exports::MapPlane;
using formats::PairFile;
using magnetics::Body;
using magnetics::FieldPlaces;
using magnetics::FieldSample;
using text::InputError;
using text::Json;
using text::Rule;
using units::from_si;
using units::to_memory;

constexpr double most_cells = 1000.0;  // along a side of a map

struct FieldOptions {
  std::string pair;
  int pose = 1;
  std::vector<double> at;         // mm, three for each point
  std::string points;             // CSV
  std::string plane;              // "xz"
  std::optional<double> through;  // mm
  std::vector<double> window;     // mm: left, right, bottom, top
  int cells = 80;
  std::string out, svg;
  bool gradient{false};
  bool json{false};
  bool force{false};
};

/// What is asked, and where: points, or the cells of a plane.
struct Question {
  std::vector<Body> bodies;
  std::optional<magnetics::Plate> plate;
  std::optional<MapPlane> plane;
  std::vector<Eigen::Vector3d> points;
};

std::vector<Eigen::Vector3d> points_at(const std::vector<double>& numbers) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    points.emplace_back(to_memory(numbers[i], "x_mm"), to_memory(numbers[i + 1], "y_mm"),
                        to_memory(numbers[i + 2], "z_mm"));
  return points;
}

std::vector<Eigen::Vector3d> points_in(const std::string& file) {
  const text::CsvTable table = text::read_csv(file, [](text::CsvHeader& header) {
    for (const char* name : {"x_mm", "y_mm", "z_mm"}) header.require(name);
  });
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < table.rows(); ++i)
    points.emplace_back(table.column("x")[i], table.column("y")[i], table.column("z")[i]);
  return points;
}

/// A direction of the map: its unit vector, and from where to where it goes.
struct MapSide {
  Eigen::Vector3d along;
  double low;
  double high;
};

// Half of its longest body beyond all bodies, unless a window is given.
MapSide side_of(const std::vector<Body>& bodies, int axis, const double* window) {
  MapSide side{.along = Eigen::Vector3d::Unit(axis), .low = 1e300, .high = -1e300};
  double longest = 0.0;
  for (const Body& body : bodies) {
    const Eigen::Matrix3d to_own = magnetics::rotation_of(body.pose).transpose();
    const double half = magnetics::half_extent(magnetics::shape_of(body), to_own * side.along);
    side.low = std::min(side.low, body.pose.position[axis] - half);
    side.high = std::max(side.high, body.pose.position[axis] + half);
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, magnetics::half_extent(magnetics::shape_of(body), to_own * Eigen::Vector3d::Unit(i)));
  }
  side.low -= longest;
  side.high += longest;
  if (window != nullptr) {
    side.low = to_memory(window[0], "window_mm");
    side.high = to_memory(window[1], "window_mm");
  }
  return side;
}

MapPlane plane_of(const FieldOptions& options, const std::vector<Body>& bodies) {
  const auto axis_of = [](char name) { return static_cast<int>(name - 'x'); };
  const int first = axis_of(options.plane[0]);
  const int second = axis_of(options.plane[1]);
  const int normal = 3 - first - second;
  const bool own = !options.window.empty();
  if (own && !(options.window[0] < options.window[1] && options.window[2] < options.window[3]))
    throw InputError(
        {.file = "--window", .rule = "must be LEFT RIGHT BOTTOM TOP with LEFT below RIGHT and BOTTOM below TOP"});
  const MapSide right = side_of(bodies, first, own ? options.window.data() : nullptr);
  const MapSide up = side_of(bodies, second, own ? options.window.data() + 2 : nullptr);
  const double longer = std::max(right.high - right.low, up.high - up.low);
  const double cell = longer / options.cells;
  const auto count = [&](const MapSide& side) {
    return static_cast<std::size_t>(std::max(1.0, std::round((side.high - side.low) / cell)));
  };
  // Through the middle of the first body, where a person looks first, unless told otherwise.
  const double level = options.through ? to_memory(*options.through, "through_mm") : bodies[0].pose.position[normal];
  return {.origin = level * Eigen::Vector3d::Unit(normal),
          .right = right.along,
          .up = up.along,
          .right_name = options.plane.substr(0, 1),
          .up_name = options.plane.substr(1, 1),
          .left = right.low,
          .bottom = up.low,
          .cell = cell,
          .columns = count(right),
          .rows = count(up)};
}

Question field_question(const FieldOptions& options, const PairFile& file) {
  if (static_cast<std::size_t>(options.pose) > file.poses.size())
    throw InputError(
        {.file = "--pose",
         .rule = fmt::format("must be at most {}, which is how many poses {} has", file.poses.size(), options.pair),
         .value = fmt::format("{}", options.pose)});
  Question question{.bodies = file.bodies_at(file.poses[static_cast<std::size_t>(options.pose) - 1]),
                    .plate = file.plate,
                    .plane = {},
                    .points = {}};
  if (!options.plane.empty()) {
    question.plane = plane_of(options, question.bodies);
    question.points = question.plane->points();
  } else {
    question.points = options.points.empty() ? points_at(options.at) : points_in(options.points);
  }
  return question;
}

constexpr std::array gradient_names{"dBx_dx_T_m", "dBx_dy_T_m", "dBx_dz_T_m", "dBy_dx_T_m", "dBy_dy_T_m",
                                    "dBy_dz_T_m", "dBz_dx_T_m", "dBz_dy_T_m", "dBz_dz_T_m"};

std::vector<std::string> field_columns(bool gradient) {
  std::vector<std::string> out{"x_mm", "y_mm", "z_mm", "Bx_mT", "By_mT", "Bz_mT", "B_mT"};
  if (gradient) out.insert(out.end(), gradient_names.begin(), gradient_names.end());
  out.emplace_back("body");
  return out;
}

// Whether there is a B to tell of a point: in iron it is not known, on an edge of a magnet infinite.
bool is_told(const FieldPlaces& answer, std::size_t i) {
  return !answer.in_iron[i] && answer.on_edge[i] == 0;
}

// The numbers of a point in the order of the columns, without the last one; its place alone where B is not told.
std::vector<double> numbers_of(const Question& question, const FieldPlaces& answer, std::size_t i, bool gradient) {
  const auto& point = question.points[i];
  std::vector<double> out{from_si(point.x(), "x_mm"), from_si(point.y(), "y_mm"), from_si(point.z(), "z_mm")};
  if (!is_told(answer, i)) return out;
  const FieldSample& sample = answer.samples[i];
  for (const double each :
       {sample.flux_density.x(), sample.flux_density.y(), sample.flux_density.z(), sample.flux_density.norm()})
    out.push_back(from_si(each, "B_mT"));
  if (gradient)
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) out.push_back(sample.gradient(row, column));
  return out;
}

void write_csv(std::ostream& stream, const Question& question, const FieldPlaces& answer, bool gradient) {
  text::CsvWriter csv(stream, field_columns(gradient));
  for (std::size_t i = 0; i < question.points.size(); ++i) {
    const std::vector<double> numbers = numbers_of(question, answer, i, gradient);
    std::vector<text::CsvCell> cells(numbers.begin(), numbers.end());
    cells.resize(csv.columns().size() - 1);
    cells.emplace_back(answer.within[i]);
    csv.row(cells);
  }
}

Json as_json(const Question& question, const FieldPlaces& answer, const PairFile& file, bool gradient) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < question.points.size(); ++i) {
    const std::vector<double> n = numbers_of(question, answer, i, gradient);
    Json row = Json::object({{"position_mm", Json::numbers(std::array{n[0], n[1], n[2]})}});
    if (answer.in_iron[i]) {
      row.set("flux_density_mT", Json()).set("inside", "plate");
    } else if (answer.on_edge[i] > 0) {
      row.set("flux_density_mT", Json()).set("inside", Json()).set("on_edge_of", file.names[answer.on_edge[i] - 1]);
    } else {
      row.set("flux_density_mT", Json::numbers(std::array{n[3], n[4], n[5]})).set("magnitude_mT", n[6]);
      if (gradient) {
        Json matrix = Json::array();
        for (std::size_t k = 7; k < n.size(); k += 3) matrix.add(Json::numbers(std::array{n[k], n[k + 1], n[k + 2]}));
        row.set("gradient_T_m", std::move(matrix));
      }
      row.set("inside", answer.within[i] == 0 ? Json() : Json(file.names[answer.within[i] - 1]));
    }
    rows.add(std::move(row));
  }
  return Json::object({{"points", std::move(rows)}});
}

std::string as_table(const Question& question, const FieldPlaces& answer, const PairFile& file, bool gradient) {
  std::string text;
  const std::vector<std::string> columns = field_columns(gradient);
  for (std::size_t k = 0; k + 1 < columns.size(); ++k) text += fmt::format(" {:>{}}", columns[k], k < 3 ? 10 : 16);
  text += "  in\n";
  for (std::size_t i = 0; i < question.points.size(); ++i) {
    const std::vector<double> numbers = numbers_of(question, answer, i, gradient);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      text += k < 3 ? fmt::format(" {:>10.6g}", numbers[k]) : fmt::format(" {:>16.9g}", numbers[k]);
    if (answer.in_iron[i]) text += "  plate";
    if (!answer.in_iron[i] && answer.on_edge[i] > 0)
      text += fmt::format("  infinite, on an edge of {}", file.names[answer.on_edge[i] - 1]);
    if (is_told(answer, i) && answer.within[i] > 0) text += "  " + file.names[answer.within[i] - 1];
    text += '\n';
  }
  return text;
}

std::string map_of(const Question& question, const FieldPlaces& answer, const std::string& pair) {
  std::vector<Eigen::Vector3d> flux;
  for (std::size_t i = 0; i < answer.samples.size(); ++i)
    flux.push_back(is_told(answer, i) ? answer.samples[i].flux_density
                                      : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  return exports::field_map_svg(*question.plane, flux, question.bodies, "Flux density of " + pair);
}

void require_one_question(const FieldOptions& options) {
  const int asked = static_cast<int>(!options.at.empty()) + static_cast<int>(!options.points.empty()) +
                    static_cast<int>(!options.plane.empty());
  if (asked != 1) throw CLI::ValidationError("one of --at, --points and --map says where the field is wanted");
  // CLI11 adds up the numbers of all --at, and takes two for a point.
  if (options.at.size() % 3 != 0) throw CLI::ValidationError("--at", "must be three numbers each time: X Y Z in mm");
  if (options.plane.empty()) {
    for (const auto& [given, name] :
         {std::pair(!options.svg.empty(), "--svg"), std::pair(options.through.has_value(), "--through"),
          std::pair(!options.window.empty(), "--window")})
      if (given) throw CLI::ValidationError(name, "is of a map: it needs --map");
  } else if (options.out.empty() && options.svg.empty()) {
    throw CLI::ValidationError("--map", "needs --out FILE.csv, --svg FILE.svg or both to write to");
  }
}

void run_field(const FieldOptions& options) {
  require_one_question(options);
  keep_inputs({options.pair, options.points}, {options.out, options.svg});
  const PairFile file = formats::read_pair(options.pair);
  const Question question = field_question(options, file);
  std::optional<text::OutputFile> table;
  std::optional<text::OutputFile> picture;
  if (!options.out.empty()) table.emplace(options.out);
  if (!options.svg.empty()) picture.emplace(options.svg);
  report::PairRemarks remarks(file);
  remarks.add(question.bodies, static_cast<std::size_t>(options.pose));
  tell(remarks, options.pair);
  const FieldPlaces found = magnetics::field_places(question.bodies, question.plate, question.points, options.gradient);
  if (table) write_csv(table->stream(), question, found, options.gradient);
  if (picture) picture->stream() << map_of(question, found, options.pair);
  constexpr std::string_view picture_mark = ">";
  if (table) keep_other_kind(*table, table_mark, options.force);
  if (picture) keep_other_kind(*picture, picture_mark, options.force);
  if (picture) picture->withdraw();
  if (table) table->commit();
  if (picture) picture->commit();
  if (table || picture) return;
  std::cout << (options.json ? as_json(question, found, file, options.gradient).text()
                             : as_table(question, found, file, options.gradient));
}

}  // namespace

void add_field_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<FieldOptions>();
  CLI::App* command = add_command(app, "field");
  const Rule millimetres = Rule::between(-1e6, 1e6);
  command->add_option("PAIR.json", options->pair, "File with the bodies, as for force")->required();
  command->add_option("--at", options->at, "A point, X Y Z in mm; may be given again")
      ->expected(3)
      ->type_name("X Y Z")
      ->check(number_rule(millimetres))
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--points", options->points, "CSV file with columns x_mm, y_mm and z_mm")->type_name("FILE.csv");
  command->add_option("--map", options->plane, "A map of a plane: of x and z, x and y, or y and z")
      ->type_name("PLANE")
      ->check(CLI::IsMember({"xz", "xy", "yz"}));
  command
      ->add_option("--through", options->through,
                   "Where the plane of the map lies, mm (default: the first body's middle)")
      ->type_name("MM")
      ->check(number_rule(millimetres));
  command
      ->add_option("--window", options->window, "What the map shows, mm (default: all bodies and what is round them)")
      ->expected(4)
      ->type_name("LEFT RIGHT BOTTOM TOP")
      ->check(number_rule(millimetres));
  command->add_option("--cells", options->cells, with_default("Cells along the longer side of the map", options->cells))
      ->type_name("N")
      ->transform(whole_number_rule(Rule::between(2.0, most_cells)));
  command->add_option("--pose", options->pose, with_default("Which of the file's poses", options->pose))
      ->type_name("N")
      ->transform(whole_number_rule(Rule::between(1.0, 1e6)));
  add_flag(*command, "--gradient", options->gradient, "Also the nine slopes of B, dBx_dy_T_m and so on, in T/m");
  command->add_option("--out", options->out, "Write the points as CSV instead")->type_name("FILE.csv");
  command->add_option("--svg", options->svg, "Draw the map: colour by magnitude, arrows along the field")
      ->type_name("FILE.svg");
  add_json_option(*command, options->json);
  add_force_option(*command, options->force);
  command->footer(
      "Positions and B are in the axes of the file (of a pair: of the first body). 1 mT is 10 gauss, 1 T/m is 1 "
      "mT/mm.\n"
      "On the surface of a body B is that just outside; in the copper or in a magnet it is that there, and the last\n"
      "column says in which. Beside a plate B is that in front of it. On an edge of a magnet it is\n"
      "infinite, and no number is printed.\n\n"
      "Examples:\n"
      "  coilwright field pair.json --at 0 0 20\n"
      "  coilwright field pair.json --map xz --out map.csv --svg map.svg");
  command->callback([options] { run_field(*options); });
}

}  // namespace coilwright::cli
