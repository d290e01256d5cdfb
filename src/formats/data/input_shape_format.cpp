#include "formats/data/input_shape_format.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "coilwright/formats/simulation/commanded_input_file.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/experiment_rules.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement::experiment;
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

// Keys of a shape's levels carry the unit of the drive.
class ShapeReader {
 public:
  ShapeReader(ObjectReader& in, Drive drive) : in_(in), unit_(unit_of(drive)) {}
  [[nodiscard]] double level(std::string_view name) {
    return in_.quantity(fmt::format("{}_{}", name, unit_), level_rule);
  }
  [[nodiscard]] double level_or_zero(std::string_view name) {
    return in_.quantity_or(fmt::format("{}_{}", name, unit_), 0.0, level_rule);
  }
  [[nodiscard]] double time(std::string_view key) { return in_.quantity(key, time_rule); }
  [[nodiscard]] double frequency(std::string_view key) { return in_.quantity(key, frequency_rule); }
  [[nodiscard]] ObjectReader& in() { return in_; }

 private:
  ObjectReader& in_;
  std::string_view unit_;
};

StepShape read_step(ShapeReader in) {
  return {.before = in.level_or_zero("before"), .after = in.level("after"), .at = in.time("at_s")};
}

StepShape read_release(ShapeReader in) {
  return {.before = in.level("level"), .after = 0.0, .at = in.time("at_s")};
}

SineShape read_sine(ShapeReader in) {
  return {.amplitude = in.level("amplitude"),
          .offset = in.level_or_zero("offset"),
          .frequency = in.frequency("frequency_Hz")};
}

ChirpShape read_chirp(ShapeReader in) {
  return {.amplitude = in.level("amplitude"),
          .offset = in.level_or_zero("offset"),
          .from = in.frequency("from_Hz"),
          .to = in.frequency("to_Hz")};
}

HoldShape read_hold(ShapeReader in) {
  HoldShape hold{.level = in.level("level"), .from = in.time("from_s"), .until = in.time("until_s")};
  if (hold.until <= hold.from) throw in.in().at("until_s").error(fmt::format("must exceed from_s ({})", hold.from));
  return hold;
}

PulseShape read_pulses(ShapeReader in) {
  return {.low = in.level_or_zero("low"),
          .high = in.level("high"),
          .period = in.in().quantity("period_s", duration_rule),
          .duty = in.in().number_or("duty", 0.5, Rule::above(0.0).and_also(Rule::below(1.0)))};
}

TableShape read_table(const Node& node, Drive drive) {
  simulation::CommandedInput command = read_commanded_input(node.path());
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

// A level under its name with the unit of the drive: "after_A".
class ShapeWriter {
 public:
  explicit ShapeWriter(Drive drive) : unit_(unit_of(drive)) {}

  Json operator()(const StepShape& step) const {
    return one("step", {level("before", step.before), level("after", step.after), {"at_s", step.at}});
  }
  Json operator()(const HoldShape& hold) const {
    return one("hold", {level("level", hold.level), {"from_s", hold.from}, {"until_s", hold.until}});
  }
  Json operator()(const SineShape& sine) const {
    return one("sine",
               {level("amplitude", sine.amplitude), level("offset", sine.offset), {"frequency_Hz", sine.frequency}});
  }
  Json operator()(const ChirpShape& chirp) const {
    return one("chirp", {level("amplitude", chirp.amplitude),
                         level("offset", chirp.offset),
                         {"from_Hz", chirp.from},
                         {"to_Hz", chirp.to}});
  }
  Json operator()(const PulseShape& pulse) const {
    return one("pulses",
               {level("low", pulse.low), level("high", pulse.high), {"period_s", pulse.period}, {"duty", pulse.duty}});
  }
  Json operator()(const TableShape& table) const {
    Json times = Json::array();
    for (const double time : table.times) times.add(time - table.times.front());
    Json levels = Json::array();
    for (const std::vector<double>& row : table.rows) {
      Json several = Json::array();
      for (const double value : row) several.add(in_unit(value));
      levels.add(row.size() == 1 ? Json(in_unit(row[0])) : std::move(several));
    }
    return one("levels", {{"at_s", std::move(times)}, {fmt::format("level_{}", unit_), std::move(levels)}});
  }

 private:
  [[nodiscard]] double in_unit(double value) const { return units::from_memory(value, fmt::format("level_{}", unit_)); }
  [[nodiscard]] Json::Member level(std::string_view name, double value) const {
    return {fmt::format("{}_{}", name, unit_), in_unit(value)};
  }
  static Json one(const char* shape, std::vector<Json::Member> members) {
    return Json::object({{shape, Json::object(std::move(members))}});
  }

  std::string_view unit_;
};

}  // namespace

InputShape read_input_shape(const Node& node, Drive drive) {
  return read_object(node, [drive](ObjectReader& in) -> InputShape {
    const std::string name = in.one_of({"step", "sine", "chirp", "release", "hold", "pulses", "levels", "file"});
    const Node shape = in.at(name);
    if (name == "file") return read_table(shape, drive);
    return read_object(shape, [&](ObjectReader& keys) -> InputShape {
      const ShapeReader levels(keys, drive);
      if (name == "step") return read_step(levels);
      if (name == "sine") return read_sine(levels);
      if (name == "chirp") return read_chirp(levels);
      if (name == "release") return read_release(levels);
      if (name == "hold") return read_hold(levels);
      if (name == "levels") return read_levels(keys, drive);
      return read_pulses(levels);
    });
  });
}

Json input_shape_json(const InputShape& shape, Drive drive) {
  return std::visit(ShapeWriter(drive), shape);
}

}  // namespace coilwright::formats
