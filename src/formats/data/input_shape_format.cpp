#include "formats/data/experiment_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "coilwright/formats/simulation/commanded_input_file.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/named_table.hpp"
#include "formats/simulation/plausible_ranges.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement::planning;
using measurement::data::Drive;

// Bounds far beyond any rig, and low enough that a wrong file is refused before it is simulated.
constexpr std::size_t most_rows = 1'000'000;

std::string_view unit_of(Drive drive) {
  switch (drive) {
    case Drive::current:
      return "A";
    case Drive::voltage:
      return "V";
    case Drive::torque:
      break;
  }
  return "Nmm";
}

// A number of a shape: its reader and its writer are these tables.
template <class Shape>
struct ShapeField {
  std::string_view name;  // the key; of a level without the unit of the drive, which that ends in
  double Shape::*member{};
  std::optional<double> otherwise{};  // where the key may be absent
  std::optional<Rule> rule{};         // nothing: a level
};

constexpr auto step_fields = std::to_array<ShapeField<StepShape>>(
    {{"before", &StepShape::before, 0.0}, {"after", &StepShape::after}, {"at_s", &StepShape::at, {}, time_rule}});
constexpr auto release_fields =
    std::to_array<ShapeField<StepShape>>({{"level", &StepShape::before}, {"at_s", &StepShape::at, {}, time_rule}});
constexpr auto sine_fields =
    std::to_array<ShapeField<SineShape>>({{"amplitude", &SineShape::amplitude},
                                          {"offset", &SineShape::offset, 0.0},
                                          {"frequency_Hz", &SineShape::frequency, {}, frequency_rule}});
constexpr auto chirp_fields = std::to_array<ShapeField<ChirpShape>>({{"amplitude", &ChirpShape::amplitude},
                                                                     {"offset", &ChirpShape::offset, 0.0},
                                                                     {"from_Hz", &ChirpShape::from, {}, frequency_rule},
                                                                     {"to_Hz", &ChirpShape::to, {}, frequency_rule}});
constexpr auto hold_fields = std::to_array<ShapeField<HoldShape>>({{"level", &HoldShape::level},
                                                                   {"from_s", &HoldShape::from, {}, time_rule},
                                                                   {"until_s", &HoldShape::until, {}, time_rule}});
constexpr auto pulse_fields = std::to_array<ShapeField<PulseShape>>(
    {{"low", &PulseShape::low, 0.0},
     {"high", &PulseShape::high},
     {"period_s", &PulseShape::period, {}, duration_rule},
     {"duty", &PulseShape::duty, 0.5, Rule::above(0.0).and_also(Rule::below(1.0))}});

template <class Shape>
std::string key_of(const ShapeField<Shape>& field, Drive drive) {
  return field.rule ? std::string(field.name) : fmt::format("{}_{}", field.name, unit_of(drive));
}

template <class Shape, std::size_t Count>
Shape read_shape(ObjectReader& in, Drive drive, const std::array<ShapeField<Shape>, Count>& fields) {
  Shape shape;
  for (const ShapeField<Shape>& each : fields) {
    const std::string key = key_of(each, drive);
    const auto node = each.otherwise ? in.find(key) : in.at(key);
    const Rule& rule = each.rule ? *each.rule : level_rule;
    shape.*each.member = !node ? *each.otherwise : units::split_unit(key) ? node->quantity(rule) : node->number(rule);
  }
  return shape;
}

HoldShape read_hold(ObjectReader& in, Drive drive) {
  const HoldShape hold = read_shape(in, drive, hold_fields);
  if (hold.until <= hold.from) throw in.at("until_s").error(fmt::format("must exceed from_s ({})", hold.from));
  return hold;
}

TableShape read_table(const Node& node, Drive drive) {
  simulation::CommandedInput command = read_named_table(node, read_commanded_input);
  if (command.drive != drive) throw node.error("must have an input column of this run's drive");
  return {.times = std::move(command.times), .rows = std::move(command.rows)};
}

// Levels for all coils, or of each coil or joint, and from when on they are held.
TableShape read_levels(ObjectReader& in, Drive drive) {
  TableShape table{.times = in.quantities("at_s", Length::from_to(1, most_rows), time_rule), .rows = {}};
  const std::string key = fmt::format("level_{}", unit_of(drive));
  const Node levels = in.at(key);
  for (const Node& element : levels.elements(Length::exactly(table.times.size()))) {
    const bool one = element.kind() != Node::Kind::array;
    std::vector<double> row =
        one ? std::vector{element.quantity(level_rule)} : element.quantities(Length::from_to(1, 100), level_rule);
    if (!table.rows.empty() && row.size() != table.rows.front().size())
      throw element.error("must have as many levels as the first one");
    table.rows.push_back(std::move(row));
  }
  if (table.times.front() != 0.0) throw in.at("at_s").error_without_value("must begin at 0");
  for (std::size_t i = 1; i < table.times.size(); ++i)
    if (table.times[i] <= table.times[i - 1]) throw in.at("at_s").error_without_value("must increase");
  return table;
}

template <class Shape, std::size_t Count>
Json shape_json(const char* name, const Shape& shape, Drive drive, const std::array<ShapeField<Shape>, Count>& fields) {
  Json numbers = Json::object();
  for (const ShapeField<Shape>& each : fields) numbers.set(Json::quantity(key_of(each, drive), shape.*each.member));
  return Json::object({{name, std::move(numbers)}});
}

Json levels_json(const TableShape& table, Drive drive) {
  const std::string key = fmt::format("level_{}", unit_of(drive));
  Json times = Json::list(table.times, [&](double time) { return time - table.times.front(); });
  Json levels = Json::list(table.rows, [&](const std::vector<double>& row) {
    return row.size() == 1 ? Json::quantity(key, row[0]).second : Json::quantities(key, row).second;
  });
  return Json::object({{"levels", Json::object({{"at_s", std::move(times)}, {key, std::move(levels)}})}});
}

// Of each shape, the key and the numbers under it.
struct ShapeWriter {
  Drive drive;
  Json operator()(const StepShape& step) const { return shape_json("step", step, drive, step_fields); }
  Json operator()(const HoldShape& hold) const { return shape_json("hold", hold, drive, hold_fields); }
  Json operator()(const SineShape& sine) const { return shape_json("sine", sine, drive, sine_fields); }
  Json operator()(const ChirpShape& chirp) const { return shape_json("chirp", chirp, drive, chirp_fields); }
  Json operator()(const PulseShape& pulse) const { return shape_json("pulses", pulse, drive, pulse_fields); }
  Json operator()(const TableShape& table) const { return levels_json(table, drive); }
};

}  // namespace

InputShape read_input_shape(const Node& node, Drive drive) {
  return read_object(node, [drive](ObjectReader& in) -> InputShape {
    const std::string name = in.one_of({"step", "sine", "chirp", "release", "hold", "pulses", "levels", "file"});
    const Node shape = in.at(name);
    if (name == "file") return read_table(shape, drive);
    return read_object(shape, [&](ObjectReader& keys) -> InputShape {
      if (name == "step") return read_shape(keys, drive, step_fields);
      if (name == "sine") return read_shape(keys, drive, sine_fields);
      if (name == "chirp") return read_shape(keys, drive, chirp_fields);
      if (name == "release") return read_shape(keys, drive, release_fields);
      if (name == "hold") return read_hold(keys, drive);
      if (name == "levels") return read_levels(keys, drive);
      return read_shape(keys, drive, pulse_fields);
    });
  });
}

Json input_shape_json(const InputShape& shape, Drive drive) {
  return std::visit(ShapeWriter{drive}, shape);
}

}  // namespace coilwright::formats
