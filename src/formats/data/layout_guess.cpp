#include "coilwright/formats/data/dataset_draft.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "coilwright/text/number.hpp"
#include "coilwright/text/one_line.hpp"
#include "formats/data/seen_clock.hpp"
#include "formats/data/seen_column.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::Drive;
using measurement::data::RunKind;

class Guess {
 public:
  Guess(const CsvForm& form, const TableContent& content) : form_(form), content_(content) {
    for (std::size_t i = 0; i < form.names.size(); ++i) columns_.push_back(seen_column(form, i));
    for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i].taken = form.is_empty(i) || columns_[i].text;
    out_.kind = content.kind ? *content.kind : kind_of();
  }

  LayoutGuess finish() {
    const bool bench = out_.kind == RunKind::static_torque || out_.kind == RunKind::joint_stiffness ||
                       out_.kind == RunKind::blocked_force;
    if (!bench) find_time();
    if (!bench && !has_time_) by_preamble();
    if (content_.input && out_.kind != RunKind::joint_stiffness && out_.kind != RunKind::still) find_input();
    if (content_.measured) find_measured();
    leave_others();
    return std::move(out_);
  }

 private:
  SeenColumn* first_of(Quantity quantity) {
    // A name before a unit, and what was measured before what was commanded.
    for (const bool commanded : {false, true})
      for (const bool by_unit : {false, true})
        for (SeenColumn& each : columns_)
          if (!each.taken && each.words.quantity == quantity && each.words.by_unit == by_unit &&
              each.words.commanded == commanded)
            return &each;
    return nullptr;
  }

  [[nodiscard]] bool has(Quantity quantity) const {
    return std::ranges::any_of(columns_, [&](const SeenColumn& each) { return each.words.quantity == quantity; });
  }

  [[nodiscard]] RunKind kind_of() const {
    const bool time = has(Quantity::time) || std::ranges::any_of(columns_, &SeenColumn::stamps);
    if (has(Quantity::temperature) && time && !has(Quantity::angle)) return RunKind::temperature;
    if (has(Quantity::force) && has(Quantity::current) && !time) return RunKind::blocked_force;
    if (has(Quantity::torque) && has(Quantity::angle) && !time)
      return has(Quantity::current) ? RunKind::static_torque : RunKind::joint_stiffness;
    return RunKind::transient;
  }

  // Makes a column one of ours, whose unit is `unit` where its name has none.
  void take(SeenColumn& column, const std::string& quantity, const std::string& unit, bool certain) {
    column.taken = true;
    const bool named = !column.words.unit.empty();
    if (certain && !named && !column.words.strange_unit.empty()) {
      used_.insert(column.source);
      out_.asked.push_back(
          fmt::format("the unit \"{}\": \"columns\": {{{}: {{\"as\": \"{}_{}\", \"factor\": F}}}} with F "
                      "the {} in one of it",
                      column.words.strange_unit, shown(column), quantity, unit, unit));
      return;
    }
    const std::string name = quantity + "_" + (named ? column.words.unit : unit);
    if (!certain)
      out_.guessed.push_back(fmt::format("{} is {}: by its place or its numbers", shown(column), name));
    else if (!named && !column.stamps)
      out_.guessed.push_back(fmt::format("{} is in {}: its name says no unit", shown(column), unit));
    used_.insert(column.source);
    if (column.source != name) out_.layout.columns.push_back({.source = column.source, .name = name});
  }

  static std::string shown(const SeenColumn& column) { return in_quotes(column.source); }

  void find_time() {
    if (const auto split = split_clock(columns_)) {
      has_time_ = true;
      split->seconds->words.unit = "s";
      split->part->words.unit = split->unit;
      for (SeenColumn* each : {split->seconds, split->part}) take(*each, "time", "s", true);
      for (SeenColumn& each : columns_) each.taken = each.taken || each.words.quantity == Quantity::time;
      return;
    }
    // A clock with a name before the stamps that a terminal puts in front of each line.
    SeenColumn* time = first_of(Quantity::time);
    for (SeenColumn& each : columns_)
      if (!time && !each.taken && each.stamps) time = &each;
    // A column of rising numbers that is no count of rows.
    const bool by_name = time != nullptr;
    for (SeenColumn& each : columns_)
      if (!time && !each.taken && each.increases && !each.counts && each.words.quantity == Quantity::none) time = &each;
    if (!time) return;
    has_time_ = true;
    take_time(*time, by_name);
    // The same clock again, as of the second channel of an oscilloscope.
    for (SeenColumn& each : columns_)
      if (!each.taken && (each.values == time->values || each.words.quantity == Quantity::time)) each.taken = true;
  }

  void take_time(SeenColumn& time, bool by_name) {
    if (time.stamps || !time.words.unit.empty() || !time.words.strange_unit.empty())
      return take(time, "time", "s", by_name);
    const std::vector<std::string_view> units = clock_units(time);
    if (units.size() == 1) return take(time, "time", std::string(units.front()), by_name);
    time.taken = true;
    used_.insert(time.source);
    const auto written = [&](std::string_view unit) {
      return fmt::format(R"("columns": {{{}: "time_{}"}})", shown(time), unit);
    };
    if (!units.empty()) {
      std::vector<std::string> choices;
      for (const std::string_view unit : units) choices.push_back(written(unit));
      out_.asked.push_back(fmt::format("what {} counts: {}", shown(time), fmt::join(choices, " or ")));
      return;
    }
    out_.asked.push_back(
        fmt::format(R"(what {} counts, which goes up by ones: of pictures or rows "columns": {{{}: {{"as": "time_s", )"
                    R"("factor": F}}}} with F the seconds from one to the next, 0.0166666667 at 60 a second; or {})",
                    shown(time), shown(time), written("ms")));
  }

  void find_input() {
    if (SeenColumn* current = first_of(Quantity::current)) return input(*current, "current", "A", Drive::current, true);
    const bool bench = out_.kind != RunKind::transient;
    if (SeenColumn* voltage = bench ? nullptr : first_of(Quantity::voltage); voltage && !voltage->words.by_unit)
      return input(*voltage, "voltage", "V", Drive::voltage, true);
    if (SeenColumn* duty = bench ? nullptr : first_of(Quantity::duty)) {
      duty->taken = true;
      used_.insert(duty->source);
      out_.drive = Drive::voltage;
      out_.asked.push_back(fmt::format(
          "what {} stands for: \"columns\": {{{}: {{\"as\": \"voltage_V\", \"factor\": F}}}} with F the supply in "
          "volts "
          "over the largest number (12 V at 100: 0.12) and \"drive\": \"voltage\", or \"current_A\" and the amperes "
          "that a current loop gives over it",
          shown(*duty), shown(*duty)));
      return;
    }
    if (SeenColumn* torque = bench ? nullptr : first_of(Quantity::torque))
      return input(*torque, "torque1", "Nm", Drive::torque, true);
    // The one of two columns that is not the angle; of two without a name, the first.
    const bool angle = first_of(Quantity::angle) != nullptr;
    const auto free = std::ranges::count_if(columns_, is_free);
    for (SeenColumn& each : columns_)
      if (is_free(each) && (free + (angle ? 1 : 0) >= 2 || !content_.measured))
        return input(each, "current", "A", Drive::current, false);
    out_.asked.emplace_back(bench ? "which column is the current, in \"columns\""
                                  : "the input: a column of current or voltage in this file, or another file with one, "
                                    "named by \"input_file\"; or \"kind\": \"still\" if nothing moves in it");
  }

  static bool is_free(const SeenColumn& each) {
    return !each.taken && !each.ticks &&
           (each.words.quantity == Quantity::none || (each.words.by_unit && each.words.quantity == Quantity::voltage));
  }

  void input(SeenColumn& column, const std::string& quantity, const std::string& unit, Drive drive, bool certain) {
    out_.drive = drive;
    if (!certain) column.words.unit.clear();
    take(column, quantity, unit, certain);
  }

  void find_measured() {
    switch (out_.kind) {
      case RunKind::static_torque:
      case RunKind::joint_stiffness:
        if (SeenColumn* angle = first_of(Quantity::angle)) take(*angle, "angle", "deg", true);
        return measured(Quantity::torque, "torque", "Nmm");
      case RunKind::blocked_force:
        return measured(Quantity::force, "force", "N");
      case RunKind::temperature:
        return measured(Quantity::temperature, "temperature", "degC");
      case RunKind::transient:
      case RunKind::still:
        find_angles();
    }
  }

  void measured(Quantity quantity, const std::string& name, const std::string& unit) {
    SeenColumn* column = first_of(quantity);
    if (column) return take(*column, name, unit, true);
    out_.asked.push_back(fmt::format("which column is the {}, in \"columns\"", name));
  }

  void find_angles() {
    std::vector<SeenColumn*> angles;
    for (SeenColumn& each : columns_)
      if (!each.taken && each.words.quantity == Quantity::angle) angles.push_back(&each);
    std::stable_partition(angles.begin(), angles.end(), [](const SeenColumn* each) { return !each->words.commanded; });
    // Joints are numbered from 1.
    bool joints = !angles.empty();
    for (std::size_t i = 0; i < angles.size(); ++i)
      joints = joints && angles[i]->words.number == static_cast<int>(i) + 1;
    if (joints) {
      for (std::size_t i = 0; i < angles.size(); ++i) take(*angles[i], fmt::format("theta{}", i + 1), "deg", true);
      return;
    }
    if (!angles.empty()) return take(*angles.front(), "bending_angle", "deg", true);
    const bool markers = std::ranges::count(columns_, Quantity::position,
                                            [](const SeenColumn& each) { return each.words.quantity; }) > 1;
    for (SeenColumn& each : columns_)
      if (!markers && is_free(each)) {
        each.words.unit.clear();
        return take(each, "bending_angle", "deg", false);
      }
    std::vector<std::string> positions;
    for (const SeenColumn& each : columns_)
      if (each.words.quantity == Quantity::position) {
        positions.push_back(shown(each));
        used_.insert(each.source);
      }
    if (positions.size() < 2) {
      out_.asked.emplace_back("which column is the angle, in \"columns\"");
    } else if (positions.size() < 4) {
      out_.asked.push_back(fmt::format(
          "the place X, Y of the pivot in the picture, for \"markers\": {{\"bending_angle_deg\": {{\"line\": [[X, Y], "
          "[{}, {}]]}}}}, the angle of the line from there, with \"y\": \"up\" where y goes up (or the factors and "
          "offsets that make angles of {})",
          positions[0], positions[1], fmt::join(positions, " or ")));
    } else {
      const std::size_t last = positions.size() - 2;
      out_.asked.push_back(
          fmt::format("which markers make the angle: \"markers\": {{\"bending_angle_deg\": {{\"line\": [[{}, {}], [{}, "
                      "{}]]}}}} takes "
                      "the line between the first and the last",
                      positions[0], positions[1], positions[last], positions[last + 1]));
    }
  }

  // The interval or the rate that the lines above the names tell.
  void by_preamble() {
    constexpr std::array<std::pair<std::string_view, bool>, 7> keys = {{{"delta_x", true},
                                                                        {"sample interval", true},
                                                                        {"sampling interval", true},
                                                                        {"increment", true},
                                                                        {"sample rate", false},
                                                                        {"sampling rate", false},
                                                                        {"fps", false}}};
    std::vector<std::string> lines = form_.preamble;
    lines.insert(lines.end(), form_.names.begin(), form_.names.end());  // "Increment (2e-3)", as Rigol has it
    for (const std::string& line : lines) {
      std::string lower = line;
      std::ranges::transform(lower, lower.begin(), [](unsigned char letter) { return std::tolower(letter); });
      for (const auto& [key, interval] : keys) {
        const std::size_t at = lower.find(key);
        if (at == std::string::npos) continue;
        std::size_t start = lower.find_first_of("0123456789", at + key.size());
        if (start == std::string::npos) continue;
        std::string number = lower.substr(start, lower.find_first_not_of("0123456789.,e+-", start) - start);
        if (form_.separator == ',') number = number.substr(0, number.find(','));
        std::ranges::replace(number, ',', '.');
        const auto value = number_in(number);
        if (!value || *value <= 0.0) continue;
        out_.layout.sampling_rate = interval ? 1.0 / *value : *value;
        // 1/0.002 is 500, with all its digits.
        out_.layout.sampling_rate = std::round(*out_.layout.sampling_rate * 1e6) / 1e6;
        out_.guessed.push_back(
            fmt::format("the rows are {:.6g} a second: by the line {}", *out_.layout.sampling_rate, in_quotes(line)));
        return;
      }
    }
    out_.asked.emplace_back("the time: how many rows were taken a second, as \"sampling_rate_Hz\"");
  }

  // Of a quantity of which another column is taken: a setpoint, a second sensor.
  [[nodiscard]] bool is_another_reading(const SeenColumn& column) const {
    using enum Quantity;
    constexpr std::array readings = {current, voltage, torque, angle, force, temperature};
    return std::ranges::find(readings, column.words.quantity) != readings.end() && !column.words.by_unit &&
           std::ranges::any_of(columns_, [&](const SeenColumn& each) {
             return used_.contains(each.source) && each.words.quantity == column.words.quantity;
           });
  }

  void leave_others() {
    const bool by_position = std::ranges::any_of(
        out_.layout.columns, [](const CsvColumn& each) { return position_in(each.source).has_value(); });
    std::vector<std::string> others;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const bool nameless = form_.names[i].empty();
      if (form_.is_empty(i) || used_.contains(columns_[i].source) || (nameless && by_position)) continue;
      others.push_back(columns_[i].source);
      if (is_another_reading(columns_[i]))
        out_.guessed.push_back(fmt::format("{} is left alone: another column is taken for it", shown(columns_[i])));
    }
    if (others.size() > 4)
      out_.layout.ignore_others = true;
    else
      out_.layout.ignore = others;
  }

  const CsvForm& form_;
  TableContent content_;
  std::vector<SeenColumn> columns_;
  bool has_time_{false};
  std::set<std::string> used_;  // sources
  LayoutGuess out_;
};

}  // namespace

LayoutGuess guess_layout(const CsvForm& form, const TableContent& content) {
  return Guess(form, content).finish();
}

}  // namespace coilwright::formats
