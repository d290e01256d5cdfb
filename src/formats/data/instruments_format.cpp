#include "formats/data/instruments_format.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/formats/data/experiment_file.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/experiment_rules.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement::experiment;
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

void read_numbers(const Node& node, Instruments& instruments, double Instrument::*what) {
  read_object(node, [&](ObjectReader& in) {
    for (const InstrumentKey& each : instrument_keys)
      (instruments.*each.member).*what = in.quantity_or(each.key, 0.0, Rule::between(0.0, 1e6));
    return 0;
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
    for (const InstrumentKey& each : instrument_keys)
      if (const auto colour = in.find(each.key)) (instruments.*each.member).colour = read_colour(*colour);
    return 0;
  });
}

// One frequency, and its amplitude in each instrument.
void read_hum(const Node& node, Instruments& instruments) {
  read_object(node, [&](ObjectReader& in) {
    const double frequency = in.quantity("frequency_Hz", frequency_rule);
    for (const InstrumentKey& each : instrument_keys) {
      Instrument& instrument = instruments.*each.member;
      instrument.hum = in.quantity_or(each.key, 0.0, Rule::between(0.0, 1e6));
      instrument.hum_frequency = frequency;
    }
    return 0;
  });
}

// The share of samples that are off, and by how much: the smallest and the largest size of each instrument.
void read_outliers(const Node& node, Instruments& instruments) {
  read_object(node, [&](ObjectReader& in) {
    const double share = in.number("share", Rule::between(0.0, 1.0));
    for (const InstrumentKey& each : instrument_keys) {
      const auto sizes = in.find(each.key);
      if (!sizes) continue;
      const std::vector<double> range = sizes->quantities(Length::exactly(2), Rule::between(0.0, 1e6));
      if (range[1] < range[0]) throw sizes->error("must give the smallest size first");
      Instrument& instrument = instruments.*each.member;
      instrument.outlier_share = share;
      instrument.smallest_outlier = range[0];
      instrument.largest_outlier = range[1];
    }
    return 0;
  });
}

double read_input_noise(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    const std::string key = in.one_of({"current_A", "voltage_V", "torque_Nmm"});
    return in.quantity(key, Rule::between(0.0, 1e6));
  });
}

// One number of each instrument, where it is not 0; nothing if none has it.
void add_numbers(Json& out, const char* key, const Instruments& instruments, double Instrument::*what) {
  Json numbers = Json::object();
  bool any = false;
  for (const InstrumentKey& each : instrument_keys) {
    const double value = (instruments.*each.member).*what;
    if (value == 0.0) continue;
    numbers.set(std::string(each.key), units::from_si(value, each.key));
    any = true;
  }
  if (any) out.set(key, std::move(numbers));
}

void add_colours(Json& out, const Instruments& instruments) {
  using enum NoiseColour::Kind;
  Json colours = Json::object();
  bool any = false;
  for (const InstrumentKey& each : instrument_keys) {
    const NoiseColour& colour = (instruments.*each.member).colour;
    if (colour.kind == white) continue;
    any = true;
    Json of_one = Json::object({{"kind", colour.kind == low_pass ? "low_pass" : "one_over_f"}});
    if (colour.kind == low_pass) of_one.set("frequency_Hz", colour.frequency);
    colours.set(std::string(each.key), std::move(of_one));
  }
  if (any) out.set("noise_colour", std::move(colours));
}

// All instruments hum at one frequency.
void add_hum(Json& out, const Instruments& instruments) {
  Json hum = Json::object();
  bool any = false;
  for (const InstrumentKey& each : instrument_keys) {
    const Instrument& instrument = instruments.*each.member;
    if (instrument.hum == 0.0) continue;
    if (!any) hum.set("frequency_Hz", instrument.hum_frequency);
    any = true;
    hum.set(std::string(each.key), units::from_si(instrument.hum, each.key));
  }
  if (any) out.set("hum", std::move(hum));
}

// One share is that of all instruments that have outliers.
void add_outliers(Json& out, const Instruments& instruments) {
  Json outliers = Json::object();
  bool any = false;
  for (const InstrumentKey& each : instrument_keys) {
    const Instrument& instrument = instruments.*each.member;
    if (instrument.outlier_share == 0.0) continue;
    if (!any) outliers.set("share", instrument.outlier_share);
    any = true;
    Json sizes = Json::array();
    for (const double size : {instrument.smallest_outlier, instrument.largest_outlier})
      sizes.add(units::from_si(size, each.key));
    outliers.set(std::string(each.key), std::move(sizes));
  }
  if (any) out.set("outliers", std::move(outliers));
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
  add_colours(out, instruments);
  add_hum(out, instruments);
  add_outliers(out, instruments);
  if (instruments.input_noise == 0.0) return;
  const std::string key = drive == Drive::torque ? "torque_Nmm" : drive == Drive::voltage ? "voltage_V" : "current_A";
  out.set("input_noise", Json::object({{key, units::from_si(instruments.input_noise, key)}}));
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
  const Rule rule = Rule::between(0.0, 1e6);
  if (!rule.allows(value)) throw argument_error(argument, rule.text());
  (instruments.*(found->member)).noise = units::to_si(value, units::split_unit(found->key)->unit);
}

}  // namespace coilwright::formats
