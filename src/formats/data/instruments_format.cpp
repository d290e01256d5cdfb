#include "formats/data/experiment_parts.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/formats/data/experiment_file.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/simulation/plausible_ranges.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement::planning;
using measurement::data::Drive;

// What instruments are called in the file and on the command line.
struct InstrumentKey {
  std::string_view key;
  Instrument Instruments::*member;
};
constexpr std::array instrument_keys = {
    InstrumentKey{"angle_deg", &Instruments::angle}, InstrumentKey{"rate_deg_s", &Instruments::rate},
    InstrumentKey{"torque_Nmm", &Instruments::torque}, InstrumentKey{"force_N", &Instruments::force},
    InstrumentKey{"temperature_K", &Instruments::temperature}};

constexpr Rule reading_rule = Rule::between(0.0, 1e6);

void read_numbers(const Node& node, Instruments& instruments, double Instrument::*what) {
  read_object(node, [&](ObjectReader& in) {
    for (const auto& [key, member] : instrument_keys)
      (instruments.*member).*what = in.quantity_or(key, 0.0, reading_rule);
  });
}

NoiseColour read_colour(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    using enum NoiseColour::Kind;
    NoiseColour colour{.kind = in.choice<NoiseColour::Kind>(
                           "kind", {{"white", white}, {"low_pass", low_pass}, {"one_over_f", one_over_f}})};
    if (colour.kind == low_pass) colour.frequency = in.quantity("frequency_Hz", frequency_rule);
    return colour;
  });
}

void read_colours(const Node& node, Instruments& instruments) {
  read_object(node, [&](ObjectReader& in) {
    for (const auto& [key, member] : instrument_keys)
      if (const auto colour = in.find(key)) (instruments.*member).colour = read_colour(*colour);
  });
}

// One frequency, and its amplitude in each instrument.
void read_hum(const Node& node, Instruments& instruments) {
  read_object(node, [&](ObjectReader& in) {
    const double frequency = in.quantity("frequency_Hz", frequency_rule);
    for (const auto& [key, member] : instrument_keys) {
      (instruments.*member).hum = in.quantity_or(key, 0.0, reading_rule);
      (instruments.*member).hum_frequency = frequency;
    }
  });
}

// The share of samples that are off, and by how much: the smallest and the largest size of each instrument.
void read_outliers(const Node& node, Instruments& instruments) {
  read_object(node, [&](ObjectReader& in) {
    const double share = in.number("share", Rule::between(0.0, 1.0));
    for (const auto& [key, member] : instrument_keys) {
      const auto sizes = in.find(key);
      if (!sizes) continue;
      const std::vector<double> range = sizes->quantities(Length::exactly(2), reading_rule);
      if (range[1] < range[0]) throw sizes->error("must give the smallest size first");
      Instrument& instrument = instruments.*member;
      instrument.outlier_share = share;
      instrument.smallest_outlier = range[0];
      instrument.largest_outlier = range[1];
    }
  });
}

double read_input_noise(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    const std::string key = in.one_of({"current_A", "voltage_V", "torque_Nmm"});
    return in.quantity(key, reading_rule);
  });
}

// An object under `key` with what `of` says of each instrument, behind `first`; nothing where it says nothing of any.
template <class Of>
void add_each(Json& out, const char* key, const Instruments& instruments, std::vector<Json::Member> members, Of of) {
  const std::size_t of_all = members.size();
  for (const auto& [name, member] : instrument_keys)
    if (const std::optional<Json> value = of(instruments.*member, name)) members.emplace_back(name, *value);
  if (members.size() > of_all) out.set(key, Json::object(std::move(members)));
}

// One number of each instrument, where it is not 0.
void add_numbers(Json& out, const char* key, const Instruments& instruments, double Instrument::*what,
                 std::vector<Json::Member> first = {}) {
  add_each(out, key, instruments, std::move(first), [&](const Instrument& each, std::string_view name) {
    return each.*what == 0.0 ? std::nullopt : std::optional<Json>(units::from_si(each.*what, name));
  });
}

std::optional<Json> colour_json(const Instrument& instrument, std::string_view) {
  using enum NoiseColour::Kind;
  const NoiseColour& colour = instrument.colour;
  if (colour.kind == white) return std::nullopt;
  Json out = Json::object({{"kind", colour.kind == low_pass ? "low_pass" : "one_over_f"}});
  if (colour.kind == low_pass) out.set("frequency_Hz", colour.frequency);
  return out;
}

std::optional<Json> outlier_sizes(const Instrument& each, std::string_view name) {
  if (each.outlier_share == 0.0) return std::nullopt;
  return Json::array({units::from_si(each.smallest_outlier, name), units::from_si(each.largest_outlier, name)});
}

// What all instruments that have it have alike: that of the first.
double common(const Instruments& instruments, double Instrument::*has, double Instrument::*what) {
  for (const auto& [key, member] : instrument_keys)
    if ((instruments.*member).*has != 0.0) return (instruments.*member).*what;
  return 0.0;
}

}  // namespace

Instruments read_instruments(ObjectReader& in) {
  Instruments instruments;
  if (const auto noise = in.find("noise")) read_numbers(*noise, instruments, &Instrument::noise);
  if (const auto resolution = in.find("resolution")) read_numbers(*resolution, instruments, &Instrument::resolution);
  if (const auto colours = in.find("noise_colour")) read_colours(*colours, instruments);
  if (const auto hum = in.find("hum")) read_hum(*hum, instruments);
  if (const auto outliers = in.find("outliers")) read_outliers(*outliers, instruments);
  if (const auto noise = in.find("input_noise")) instruments.input_noise = read_input_noise(*noise);
  return instruments;
}

void add_instruments(Json& out, const Instruments& instruments, Drive drive) {
  add_numbers(out, "noise", instruments, &Instrument::noise);
  add_numbers(out, "resolution", instruments, &Instrument::resolution);
  add_each(out, "noise_colour", instruments, {}, colour_json);
  add_numbers(out, "hum", instruments, &Instrument::hum,
              {{"frequency_Hz", common(instruments, &Instrument::hum, &Instrument::hum_frequency)}});
  add_each(out, "outliers", instruments,
           {{"share", common(instruments, &Instrument::outlier_share, &Instrument::outlier_share)}}, outlier_sizes);
  if (instruments.input_noise == 0.0) return;
  const std::string key = drive == Drive::torque ? "torque_Nmm" : drive == Drive::voltage ? "voltage_V" : "current_A";
  out.set("input_noise", Json::object({{key, units::from_si(instruments.input_noise, key)}}));
}

Json instruments_json(const Instruments& instruments, double Instrument::*what) {
  Json out = Json::object();
  for (const auto& [key, member] : instrument_keys)
    out.set(std::string(key), units::from_si((instruments.*member).*what, key));
  return out;
}

void set_noise(Instruments& instruments, std::string_view argument) {
  const NameAndValue assignment = split_assignment(argument, argument, "angle_deg=0.3");
  const auto found = std::ranges::find(instrument_keys, assignment.name, &InstrumentKey::key);
  if (found == instrument_keys.end()) {
    std::vector<std::string> keys;
    for (const InstrumentKey& each : instrument_keys) keys.emplace_back(each.key);
    throw argument_error(argument, "is not a noise of an instrument" + did_you_mean(assignment.name, keys));
  }
  const double value = number_of(argument, assignment.value);
  if (!reading_rule.allows(value)) throw argument_error(argument, reading_rule.text());
  (instruments.*(found->member)).noise = units::to_si(value, units::split_unit(found->key)->unit);
}

}  // namespace coilwright::formats
